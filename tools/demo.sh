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

# The rows of the table of algorithms: name, section, kind, summary. Twenty times the
# points beyond which one is slow take it a second or two.
algorithms=$("$tri" help triangulate | awk '
    $2 ~ /^[0-9]+\.[0-9]+$/ {
        most = 1000000000
        if (match($0, /slow beyond [0-9]+/))
            most = 20 * substr($0, RSTART + 12, RLENGTH - 12)
        print $1 "=" $3 "=" most
    }')

# row NAME ALGORITHM STATS CERTIFICATE: a row of the table. STATS has what --stats says:
# first the counting program, then the plain one, which has the right times.
row() {
    printf '%-10s %-11s ' "$1" "$2"
    awk '
        { value[$1] = $2 }
        END {
            printf "%6s %4s %9s %7s %8s %8s %13s %8s", value["points"], value["hull"],
                   value["triangles"], value["flips"], value["orient2d"],
                   value["incircle"], value["compare_along"], value["ratio"]
        }' "$3"
    printf '  %s\n' "$4"
}

names='points hull triangles flips orient2d incircle compare_along ratio'
for name in $names; do
    echo "$name $name"
done | sed 's/ratio$/sorting*/' >"$build/demo/names"
row data algorithm "$build/demo/names" certificate
for points in docs/data/*.csv docs/data/*.node; do
    name=$(basename "$points" | sed 's/\.[a-z]*$//')
    n=$("$tri" triangulate --algorithm sweep --stats "$points" |
        awk '$1 == "points" { print $2 }')
    for algorithm in $algorithms; do
        most=${algorithm##*=}
        kind=${algorithm#*=}
        kind=${kind%=*}
        algorithm=${algorithm%%=*}
        if [ "$n" -gt "$most" ]; then
            row "$name" "$algorithm" /dev/null "- (too slow for $n points)"
            continue
        fi
        out=$build/demo/$name-$algorithm
        "$tri" triangulate --algorithm "$algorithm" -o "$out.ele" --svg "$out.svg" \
            "$points"
        "$counted" triangulate --algorithm "$algorithm" --stats "$points" >"$out.stats"
        "$tri" triangulate --algorithm "$algorithm" --stats "$points" >>"$out.stats"
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
        row "$name" "$algorithm" "$out.stats" "$certificate"
    done
done
echo "* the time, as a multiple of sorting the points by (x,y)"
cat "$build"/demo/*.stats | awk '
    $1 == "orient3d" || $1 == "compare_distance" || $1 == "dot_sign" { asked += $2 }
    END { print "orient3d, compare_distance and dot_sign were asked " asked " times" }'
echo "pictures: $build/demo/"
if [ "$refuted" -gt 0 ]; then
    cat "$build"/demo/*.check
    exit 1
fi
