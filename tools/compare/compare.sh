#!/bin/sh
# compare.sh BUILD - the comparison of section 3.7, again: `make compare` runs it.
#
# First the questions are counted. They are the same on every machine, so the table is
# part of the project: chapters/3.7_divide_and_conquer/comparison.csv is written anew,
# and `make figures` draws its pictures. Then the times are measured, as multiples of the
# time that sorting the same points takes: a table and a picture in BUILD/compare. Both
# are printed as the page shows them.
#
# The environment may say COMPARE_TIMES=no (only count), and COMPARE_MOST: no more
# points than these are timed (262144).
set -eu

if [ $# -ne 1 ]; then
    echo "usage: tools/compare/compare.sh BUILD" >&2
    exit 2
fi
compare=$1/compare
table=chapters/3.7_divide_and_conquer/comparison.csv

echo "counting questions"
"$compare/counts" >"$compare/counts.csv"
if cmp -s "$compare/counts.csv" "$table"; then
    echo "$table is what it was"
else
    cp "$compare/counts.csv" "$table"
    echo "$table has changed: run make figures, and correct the page"
fi
awk -F, '
$1 == "uniform" && $2 == 131072 {
    printf "| %s | uniform | %.1f | %.1f | %.1f |\n", $3, $4 / $2, $5 / $2, $6 / $2
}' "$table"

[ "${COMPARE_TIMES-yes}" = no ] && exit
echo "measuring times"
"$compare/times" "$compare" "${COMPARE_MOST-262144}" >/dev/null
awk -F, '
NR > 1 { n = n < $2 ? $2 : n }
NR > 1 && !($1 in of) { of[$1] = ++distributions; head = head " " $1 " |" }
NR > 1 && !($3 in row) { row[$3] = ++rows; name[rows] = $3 }
NR > 1 { ratio[$3, $1, $2] = $6 }
END {
    split(head, d, / \|/)
    print n " points\n| |" head
    for (i = 1; i <= rows; i++) {
        line = "| " name[i] " |"
        for (k = 1; k <= distributions; k++) {
            sub(/^ /, "", d[k])
            cell = ratio[name[i], d[k], n]
            line = line " " (cell == "" ? "-" : cell) " |"
        }
        print line
    }
}' "$compare/times.csv"
echo "the times themselves: $compare/times.csv, drawn: $compare/times.svg"
