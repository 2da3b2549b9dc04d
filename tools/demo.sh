#!/bin/sh
# Triangulates the real points of docs/data with every algorithm, certifies each
# result, prints a table and leaves pictures.
#
# usage: tools/demo.sh BUILD
set -eu
build=${1:-build}
tri=$build/tri
counted=$build/counted/tri
mkdir -p "$build/demo"
refuted=0

# The rows of the table of algorithms: name, section, kind, summary.
algorithms=$("$tri" help triangulate |
    awk '$2 ~ /^[0-9]+\.[0-9]+$/ && !/slow beyond/ { print $1 "=" $3 }')

row='%-10s %-11s %7s %5s %9s %7s %9s %9s %8s  %s\n'
# shellcheck disable=SC2059 # the format of every row is the same
printf "$row" data algorithm points hull triangles flips orient2d incircle \
    "sorting*" certificate
for points in docs/data/*.csv docs/data/*.node; do
    name=$(basename "$points" | sed 's/\.[a-z]*$//')
    for algorithm in $algorithms; do
        kind=${algorithm#*=}
        algorithm=${algorithm%=*}
        out=$build/demo/$name-$algorithm
        "$tri" triangulate --algorithm "$algorithm" -o "$out.ele" \
            --svg "$out.svg" "$points"
        "$counted" triangulate --algorithm "$algorithm" --stats "$points" \
            > "$out.stats"
        ratio=$("$tri" triangulate --algorithm "$algorithm" --stats "$points" |
            awk '$1 == "ratio" { print $2 }')
        flag=
        if [ "$kind" = Delaunay ]; then
            flag=--delaunay
        fi
        # shellcheck disable=SC2086 # without a flag there is no word
        if "$tri" check $flag "$points" "$out.ele" > "$out.check"; then
            certificate="holds: $kind"
        else
            certificate="REFUTED: $kind"
            refuted=$((refuted + 1))
        fi
        awk -v row="$row" -v name="$name" -v algorithm="$algorithm" \
            -v ratio="$ratio" -v certificate="$certificate" '
            { value[$1] = $2 }
            END {
                printf row, name, algorithm, value["points"], value["hull"],
                       value["triangles"], value["flips"], value["orient2d"],
                       value["incircle"], ratio, certificate
            }' "$out.stats"
    done
done
echo "* the time, as a multiple of sorting the points by (x,y)"
echo "pictures: $build/demo/"
if [ "$refuted" -gt 0 ]; then
    cat "$build"/demo/*.check
    exit 1
fi
