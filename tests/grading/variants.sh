#!/bin/sh
# variants.sh BUILD - each variant can be solved: a solution of it gets all points.
#
# A solution is the reference's with one line changed, in a handout of the variant. That
# the reference itself does not solve it has been seen when the handout was made, unless
# there is no time: QUICK=1. Prints a line for each, and fails if one is not right.
set -u
unset MAKEFLAGS MFLAGS MAKELEVEL BUILD CFLAGS
build=${1:?usage: tests/grading/variants.sh BUILD, in the root of the project}
tree=$build/variants.tree
status=0

# EXERCISE VARIANT FILE SED-SCRIPT
try() {
    rm -rf "$tree"
    if "$build/handout" ${QUICK:+--no-proof} "$1" --variant "$2" -o "$tree" \
        >"$build/variants.txt" 2>&1 &&
        sed "$4" "$3" >"$tree/$3" && ! cmp -s "$3" "$tree/$3" &&
        (cd "$tree" && make -s CFLAGS=-O0 check EX="$1") >>"$build/variants.txt" 2>&1
    then
        echo "ok     - $1 $2"
    else
        echo "not ok - $1 $2"
        sed 's/^/  /' "$build/variants.txt"
        status=1
    fi
}

# In the tree of the last variant: EXERCISE FILE SED-SCRIPT WORDS. A wrong solution, which
# fails, and is told why in these words.
refuse() {
    sed "$3" "$2" >"$tree/$2"
    if ! (cd "$tree" && make -s CFLAGS=-O0 check EX="$1") >"$build/variants.txt" 2>&1 &&
        grep -qF -- "$4" "$build/variants.txt"
    then
        echo "ok     - $1: $4"
    else
        echo "not ok - $1: $4"
        sed 's/^/  /' "$build/variants.txt"
        status=1
    fi
}

sweep=chapters/2.3_line_sweep/sweep.c
circle=chapters/3.2_empty_circumcircle/empty_circle.c
tree_of=chapters/3.2_empty_circumcircle/emst.c
exact=chapters/3.4_primitives/exact.c
flips=chapters/3.5_edge_flips/flips.c
try 2.3-a from-right $sweep '/^merge_runs/,/^}/s/<= 0/>= 0/'
try 2.3-d clockwise $sweep '/^hull_vertices/,/^}/{
    s/e = mesh_hull_next(m, e);/e = path ? mesh_hull_next(m, e) : mesh_hull_prev(m, e);/
}'
try 3.4-a y-down $exact '/^answer/,/^}/s/return sign/return -sign/'
try 3.4-b y-down $exact '/^answer/,/^}/s/return sign/return -sign/'
try 3.2-a clockwise $circle '/^append_triangle/,/^}/{
    s/corner\[1\] = b/corner[1] = c/
    s/corner\[2\] = c/corner[2] = b/
}'
try 3.2-a farthest $circle '/^has_empty_circle/,/^}/s/> 0/< 0/'
try 3.2-b metric $tree_of '/^emst/,/^{/s/^{/{\
    point2 *scaled = memory_array(m->points, sizeof *scaled);\
    for (uint32_t i = 0; i < m->points; i++)\
        scaled[i] = (point2){points[i].x, 2 * points[i].y};\
    points = scaled;/'
first='/^edge_stack_pop/,/^}/{
    s/\*ab = L->entry\[--L->size\];/*ab = L->entry[0];\
    L->size--;\
    for (uint32_t i = 0; i < L->size; i++)\
        L->entry[i] = L->entry[i + 1];/
}'
try 3.5-c queue $flips "$first"
refuse 3.5-c $flips '' 'has waited longer than the one popped'
refuse 3.5-c $flips "$first
/^push_link/,/^}/s/edge_stack_push(L, mesh_prev(dc));//" 'does not wait after a flip beside it'
rm -rf "$tree"
exit $status
