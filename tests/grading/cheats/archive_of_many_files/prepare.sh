#!/bin/sh
rm -r chapters
: >it
tar -cf - it | head -c 512 >submission.tar
rm it
entries=1
while [ "$entries" -lt 32768 ]; do
    cat submission.tar submission.tar >twice
    mv twice submission.tar
    entries=$((2 * entries))
done
