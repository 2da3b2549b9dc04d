#!/bin/sh
# run_portable.sh BUILD [NAME...] - the same bytes with other C libraries and on other
# machines: with every row of the table below, or with those that are named.
#
# A row is a compiler, and the program that runs what it makes. With it tri and a few
# tests are built, in BUILD/portable/NAME, and run. Whatever tri writes there, of every
# distribution and with every algorithm, must be byte for byte what BUILD/tri writes:
# each file is a test, and so are those in the tests' own output.
#
# What this machine lacks is skipped, with the packages of Debian that have it, and not
# counted. Ends with "N passed, N failed".
set -u

# NAME|PROGRAM THAT RUNS|COMPILER AND FLAGS|PACKAGES. The last two stand for projects
# that compile our sources in their own way: a*b+c is fused wherever a compiler can.
# Debian's gcc-multilib excludes the compilers for other machines; gcc-12-multilib does
# not, and lacks only a path to asm/.
table() {
    asm=/usr/include/$(gcc -print-multiarch)
    aarch64='qemu-user gcc-aarch64-linux-gnu libc6-dev-arm64-cross'
    s390x='qemu-user gcc-s390x-linux-gnu libc6-dev-s390x-cross'
    cat <<END
musl||musl-gcc|musl-tools
32-bit||gcc -m32 -msse2 -mfpmath=sse -idirafter $asm|gcc-$(gcc -dumpversion)-multilib
aarch64|qemu-aarch64|aarch64-linux-gnu-gcc|$aarch64
s390x|qemu-s390x|s390x-linux-gnu-gcc|$s390x
aarch64-fused|qemu-aarch64|aarch64-linux-gnu-gcc -ffp-contract=fast|$aarch64
s390x-fused|qemu-s390x|s390x-linux-gnu-gcc -ffp-contract=fast|$s390x
END
}

# The predicates and what they stand on; files, numbers, threads.
tests='3.4_compare_distance 3.4_incircle 3.4_orient2d 3.4_orient3d 3.1_circumcentre
3.7_fast_divide lib_decimal lib_expansion lib_random lib_textio'

# ---- What tri writes. ----

# say FILE ARGUMENTS...: what one run of tri prints, and its exit status.
# shellcheck disable=SC2086 # $by is a word or none
say() {
    file=$1
    shift
    $by "$tri" "$@" >"$file" 2>"$file.status"
    echo "status $?" >>"$file.status"
}

# say_all FOLDER TRI [PROGRAM THAT RUNS]: fills the folder. The slow get few points.
say_all() (
    tri=$2 by=${3-}
    rm -rf "$1"
    mkdir -p "$1"
    cp docs/data/coast.node "$1"
    cd "$1" || exit

    for d in $distributions; do
        say "$d.generate" generate "$d" 1000 -o "$d.node"
        say "$d.generate-few" generate "$d" 24 --seed 2 -o "$d.few"
        say "$d.generate-some" generate "$d" 200 --seed 5 -o "$d.some"
        say "$d.generate-ten" generate "$d" 10 --seed 3 -o "$d.ten"
        say "$d.generate-bits" generate "$d" 20000 --seed 4 --binary -o "$d.bits"
        for threads in 1 2; do
            say "$d.threads-$threads" triangulate --threads "$threads" \
                -o "$d.threads-$threads.off" "$d.bits"
        done
        say "$d.neigh" triangulate -o "$d.fast.neigh" --svg "$d.fast.svg" "$d.node"
        say "$d.voronoi" voronoi -o "$d.cells" --svg "$d.cells.svg" "$d.node"
        say "$d.voronoi-each" voronoi -o "$d.each" --per-triangle "$d.node"
        say "$d.flipgraph" flipgraph "$d.ten"
        for graph in hull emst gabriel rng nng; do
            say "$d.$graph" "$graph" "$d.node"
        done
        for a in $algorithms; do
            case $a in
            brute) points=$d.few ;;
            lift | lawson) points=$d.some ;;
            *) points=$d.node ;;
            esac
            say "$d.$a" triangulate --algorithm "$a" -o "$d.$a.ele" "$points"
            say "$d.$a.check" check --delaunay "$points" "$d.$a.ele"
        done
        for a in $traced; do
            say "$d.$a.trace" trace --algorithm "$a" "$d.few"
        done
    done
    say coast triangulate -o coast.geojson --svg coast.svg coast.node
    say coast.voronoi voronoi -o coast coast.node
)

# sums FOLDER: a line for each file.
sums() (
    cd "$1" && cksum -- *
)

# Compares two lists of sums, what is to be expected first.
# shellcheck disable=SC2016 # the dollars are awk's
same='
NR == FNR         { expected[$3] = $1 " " $2; next }
                  { got[$3] = $1 " " $2 }
END {
    for (file in expected)
        if (got[file] == expected[file])
            passed++
        else {
            print "not ok - " name ": another " file | "sort"
            failed++
        }
    for (file in got)
        if (!(file in expected)) {
            print "not ok - " name ": nothing was expected in " file | "sort"
            failed++
        }
    close("sort")
    printf "%d passed, %d failed\n", passed, failed
}'

# ---- One row of the table. ----

# Can this be compiled and run here?
# shellcheck disable=SC2086 # several words
possible() {
    echo '#include <errno.h>' >"$own/probe.c"
    echo 'int main(void) { return errno; }' >>"$own/probe.c"
    $compiler -static "$own/probe.c" -o "$own/probe" && $runs "$own/probe"
}

# shellcheck disable=SC2086 # several words
try_row() {
    own=$folder/$name
    mkdir -p "$own/run/test"
    echo "--- $name: $compiler"
    if ! possible 2>"$own/probe.log"; then
        echo "skipped: $name (Debian: apt-get install $packages)"
        return
    fi
    targets=$own/tri
    for test in $tests; do
        targets="$targets $own/test/$test"
        # run.sh starts programs by their names.
        printf '#!/bin/sh\nexec %s "%s" "$@"\n' "$runs" "$own/test/$test" \
            >"$own/run/test/$test"
        chmod +x "$own/run/test/$test"
    done
    cc=${compiler%% *}
    if MAKELEVEL=0 MAKEFLAGS='' make -s BUILD="$own" CC="$cc" \
        CFLAGS="-O2 -static ${compiler#"$cc"}" $targets; then
        say_all "$own/said" "$root/$own/tri" "$runs"
        sums "$own/said" >"$own/sums.txt"
        awk -v name="$name" "$same" "$folder/here/sums.txt" "$own/sums.txt"
        tests/run.sh "$own/run" $tests
    else
        echo "it does not compile"
        echo "0 passed, 1 failed"
    fi
}

# ---- All of them. ----

if [ $# -lt 1 ]; then
    echo "usage: tests/run_portable.sh BUILD [NAME...]" >&2
    exit 2
fi
build=$1
shift
root=$PWD
case $build in /*) root= ;; esac
folder=$build/portable
mkdir -p "$folder/here"
names_after() {
    "$build/tri" help "$1" |
        awk -v after="^$2" '$0 ~ after { on = 1; next } on { print $1 }'
}
distributions=$(names_after generate Distributions)
algorithms=$(names_after triangulate Algorithms)
traced=$(for a in $algorithms; do
    printf '0 0\n' | "$build/tri" trace --algorithm "$a" - >/dev/null 2>&1 && echo "$a"
done)

say_all "$folder/here/said" "$root/$build/tri"
sums "$folder/here/said" >"$folder/here/sums.txt"
# Not to compare refusals: only the sweep's triangles may be refuted.
if grep -v '^status 0$' "$folder"/here/said/*.status | grep -v '\.sweep\.check\.' |
    grep '^[^:]*:status'; then
    echo "0 passed, 1 failed"
    exit 1
fi
table | while IFS='|' read -r name runs compiler packages; do
    case " ${*:-$name} " in
    *" $name "*) try_row </dev/null ;;
    esac
done | tee "$folder/log.txt"
awk '
/^[0-9]+ passed, [0-9]+ failed$/ { passed += $1; failed += $3 }
/^skipped: / { skipped++ }
END {
    printf "--- %d skipped; all others:\n", skipped
    printf "%d passed, %d failed\n", passed, failed
    exit failed > 0
}' "$folder/log.txt"
