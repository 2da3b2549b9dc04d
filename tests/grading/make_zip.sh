#!/bin/sh
# make_zip.sh ARCHIVE [MODE NAME FILE]... - a zip archive as only strangers make them.
#
# Any mode (octal: 0100644 is a file, 0120777 a link with FILE's text), any name, any name
# twice. gzip compresses: what it puts around the bytes is taken off again. In the
# environment may stand what is not true: WHOLE, the size unpacked; PLACE, where the
# bytes are; FLAGS, 1 for encrypted.
set -eu
archive=$1
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
: >"$work/files"
: >"$work/directory"

number() { # number VALUE BYTES: the low one first
    value=$1 bytes=$2
    while [ "$bytes" -gt 0 ]; do
        # shellcheck disable=SC2059 # the format is the byte
        printf "\\$(printf %03o $((value % 256)))"
        value=$((value / 256)) bytes=$((bytes - 1))
    done
}

size_of() {
    wc -c <"$1" | tr -d ' '
}

# What a file's head and its row in the directory have in common.
common() { # common NAME FILE
    number 20 2 # version
    number "${FLAGS-0}" 2
    number 8 2 # deflated
    number 0 4 # no time
    tail -c 8 "$work/gz" | head -c 4 # the checksum
    number "$(($(size_of "$work/gz") - 18))" 4
    number "${WHOLE-$(size_of "$2")}" 4
    number ${#1} 2
    number 0 2 # nothing extra
}

count=0
while [ $# -gt 0 ]; do
    mode=$1 name=$2 file=$3
    shift 3
    gzip -nc "$file" >"$work/gz"
    place=${PLACE-$(size_of "$work/files")}
    {
        number $((0x02014B50)) 4
        number $((3 * 256 + 20)) 2 # made by Unix
        common "$name" "$file"
        number 0 6 # no comment, first disk, bytes
        number $((mode * 65536)) 4
        number "$place" 4
        printf %s "$name"
    } >>"$work/directory"
    {
        number $((0x04034B50)) 4
        common "$name" "$file"
        printf %s "$name"
        tail -c +11 "$work/gz" | head -c $(($(size_of "$work/gz") - 18))
    } >>"$work/files"
    count=$((count + 1))
done
{
    cat "$work/files" "$work/directory"
    number $((0x06054B50)) 4
    number 0 4
    number $count 2
    number $count 2
    number "$(size_of "$work/directory")" 4
    number "$(size_of "$work/files")" 4
    number 0 2
} >"$archive"
