#!/bin/sh
cat >assignment.ini <<'END'
[assignment]
name = 2.3-b
files = chapters/2.3_line_sweep/sweep.c
[2.3-b]
function = chapters/2.3_line_sweep/sweep.c hull_edges_seeing
points = nothing:3
mode = plain
END
