#!/bin/sh
dd if=/dev/zero of=chapters/2.3_line_sweep/sweep.c bs=1048576 seek=100 count=1 2>/dev/null
