#!/bin/sh
# run_sizes.sh BUILD - large inputs, certified, each within 30 s of processor time.
#
# Every row of the table below is a test: BUILD/tri generates so many points of the
# distribution and triangulates them, within the limit, and `tri check` certifies the
# triangles. Prints a line for each: the seconds of the whole program, reading and
# writing included. Ends with "N passed, N failed".
set -u

seconds=30

# Of lawson's n^1.5 flips on a grid and n^2 on a parabola or a spiral fewer points are
# enough; so they are for a walk that begins far away.
table() {
    cat <<'END'
1000000 sweep       -        uniform normal clusters grid circle kuzmin near-line
1000000 sweep       -        collinear parabola ladder spiral
1000000 incremental -        uniform normal clusters grid circle kuzmin near-line
1000000 incremental -        collinear parabola ladder spiral
1000000 biased      -        uniform normal clusters grid circle kuzmin near-line
1000000 biased      -        collinear parabola ladder spiral
1000000 incremental history  uniform clusters kuzmin
 100000 incremental walk     uniform kuzmin
1000000 lawson      -        uniform normal clusters circle kuzmin near-line
 100000 lawson      -        grid spiral
1000000 fast        -        uniform normal clusters grid circle kuzmin near-line
1000000 fast        -        collinear parabola ladder spiral
  10000 lawson      -        parabola
END
}

# try_size N ALGORITHM LOCATOR DISTRIBUTION; LOCATOR is - for the default
try_size() {
    name="$2 $4 $1"
    options="--algorithm $2"
    kind=--delaunay
    if [ "$2" = sweep ]; then
        kind=
    fi
    if [ "$3" != - ]; then
        name="$2/$3 $4 $1"
        options="$options --locator $3"
    fi
    # shellcheck disable=SC2086 # two options or four; one or none
    if ! "$tri" generate "$4" "$1" -o "$points"; then
        echo "not ok - $name: no points"
    elif ! (
        # shellcheck disable=SC3045 # every sh has -t, and POSIX since 2024
        ulimit -t "$seconds"
        "$tri" triangulate $options -o "$triangles" "$points"
        status=$?
        times >"$took"
        exit $status
    ) >"$log" 2>&1; then
        echo "not ok - $name: more than $seconds s, or: $(cat "$log")"
    elif ! "$tri" check $kind "$points" "$triangles" >"$log" 2>&1; then
        echo "not ok - $name: $(cat "$log")"
    else
        # The second line of `times` is what its children have used: 0m1.23s 0m0.04s.
        awk -v name="$name" 'NR == 2 {
            split($1, user, "m")
            split($2, kernel, "m")
            printf "ok     - %-36s %6.1f s\n", name,
                60 * user[1] + user[2] + 60 * kernel[1] + kernel[2]
        }' "$took"
    fi
}

if [ $# -ne 1 ]; then
    echo "usage: tests/run_sizes.sh BUILD" >&2
    exit 2
fi
tri=$1/tri
folder=$1/sizes
mkdir -p "$folder"
points=$folder/points.node
triangles=$folder/triangles.ele
took=$folder/took.txt
log=$folder/log.txt

table | while read -r n algorithm locator distributions; do
    for distribution in $distributions; do
        try_size "$n" "$algorithm" "$locator" "$distribution"
    done
done | tee "$folder.txt"
rm -rf "$folder"
awk '
/^ok /     { passed++ }
/^not ok / { failed++ }
END {
    printf "%d passed, %d failed\n", passed, failed
    exit failed > 0 || passed == 0
}' "$folder.txt"
