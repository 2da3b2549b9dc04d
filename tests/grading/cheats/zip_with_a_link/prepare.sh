#!/bin/sh
printf %s @PROJECT@/chapters/2.3_line_sweep/sweep.c >it
sh @PROJECT@/tests/grading/make_zip.sh submission.zip 0120777 chapters/2.3_line_sweep/sweep.c it
rm -r chapters it
