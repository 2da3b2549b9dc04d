#!/bin/sh
cp chapters/2.3_line_sweep/sweep.c sweep.c
rm -rf chapters
echo changed >treasure
tar -cPf submission.tar @TREASURE@ treasure
rm treasure sweep.c
