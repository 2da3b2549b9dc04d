#!/bin/sh
# run.sh BUILD TEST... - runs BUILD/test/TEST for each TEST, two at a time.
#
# Prints a line for each program and its failures in full; what the programs print is
# kept in BUILD/results/TEST.tap. Ends with "N passed, N failed", counted in lines of
# TAP, and with status 1 if anything failed. A failure, too, is a program without
# tests or without its last line, and one with a claim that is written in its source
# and was never made.
#
# TEST_ARGS="--seed 7" tests/run.sh ... passes arguments to the programs.
set -u

# The names of all claims in a test's source, one a line.
claims_in() {
    awk '{
        while (match($0, /(CLAIM|claim_verdict)\("[^"]*"/)) {
            name = substr($0, RSTART, RLENGTH)
            $0 = substr($0, RSTART + RLENGTH)
            sub(/^[^"]*"/, "", name)
            sub(/"$/, "", name)
            print name
        }
    }' "$1"
}

# Prints the line for one program and its failures, then "= PASSED FAILED".
# Reads the claims in its source and then its output.
# shellcheck disable=SC2016 # the dollars are awk's
summary='
reading == "claims" { source[$0]; next }
/^ok /              { passed++ }
/^ok .* # SKIP /    { skipped++ }
/^not ok /          { failed++ }
/^1\.\./            { plan = substr($0, 4) }
/^# claim /         { delete source[$3] }
/^not ok /, /^ok /  { if ($0 !~ /^ok / && $0 !~ /^# [^ ]/ && $0 !~ /^1\.\./)
                          told = told $0 "\n" }
function fail(why)  { failed++; told = told why "\n" }
END {
    if (plan == "")
        fail("ended before its last line, with status " status)
    else if (plan == 0 || plan != passed + failed)
        fail("announced " plan " tests, and ran " passed + failed)
    else if (failed == 0 && status != 0)
        fail("ended with status " status ", although no test failed")
    if (failed == 0 && skipped == 0)
        for (name in source)
            fail("claim " name " is written in the source, and was never made")
    printf "%-6s %-28s %4d passed", failed ? "FAILED" : "ok", name_of_test, passed
    printf "%s %5d s\n%s", failed ? ", " failed " failed" : "", seconds, told
    print "=", passed + 0, failed + 0
}'

# One program. Its lines are printed at once, not among those of another.
run_one() {
    build=$1 name=$2
    result=$build/results/$name
    begin=$(date +%s)
    # shellcheck disable=SC2086 # several arguments, or none
    "$build/test/$name" ${TEST_ARGS-} >"$result.tap" 2>"$result.stderr"
    status=$?
    seconds=$(($(date +%s) - begin))
    cat "$result.stderr" >&2
    said=$(claims_in "tests/$name.c" | awk -v name_of_test="$name" \
        -v status="$status" -v seconds="$seconds" "$summary" \
        reading=claims - reading=output "$result.tap")
    printf '%s\n' "$said" | sed -n 's/^= //p' >"$result.count"
    printf '%s\n' "$said" | sed '/^= /d'
}

if [ "${1-}" = --one ]; then
    run_one "$2" "$3"
    exit
fi
if [ $# -lt 2 ]; then
    echo "usage: tests/run.sh BUILD TEST..." >&2
    exit 2
fi
build=$1
shift
mkdir -p "$build/results"
rm -f "$build/results"/*
printf '%s\n' "$@" | xargs -n 1 -P 2 sh "$0" --one "$build"
cat "$build/results"/*.count /dev/null | awk -v wanted=$# '
    { passed += $1; failed += $2 }
    END {
        failed += wanted - NR # those that left no result
        printf "%d passed, %d failed\n", passed, failed
        exit failed > 0 || passed == 0
    }'
