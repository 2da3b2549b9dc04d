#!/bin/sh
PLACE=4294967000 sh @PROJECT@/tests/grading/make_zip.sh submission.zip 0100644 chapters/2.3_line_sweep/sweep.c chapters/2.3_line_sweep/sweep.c
rm -r chapters
