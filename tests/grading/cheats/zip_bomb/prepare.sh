#!/bin/sh
head -c 400000000 /dev/zero >it
WHOLE=4000 sh @PROJECT@/tests/grading/make_zip.sh submission.zip 0100644 chapters/2.3_line_sweep/sweep.c it
rm -r chapters it
