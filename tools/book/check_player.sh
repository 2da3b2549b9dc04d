#!/bin/sh
# check_player.sh BUILD BROWSER - do the step players of the book show what is so?
#
# Makes a page with the players of all pages, and with others of points with which pictures
# could go wrong: few, many at one place, in line, on a circle, huge, tiny. On this page
# check_player.js presses all buttons. What a player has to show in the end is told by
# `tri triangulate`, which knows nothing of steps. check_book.sh runs this.
set -u
LC_ALL=C
export LC_ALL
build=$(cd "${1:?usage: tools/book/check_player.sh BUILD BROWSER}" && pwd)
browser=${2:?usage: tools/book/check_player.sh BUILD BROWSER}
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
tri=$build/tri
scratch=$build/player_check.$$
mkdir -p "$scratch/points" || exit 2
trap 'rm -rf "$scratch"' EXIT
trap 'exit 2' HUP INT TERM
cd "$root" || exit 2

# ---- Points. ---- #

for n in 0 1 2 3 30; do
    "$tri" generate uniform $n -o "$scratch/points/uniform$n.node"
done
"$tri" generate collinear 6 -o "$scratch/points/collinear.node"
"$tri" generate grid 16 -o "$scratch/points/grid.node"
points() { # NAME X,Y...
    name=$1
    shift
    printf '%s\n' "$@" | tr , ' ' >"$scratch/points/$name.xy"
}
points copies 3,1 0,0 3,1 5,4 0,0 3,1 1,4
points one_place 3,1 3,1 3,1
points huge 1e300,0 -1e300,1e300 0,-1e300 1e299,2e299
points largest 1.7e308,0 -1.7e308,1.7e308 0,-1.7e308 0,0
points tiny 1e-300,0 -1e-300,1e-300 0,-1e-300 0,0
points smallest 5e-324,0 0,5e-324 0,0 1e-323,1e-323
points mixed 1e300,0 1e-300,1 -1e-300,-1 0,1e300
points far_away 1e16,1 10000000000000002,2 1e16,3 10000000000000004,1

# ---- Players. ---- #

# The edges "a-b" that the program tri finds: those of a tree, if there are no triangles.
edges_of() { # ARGUMENTS POINTS
    # shellcheck disable=SC2086 # the arguments are words without blanks
    "$tri" triangulate $1 "$2" -o "$scratch/found.ele" 2>/dev/null
    if [ "$(awk 'NR == 1 { print $1 }' "$scratch/found.ele")" = 0 ]; then
        "$tri" emst "$2" 2>/dev/null | awk 'NR > 1 && !/^#/ { print $2, $3 }'
    else
        awk 'NR > 1 && !/^#/ { print $2, $3; print $3, $4; print $4, $2 }' "$scratch/found.ele"
    fi | awk '{ print ($1 < $2 ? $1 "-" $2 : $2 "-" $1) }' | sort -u | tr '\n' ' '
}

player() { # ARGUMENTS POINTS
    printf '<div class="player" data-name="%s" data-edges="%s">\n' "$1 ${2##*/}" \
        "$(edges_of "$1" "$2")"
    echo '<script type="application/json">'
    # shellcheck disable=SC2086
    "$tri" trace $1 "$2" 2>/dev/null
    echo '</script></div>'
}

all_players() {
    sed -n 's/^<!-- player: \(.*\) \([^ ]*\) -->$/\1 \2/p' chapters/*/README.md |
        while read -r arguments; do
            player "${arguments% *}" "${arguments##* }"
        done
    for file in "$scratch"/points/*; do
        for algorithm in sweep lawson incremental divide; do
            player "--algorithm $algorithm" "$file"
        done
        player "--algorithm incremental --locator walk" "$file"
    done
}

{
    echo '<!DOCTYPE html><meta charset="utf-8"><style>'
    cat "$here/book.css" "$here/player.css"
    echo '</style>'
    all_players
    echo '<script>const book = "'"file://$build/book/"'", pages = ['
    grep -l '^<!-- player: ' chapters/*/README.md | sed 's|\(.*\)README.md|"\1index.html",|'
    echo '];</script>'
    for script in steps picture player check_player; do
        echo '<script>'
        cat "$here/$script.js"
        echo '</script>'
    done
} >"$scratch/players.html"

# ---- The browser, and what it has seen. ---- #

"$browser" --headless --no-sandbox --disable-gpu --user-data-dir="$scratch/profile" \
    --no-first-run --disable-background-networking --disable-component-update \
    --disable-sync --allow-file-access-from-files --enable-logging=stderr \
    --virtual-time-budget=1000000 --dump-dom "file://$scratch/players.html" \
    >"$scratch/dom" 2>"$scratch/log"
sed -n '/^ok  /p; /^not ok/,/^  /p' "$scratch/dom"
passed=$(grep -c '^ok  ' "$scratch/dom")
failed=$(grep -c '^not ok' "$scratch/dom")
if ! grep -q '^players were checked$' "$scratch/dom" || grep 'CONSOLE[(:]' "$scratch/log"; then
    echo "not ok - the players could be checked to the end, and write nothing to the console"
    failed=$((failed + 1))
fi
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
