#!/bin/sh
# The lines of the file become the lines of the table: a m SIGN X Y X Y X Y X Y
file=chapters/3.4_primitives/exact.c
awk '$1 == "a" {
    printf "    {%s, {", $3
    for (i = 4; i <= 11; i++) printf "%s, ", $i
    print "}},"
}' @HANDOUT@/checks/3.4.instances >instances.h
sed -e '/#include "instances.h"/r instances.h' -e '/#include "instances.h"/d' $file >changed
mv changed $file
rm instances.h
