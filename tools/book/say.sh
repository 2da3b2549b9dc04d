#!/bin/sh
# say.sh BUILD [--check] - the steps that the pages show, as text: `make weave` runs it.
#
# Where a page has a line
#
#     <!-- player: --algorithm lawson chapters/3.5_edge_flips/watch.xy -->
#
# the book shows what `tri trace` says for these arguments, to go through step by step
# (tools/book/player.js). For those who read the page elsewhere, or without JavaScript,
# the same steps stand below the line in a list, which is written here. With --check
# nothing is changed, and a list that is not what the algorithm does is named.
set -eu
LC_ALL=C
export LC_ALL
build=${1:?usage: tools/book/say.sh BUILD [--check], in the root of the project}
check=${2:-}
scratch=$build/say.$$
mkdir -p "$scratch"
trap 'rm -rf "$scratch"' EXIT
trap 'exit 2' HUP INT TERM

# The page with its lists written anew.
with_steps() {
    awk -v tri="$build/tri" '
    function unquoted(s) { gsub(/\\"/, "\"", s); return s }

    # The value of "name" in the text that is left; what follows it is left then.
    function take(name,   at, value) {
        at = match(rest, "\"" name "\": *\"([^\"\\\\]|\\\\.)*\"")
        if (at == 0) return ""
        value = substr(rest, RSTART, RLENGTH)
        rest = substr(rest, RSTART + RLENGTH)
        sub("^\"" name "\": *\"", "", value)
        return unquoted(substr(value, 1, length(value) - 1))
    }

    function write_steps(arguments,   command, text, n, list, line, i) {
        command = tri " trace " arguments
        rest = ""
        while ((command | getline text) > 0) rest = rest text
        if (close(command) != 0) {
            print FILENAME ":" FNR ": tri trace cannot do this" >"/dev/stderr"
            exit failed = 1
        }
        rest = substr(rest, index(rest, "\"steps\""))
        for (n = 0; rest ~ /"say"/; n++) {
            line = take("line")
            list[n] = (line == "" ? "" : line ": ") take("say")
        }
        print "\n<details><summary>The " n " steps as text</summary>\n"
        for (i = 0; i < n; i++) print i + 1 ". " list[i]
        print "\n</details>"
    }

    # The old list goes: the empty lines after the address, and what stands in <details>.
    old && /^$/ { next }
    old && /^<details><summary>The [0-9]+ steps/ { inside = 1 }
    old && inside { if (/^<\/details>$/) old = inside = 0; next }
    old { old = 0; print "" }

    { print }
    /^<!-- player: .* -->$/ {
        arguments = $0
        gsub(/^<!-- player: | -->$/, "", arguments)
        write_steps(arguments)
        old = 1
    }
    END { exit failed }' "$1"
}

status=0
for page in chapters/*/README.md; do
    grep -q '^<!-- player: ' "$page" || continue
    with_steps "$page" >"$scratch/page" || exit 2
    cmp -s "$scratch/page" "$page" && continue
    if [ "$check" = --check ]; then
        line=$(cmp "$scratch/page" "$page" 2>&1 | sed 's/.*line //')
        echo "$page:$line: the algorithm does something else; run make weave"
        status=1
    else
        cp "$scratch/page" "$page.new"
        mv "$page.new" "$page"
        echo "refreshed $page"
    fi
done
exit $status
