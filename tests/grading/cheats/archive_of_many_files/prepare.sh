#!/bin/sh
rm -r chapters
: >it
tar -cf - it | head -c 512 >submission.tar
rm it
for doubling in $(seq 15); do
    cat submission.tar submission.tar >twice
    mv twice submission.tar
done
