#!/bin/sh
# run_long.sh BUILD TEST... - what takes too long for every day.
#
#   1. every test with ten times as many trials;
#   2. the same of the tests of 3.4, built by gcc and clang without and with
#      optimisation, for this very processor, with contraction where the filters are
#      inlined, and for 32 bits;
#   3. large inputs, up to a million points (tests/run_sizes.sh);
#   4. the same bytes with other C libraries and machines (tests/run_portable.sh);
#   5. the readers of files under a fuzzer, for FUZZ_SECONDS (60 if not given).
#
# What a machine lacks is skipped, with a sentence, and counted apart. Ends with
# "N passed, N failed".
#
# It is meant for a night: part 1 took 19 minutes of processor time, part 2 half a
# minute for each compiler and set of flags before it, too, had ten times as many
# trials; in part 3 each input may take half a minute; a row of part 4 took a minute of
# processor time, and one under an emulator several.
set -u

if [ $# -lt 2 ]; then
    echo "usage: tests/run_long.sh BUILD TEST..." >&2
    exit 2
fi
build=$1
shift
long=$build/long
mkdir -p "$long/fuzz"
rm -f "$long"/*.txt

# Copies what comes in to the terminal and to a file, which the sum is made from.
note() {
    tee "$long/$1.txt"
}

# ---- 1 ----

echo "--- ten times as many trials"
TEST_ARGS='--trials-factor 10' tests/run.sh "$build" "$@" | note trials

# ---- 2 ----

predicates=$(printf '%s\n' "$@" | grep '^3\.4_')
probe=$long/probe.c
printf '%s\n' '#include <errno.h>' 'int main(void) { return errno; }' >"$probe"

# try_flags NAME COMPILER FLAGS [FLAGS FOR PROGRAMS]
try_flags() {
    echo "--- 3.4 by $2 $3 ${4-}"
    # shellcheck disable=SC2086 # several flags
    if ! $2 $3 "$probe" -o "$long/probe" 2>"$long/probe.log"; then
        echo "skipped: $2 $3 is not possible here: $(head -n 1 "$long/probe.log")" |
            note "$1"
        return
    fi
    targets=
    for name in $predicates; do
        targets="$targets $long/$1/test/$name"
    done
    # shellcheck disable=SC2086 # several targets, several tests
    if MAKELEVEL=0 MAKEFLAGS='' make -s BUILD="$long/$1" CC="$2" CFLAGS="$3" \
        POSIX="-D_POSIX_C_SOURCE=200809L ${4-}" $targets; then
        TEST_ARGS='--trials-factor 10' tests/run.sh "$long/$1" $predicates | note "$1"
    else
        echo "it does not compile"
        echo "0 passed, 1 failed" | note "$1"
    fi
}

# Where gcc-12-multilib stands without gcc-multilib, asm/ is only here.
asm=/usr/include/$(gcc -print-multiarch)
for compiler in gcc clang; do
    try_flags "$compiler-O0" "$compiler" -O0
    try_flags "$compiler-O2" "$compiler" -O2
    try_flags "$compiler-native" "$compiler" '-O3 -march=native'
    try_flags "$compiler-contract" "$compiler" '-O3 -march=native' -ffp-contract=fast
    try_flags "$compiler-32" "$compiler" "-O2 -m32 -msse2 -mfpmath=sse -idirafter $asm"
done

# ---- 3 ----

echo "--- large inputs"
tests/run_sizes.sh "$build" | note sizes

# ---- 4 ----

echo "--- other C libraries and machines"
tests/run_portable.sh "$build" | tee "$long/portable.log"
grep '^skipped: ' "$long/portable.log" >"$long/portable.txt"
tail -n 1 "$long/portable.log" >>"$long/portable.txt"

# ---- 5 ----

seconds=${FUZZ_SECONDS-60}
echo "--- the readers of files, fuzzed for $seconds s"
sanitizers=address,undefined
common="-std=c11 -g -O1 -I. -D_POSIX_C_SOURCE=200809L -fno-sanitize-recover=all"
sources="tests/fuzz/read_files.c lib/*.c"
target=$long/fuzz/read_files

# shellcheck disable=SC2086 # several flags, several files
fuzz() {
    if clang $common "-fsanitize=fuzzer,$sanitizers" $sources -o "$target" -lm \
        2>"$target.log"; then
        rm -rf "$target.corpus"
        mkdir "$target.corpus"
        cp tests/bad_files/* "$target.corpus"
        "$target" -max_total_time="$seconds" -seed=1 -rss_limit_mb=1000 \
            -artifact_prefix="$target." "$target.corpus" >"$target.log" 2>&1
    else
        echo "without libFuzzer: by tests/fuzz/driver.c"
        ${CC-cc} $common $sources tests/fuzz/driver.c -o "$target" -lm &&
            "$target" "$seconds" 1 "$target.last" tests/bad_files/* >"$target.log" 2>&1
    fi
}
if fuzz; then
    tail -n 1 "$target.log"
    echo "1 passed, 0 failed" | note fuzz
else
    tail -n 40 "$target.log"
    echo "the text that did it is beside $target"
    echo "0 passed, 1 failed" | note fuzz
fi

# ---- The sum. ----

echo "--- in all"
awk '
/^[0-9]+ passed, [0-9]+ failed$/ { passed += $1; failed += $3 }
/^skipped: / { skipped++ }
END {
    printf "%d skipped\n", skipped
    printf "%d passed, %d failed\n", passed, failed
    exit failed > 0 || passed == 0
}' "$long"/*.txt
