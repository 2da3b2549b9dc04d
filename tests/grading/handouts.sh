#!/bin/sh
# handouts.sh BUILD - the handout of each week keeps its promises.
#
# tools/handout sees to that itself: untouched it scores 0, with the reference put back
# all points, and nothing of a solution is left. Prints a line for each week, and fails
# if one is refused, or if a section has no checker.
set -u
build=${1:?usage: tests/grading/handouts.sh BUILD, in the root of the project}
tree=$build/handouts.tree
status=0

weeks=$(sed -n 's/^\[\(W[0-9]*\)\]$/\1/p' docs/assignments.ini)
for week in $weeks; do
    rm -rf "$tree"
    if "$build/handout" "$week" -o "$tree" >"$build/handouts.txt" 2>&1 &&
        ! grep -q 'no check' "$build/handouts.txt"
    then
        echo "ok     - $week"
    else
        echo "not ok - $week"
        sed 's/^/  /' "$build/handouts.txt"
        status=1
    fi
done
rm -rf "$tree"
exit $status
