#!/bin/sh
# compare.sh BUILD - the comparison of section 3.7, again: `make compare` runs it.
#
# First the questions are counted. They are the same on every machine, so the table is
# part of the project: chapters/3.7_divide_and_conquer/comparison.csv is written anew,
# and `make figures` draws its pictures. Then the times are measured, as multiples of
# the time that sorting the same points takes: a table and a picture in BUILD/compare.
# Both are printed as the page shows them.
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
NR > 1 {
    least = NR == 2 || $2 < least ? $2 : least
    most = $2 > most ? $2 : most
    if (!($1 in seen)) of[++distributions] = $1
    if (!($3 in seen)) who[++rows] = $3
    seen[$1]; seen[$3]
    ratio[$3, $1, $2] = $6
}
function cells(i, n,   k, line, at) { # "-": not tried, or given up
    for (k = 1; k <= distributions; k++) {
        at = who[i] SUBSEP of[k] SUBSEP n
        line = line " " (at in ratio ? ratio[at] : "-") " |"
    }
    return line
}
function table(n,   i, head) {
    for (i = 1; i <= distributions; i++) head = head " " of[i] " |"
    print "| " n " points |" head
    gsub(/[a-z-]+/, "---", head)
    print "|---|" head
    for (i = 1; i <= rows; i++) print "| " who[i] " |" cells(i, n)
}
END { table(least); table(most) }' "$compare/times.csv"
echo "the times themselves: $compare/times.csv, drawn: $compare/times.svg"
