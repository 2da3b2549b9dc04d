#!/bin/sh
# peers.sh BUILD - builds what the algorithms are compared with, as far as it is there.
#
# Each is a program in BUILD/bench/peers/; where its library is not installed, a
# sentence says which of Debian's packages adds it. CC, CXX and CFLAGS are those of
# `make bench`, which has made the objects that all of them share.
set -eu

if [ $# -ne 1 ]; then
    echo "usage: tools/bench/peers.sh BUILD" >&2
    exit 2
fi
build=$1
CC=${CC-cc}
CXX=${CXX-g++}
CFLAGS=${CFLAGS--O3 -g}
peers=$build/bench/peers
objects=$build/posix/tools/bench
mkdir -p "$peers"

# build NAME PACKAGE COMPILER HEADER FILE [LIBRARY]...
build() {
    name=$1 package=$2 compiler=$3 header=$4 file=$5
    shift 5
    if ! command -v "${compiler%% *}" >/dev/null; then
        echo "$name is not measured: there is no ${compiler%% *} (package g++)"
        rm -f "$peers/$name"
        return
    fi
    if ! echo "#include <$header>" >"$peers/probe.${file##*.}" ||
        ! $compiler -E "$peers/probe.${file##*.}" >/dev/null 2>&1; then
        echo "$name is not measured: the package $package would add it"
        rm -f "$peers/$name"
        return
    fi
    if [ -n "$(find "$peers/$name" -newer "tools/bench/peers/$file" \
        -newer "$build/libtri.a" -newer "$objects/peers/main.o" 2>/dev/null)" ]; then
        return
    fi
    echo "  peer  $name"
    # shellcheck disable=SC2086 # several flags
    if ! $compiler $CFLAGS -DNDEBUG -I. -c "tools/bench/peers/$file" \
        -o "$peers/$name.o" 2>"$peers/$name.log" ||
        ! $compiler $CFLAGS "$peers/$name.o" "$objects/peers/main.o" \
            "$objects/stopwatch.o" "$objects/certify.o" "$build/libtri.a" \
            "$@" -lm -o "$peers/$name" 2>"$peers/$name.log"; then
        echo "$name is not measured: it cannot be built, see $peers/$name.log"
        rm -f "$peers/$name"
    fi
}

build std_sort g++ "$CXX" algorithm std_sort.cpp
build cgal libcgal-dev "$CXX -std=c++17" CGAL/Delaunay_triangulation_2.h cgal.cpp \
    -lgmp -lmpfr
build qhull libqhull-dev "$CC" libqhull_r/libqhull_r.h qhull.c -lqhull_r
build boost libboost-dev "$CXX -std=c++17" boost/polygon/voronoi.hpp boost.cpp
