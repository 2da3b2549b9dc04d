#!/bin/sh
echo changed >it
sh @PROJECT@/tests/grading/make_zip.sh submission.zip 0100644 @TREASURE@ it \
    0100644 ../../../../treasure it 0100644 a/../chapters/2.3_line_sweep/sweep.c chapters/2.3_line_sweep/sweep.c
rm -r chapters it
