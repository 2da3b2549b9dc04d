#!/bin/sh
# hint.sh EXERCISE [N] - the first N hints for an exercise, 1 if not given, at most 3.
set -u
awk -v exercise="${1:-}" -v most="${2:-1}" '
/^\[/ { here = $0 == "[" exercise "]"; next }
here && /^hint[0-9] *=/ {
    number = substr($1, 5, 1)
    if (number + 0 > most + 0)
        next
    sub(/^[^=]*= */, "")
    print "  " number ". " $0
    told++
}
END {
    if (!told)
        print "say which exercise, for example: make hint EX=2.3-b N=2"
    exit !told
}' assignment.ini
