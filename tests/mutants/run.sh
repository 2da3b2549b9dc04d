#!/bin/sh
# run.sh [NAME...] - plants the bugs of tests/mutants/NAME.mutant (all of them, if none
# is named) one by one, and sees which statement catches each.
#
# A mutant is a file of lines "key: value":
#
#     bug:       what a student might believe, in a sentence
#     file:      the source that is changed: of lib, chapters or tools
#     replace:   what is changed there, as tests/plant.awk explains it,
#     with:      and what into; there may be several pairs
#     run:       the test that shall notice
#     killed by: the claim that fails; or "a crash"; or "no end"
#
# Each mutant is built in a copy of the tree in build/mutants, beside objects that are
# already made, and runs there; so are the programs that the test drives. One that does
# not apply, does not compile, survives, or is caught by another claim only, has failed.
# Ends with "N passed, N failed". TESTED=yes in the environment says that all tests have
# just passed: else they are run without a bug first.
set -u
unset MAKEFLAGS MFLAGS

cd "$(dirname "$0")/../.." || exit 2
root=$PWD
base=build/mutants/base
seconds_for_a_test=150
CFLAGS=${CFLAGS--O1} # to compile takes longer than to run
export CFLAGS

value() { # value KEY FILE
    sed -n "s/^$1: *//p" "$2"
}

# Makes the replacements of mutant $1 in the file $2, or says why not.
apply() {
    awk -f "$root/tests/plant.awk" "$1" "$2" >changed && cat changed >"$2" && rm changed
}

# Does the output of a test say that it failed as the mutant's file says?
is_killed() { # is_killed OUTPUT KILLER
    case $2 in
    'a crash') grep -q '^#   because: stopped by signal' "$1" ;;
    'no end') grep -q '^#   because: did not end' "$1" ;;
    *) grep -qxF "#   claim: $2" "$1" ;;
    esac
}

# Runs the test until it ends, has said what we wait for, or takes too long.
run_until_killed() { # run_until_killed TEST OUTPUT KILLER
    : >"$2"
    "build/test/$1" >"$2" 2>&1 &
    pid=$!
    until=$(($(date +%s) + seconds_for_a_test))
    while kill -0 "$pid" 2>/dev/null && [ "$(date +%s)" -lt "$until" ] &&
        ! is_killed "$2" "$3"; do
        sleep 0.2 2>/dev/null || sleep 1
    done
    kill "$pid" 2>/dev/null
    wait "$pid" 2>/dev/null
}

# One mutant: a line of the result, which begins with "killed" when all is well.
try_mutant() {
    mutant=$root/tests/mutants/$1.mutant
    tree=$root/build/mutants/$1
    file=$(value file "$mutant")
    run=$(value run "$mutant")
    killer=$(value 'killed by' "$mutant")
    rm -rf "$tree"
    cp -Rp "$root/$base" "$tree"
    cd "$tree" || exit 2
    if [ -z "$killer" ] || ! apply "$mutant" "$file" 2>complaint; then
        echo "not applied: $1: $(cat complaint)"
    elif ! make "build/test/$run" >complaint 2>&1; then
        echo "not compiled: $1: see $tree/complaint"
    else
        run_until_killed "$run" output.tap "$killer"
        if is_killed output.tap "$killer"; then
            cd "$root" && rm -rf "$tree"
            printf 'killed       %-34s by %s\n' "$1" "$killer"
        elif grep -q '^not ok' output.tap; then
            caught=$(sed -n 's/^#   claim: //p; s/.*: stopped by signal.*/a crash/p
                s/.*: did not end.*/no end/p' output.tap | sort -u | paste -s -d , -)
            echo "misnamed: $1: caught by $caught and not by $killer"
        else
            echo "survived: $1: see $tree"
        fi
    fi
}

# A test without any bug planted: prints nothing when all is well.
try_test() {
    cd "$base" || exit 2
    "build/test/$1" >"$1.tap" 2>&1 ||
        echo "$1 fails without any bug planted: see $base/$1.tap"
}

case ${1-} in
--one)
    try_mutant "$2"
    exit
    ;;
--test)
    try_test "$2"
    exit
    ;;
esac

if [ $# -eq 0 ]; then
    for mutant in tests/mutants/*.mutant; do
        name=${mutant##*/}
        set -- "$@" "${name%.mutant}"
    done
fi
tests=$(for name in "$@"; do value run "tests/mutants/$name.mutant"; done | sort -u)

# The sources anew, the objects of last time.
mkdir -p "$base"
for item in "$base"/*; do
    [ "$item" = "$base/build" ] || rm -rf "$item"
done
cp -Rp Makefile lib chapters docs tests tools "$base"
complaint=$base/complaint
if (cd "$base" && echo "$tests" | sed 's|^|build/test/|' | xargs make) \
    >"$complaint" 2>&1
then
    : >"$complaint"
    [ "${TESTED-}" = yes ] ||
        echo "$tests" | xargs -n 1 -P 2 sh "$root/tests/mutants/run.sh" --test \
            >"$complaint"
fi
if [ -s "$complaint" ]; then
    cat "$complaint"
    echo "0 passed, $# failed"
    exit 1
fi

printf '%s\n' "$@" | xargs -n 1 -P 2 sh "$root/tests/mutants/run.sh" --one |
    tee build/mutants/log.txt
awk -v wanted=$# '
/^killed / { killed++ }
END {
    printf "%d passed, %d failed\n", killed, wanted - killed
    exit killed != wanted || wanted == 0
}' build/mutants/log.txt
