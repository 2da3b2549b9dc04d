#!/bin/sh
rm chapters/2.3_line_sweep/sweep.c
ln -s @PROJECT@/chapters/2.3_line_sweep/sweep.c chapters/2.3_line_sweep/sweep.c
