#!/bin/sh
# programs.sh BUILD - how long do whole programs take, compared with sorting the points?
#
# The yardstick is `LC_ALL=C sort --parallel=1 -n` on a file of uniform points, one "x y"
# a line: a program that everybody has, which reads, compares and writes the same lines.
# Whole programs are compared, the reading and writing of text included. They take turns,
# A B A B, so that a machine that becomes slower is slower for both; what counts is the
# processor time, user and system, that each has used.
#
# Prints a table, and writes it to BUILD/bench/programs.csv. The environment may say
# BENCH_POINTS (1000000), BENCH_RUNS (5) and BENCH_SECONDS (30), after which an algorithm
# is given up: some take quadratic time, or nearly.
set -eu

if [ $# -ne 1 ]; then
    echo "usage: tools/bench/programs.sh BUILD" >&2
    exit 2
fi
tri=$1/tri
bench=$1/bench
count=${BENCH_POINTS-1000000}
runs=${BENCH_RUNS-5}
limit=${BENCH_SECONDS-30}

if ! LC_ALL=C sort --parallel=1 -n /dev/null 2>/dev/null; then
    echo "programs.sh: needs GNU sort, with the option --parallel" >&2
    exit 2
fi
# shellcheck disable=SC3045 # not in POSIX; asked for here
if ! (ulimit -t "$limit") 2>/dev/null; then
    echo "programs.sh: needs a shell with ulimit -t, such as dash or bash" >&2
    exit 2
fi
mkdir -p "$bench"
points=$bench/points.xy
"$tri" generate uniform "$count" | awk 'NR > 1 { print $2, $3 }' >"$points"

# Runs a command, and adds its processor time in seconds to the file $1; the status is
# the command's. The second line of `times` is that of the programs a shell has started.
measure() {
    into=$1
    shift
    # shellcheck disable=SC3045
    (
        ulimit -t "$limit"
        "$@" >"$bench/said" 2>&1 || exit
        times >"$bench/times"
    ) 2>/dev/null || return
    awk 'NR == 2 {
        gsub(/[ms]/, " ")
        printf "%.3f\n", 60 * ($1 + $3) + $2 + $4
    }' "$bench/times" >>"$into"
}

sort_points() {
    LC_ALL=C sort --parallel=1 -n -o /dev/null "$points"
}

# The least and the middle one of a file of numbers.
least_and_median() {
    sort -n "$1" | awk '
        { v[NR] = $1 }
        END {
            printf "%.3f %.3f\n", v[1], (v[int((NR + 1) / 2)] + v[int(NR / 2) + 1]) / 2
        }'
}

row='%-11s %10s %10s %10s %10s %8s %8s\n'
table=$bench/programs.csv
echo "$count uniform points, $runs runs each, seconds of processor time"
# shellcheck disable=SC2059 # the format of every row is the same
printf "$row" algorithm least median sort-least sort-med. ratio ratio-med.
echo "algorithm,points,runs,least,median,sort_least,sort_median,ratio,ratio_of_medians" \
    >"$table"
for algorithm in $("$tri" help triangulate |
    awk '$2 ~ /^[0-9]+\.[0-9]+$/ && !/slow beyond/ { print $1 }'); do
    ours=$bench/$algorithm.txt
    theirs=$bench/$algorithm-sort.txt
    rm -f "$ours" "$theirs"
    run=0
    status=0
    while [ "$run" -lt "$runs" ]; do
        measure "$ours" "$tri" triangulate --algorithm "$algorithm" -o /dev/null \
            "$points" || { status=$? && break; }
        measure "$theirs" sort_points
        run=$((run + 1))
    done
    if [ "$status" -gt 128 ]; then # stopped by a signal
        printf '%-11s given up after %s s\n' "$algorithm" "$limit"
        continue
    elif [ "$status" -ne 0 ]; then
        printf '%-11s failed: %s\n' "$algorithm" "$(head -n 1 "$bench/said")"
        exit 1
    fi
    echo "$(least_and_median "$ours") $(least_and_median "$theirs")" |
        awk -v row="$row" -v table="$table" -v algorithm="$algorithm" \
            -v points="$count" -v runs="$runs" '{
            printf row, algorithm, $1, $2, $3, $4, sprintf("%.2f", $1 / $3),
                   sprintf("%.2f", $2 / $4)
            printf "%s,%d,%d,%s,%s,%s,%s,%.3f,%.3f\n", algorithm, points, runs, $1, $2,
                   $3, $4, $1 / $3, $2 / $4 >>table
        }'
done
echo "the same numbers: $table"
