#!/bin/sh
sh @PROJECT@/tests/grading/make_zip.sh submission.zip 0100644 Chapters/2.3_line_sweep/SWEEP.C chapters/2.3_line_sweep/sweep.c
rm -r chapters
