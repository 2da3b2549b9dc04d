#!/bin/sh
# check_book.sh BOOK - is the book whole, and does it fit on a phone?
#
# Every link and picture must lead to a file of the book, and to a place in it that
# exists; nothing may be fetched from elsewhere. If Chromium is there, every page is
# opened 390 pixels wide: it must not be wider than that, and there must be no message on the
# console. Then check_player.sh goes through the step players.
set -u
LC_ALL=C
export LC_ALL
book=${1:?usage: tools/book/check_book.sh BOOK}
here=$(cd "$(dirname "$0")" && pwd)
if ! cd "$book" || [ ! -f index.html ]; then
    echo "check_book: there is no book in $book; run make book" >&2
    exit 2
fi
scratch=$(cd .. && pwd)/book_check.$$
mkdir -p "$scratch" || exit 2
trap 'rm -rf "$scratch"' EXIT
trap 'exit 2' HUP INT TERM
passed=0
failed=0
report() { # SENTENCE FILE: the sentence holds if the file is empty
    if [ -s "$2" ]; then
        failed=$((failed + 1))
        echo "not ok - $1"
        sed 's/^/  /' "$2"
    else
        passed=$((passed + 1))
        echo "ok     - $1"
    fi
}

# ---- Links, without a browser. ---- #

find . -type f | sed 's|^\./||' | sort >"$scratch/files"
grep '\.html$' "$scratch/files" >"$scratch/pages"
# shellcheck disable=SC2046  # the names of the pages have no blanks
awk '
function simplify(path,   n, part, i, out) {
    while (sub(/[^\/]+\/\.\.\//, "", path)) ;
    gsub(/(^|\/)\.\//, "", path)
    return path
}
FILENAME ~ /\/files$/ { file[$0] = 1; next }
{
    rest = $0
    while (match(rest, /(href|src|id)="[^"]*"/)) {
        item = substr(rest, RSTART, RLENGTH)
        rest = substr(rest, RSTART + RLENGTH)
        value = item
        sub(/^[a-z]*="/, "", value)
        sub(/"$/, "", value)
        if (item ~ /^id/) { id[FILENAME "#" value] = 1; continue }
        if (item ~ /^href="[a-z]+:/ && item !~ /stylesheet/) continue
        if (value ~ /^[a-z]+:/) { print FILENAME ": fetches " value; continue }
        folder = FILENAME
        sub(/[^\/]*$/, "", folder)
        target = value ~ /^#/ ? FILENAME value : simplify(folder value)
        link[target] = FILENAME
    }
}
END {
    for (target in link) {
        path = target
        sub(/#.*/, "", path)
        if (!(path in file)) print link[target] ": there is no " path
        else if (path != target && !(target in id)) print link[target] ": no place " target
    }
}' "$scratch/files" $(cat "$scratch/pages") | sort >"$scratch/broken"
report "the links of $(wc -l <"$scratch/pages") pages lead somewhere" "$scratch/broken"

# What pandoc cannot write as MathML it leaves as it is, in an element of this class.
# shellcheck disable=SC2046
grep -l 'class="math' $(cat "$scratch/pages") >"$scratch/formulas"
# shellcheck disable=SC2046
grep -l '<math' $(cat "$scratch/pages") >"$scratch/with"
grep -L '<math' chapters/*/index.html | sed 's/$/: has no formula/' >>"$scratch/formulas"
# A dollar that is left is the end of a formula that was not taken for one.
grep -no '.\{0,30\}[$].\{0,30\}' chapters/*/index.html >>"$scratch/formulas"
report "the formulas on $(wc -l <"$scratch/with") pages are MathML" "$scratch/formulas"

# ---- Width and console, in a browser. ---- #

browser=
for name in chromium chromium-browser google-chrome; do
    [ -n "$browser" ] || browser=$(command -v $name)
done
if [ -z "$browser" ]; then
    echo "skipped - no page was opened: install the package chromium"
else
    {
        echo '<script>const pages = ['
        sed 's/.*/"&",/' "$scratch/pages"
        echo "], book = \"file://$PWD/\";"
        cat "$here/measure.js"
        echo '</script>'
    } >"$scratch/measure.html"
    "$browser" --headless --no-sandbox --disable-gpu --user-data-dir="$scratch/profile" \
        --no-first-run --disable-background-networking --disable-component-update \
        --disable-sync --allow-file-access-from-files --enable-logging=stderr \
        --virtual-time-budget=100000 --dump-dom "file://$scratch/measure.html" \
        >"$scratch/dom" 2>"$scratch/log"
    grep 'CONSOLE[(:]' "$scratch/log" >"$scratch/console"
    sed -n 's/^wide: //p' "$scratch/dom" >"$scratch/wide"
    grep -q "^measured: $(wc -l <"$scratch/pages")\$" "$scratch/dom" ||
        echo "not all pages could be opened" >>"$scratch/wide"
    report "every page is at most 390 pixels wide on a phone" "$scratch/wide"
    report "no page writes to the console" "$scratch/console"

    "$here/check_player.sh" .. "$browser" >"$scratch/players"
    grep -v ' passed, ' "$scratch/players"
    counts=$(grep ' passed, ' "$scratch/players" || echo "0 passed, 1 failed")
    passed=$((passed + ${counts%% *}))
    counts=${counts#*, }
    failed=$((failed + ${counts%% *}))
fi

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
