#!/bin/sh
# book.sh BUILD - the pages as a static HTML book in BUILD/book: `make book` runs it.
#
# The book has the folders of the project. A page README.md becomes index.html, docs/X.md
# becomes docs/X.html, and a source that some page quotes or links to becomes a listing
# with numbered lines, sweep.c.html. Nothing is fetched from anywhere. tools/book/ holds
# the template, the style, and what pandoc has to do to each page.
set -eu
LC_ALL=C.UTF-8
export LC_ALL
build=${1:?usage: tools/book.sh BUILD, in the root of the project}
if ! command -v pandoc >/dev/null 2>&1; then
    echo "book: pandoc is missing; install the package pandoc" >&2
    exit 1
fi

pages="README.md chapters/README.md $(echo chapters/[0-9]*/README.md)
       docs/notes_map.md docs/errata.md docs/glossary.md docs/references.md
       docs/conventions.md docs/grading.md docs/performance.md docs/trace.md"
book=$build/book.new
rm -rf "$book"
mkdir -p "$book"
cp tools/book/book.css tools/book/player.css "$book"
cp tools/book/steps.js tools/book/picture.js tools/book/player.js "$book"
QUOTES=$book/quotes LINKED=$book/linked TRI=$build/tri
export QUOTES LINKED TRI
"$build/weave" --list >"$QUOTES"
: >"$LINKED"

output_of() {
    case $1 in
    README.md) echo index.html ;;
    */README.md) echo "${1%README.md}index.html" ;;
    *.md) echo "${1%.md}.html" ;;
    *) echo "$1.html" ;;
    esac
}

# From the folder of a file up to the root: chapters/x/y.c -> ../../
root_of() {
    echo "$1" | sed 's|[^/]*$||; s|[^/]*/|../|g'
}

title_of() {
    sed -n '/^# /{s/^# //;p;q;}' "$1"
}

# The list of all pages, as seen from one of them.
contents_of() {
    echo '<ul>'
    for page in $pages; do
        class=
        [ "$page" = "$1" ] && class=' class="here"'
        title=$(title_of "$page")
        [ "$page" = README.md ] && title="Beginning"
        [ "$page" = docs/notes_map.md ] && echo '</ul><h2>Documents</h2><ul>'
        echo "<li><a$class href=\"$(root_of "$1")$(output_of "$page")\">$title</a></li>"
    done
    echo '</ul>'
}

# The pages before and after one of them.
turn_of() {
    previous='' found=''
    for page in $pages; do
        if [ -n "$found" ]; then
            echo "<a href=\"$2$(output_of "$page")\">$(title_of "$page") →</a>"
            return
        fi
        if [ "$page" = "$1" ]; then
            found=1
            [ -z "$previous" ] || previous=$(printf '<a href="%s%s">← %s</a>' "$2" \
                "$(output_of "$previous")" "$(title_of "$previous")")
            echo "<span>$previous</span>"
        else
            previous=$page
        fi
    done
}

# to_html FILE KIND MARKDOWN OPTION...: the Markdown becomes the page of FILE.
to_html() {
    file=$1 kind=$2 markdown=$3
    shift 3
    root=$(root_of "$file")
    mkdir -p "$book/$(dirname "$file")"
    pandoc --from gfm+tex_math_dollars+attributes --to html5 --mathml \
        --template tools/book/page.html --variable "root=$root" --variable "kind=$kind" \
        --variable "contents=$(contents_of "$file")" "$@" \
        --output "$book/$(output_of "$file")" "$markdown"
}

for page in $pages; do
    root=$(root_of "$page")
    PAGE=$page
    export PAGE
    toc=--toc
    grep -q '^## ' "$page" || toc=
    player=--variable=player
    grep -q '^<!-- player: ' "$page" || player=
    to_html "$page" page "$page" --lua-filter tools/book/page.lua $toc --toc-depth 2 $player \
        --metadata "pagetitle=$(title_of "$page")" \
        --variable "turn=$(turn_of "$page" "$root")"
done

# A listing is Markdown too: a title, and one block that contains the source.
sort -u "$LINKED" | while read -r source; do
    case $source in
    *.c | *.h) language=c ;;
    *.sh) language=bash ;;
    *.ini) language=ini ;;
    *) language=default ;;
    esac
    {
        printf '# %s\n\n``````{#line .%s .numberSource}\n' "$source" "$language"
        cat "$source"
        printf '``````\n'
    } | to_html "$source" listing - --metadata "pagetitle=$source"
done

for folder in chapters/*/figures; do
    [ -d "$folder" ] || continue
    cp -R "$folder" "$book/${folder%/*}"
done
rm "$QUOTES" "$LINKED"
rm -rf "$build/book"
mv "$book" "$build/book"
echo "$build/book/index.html"
