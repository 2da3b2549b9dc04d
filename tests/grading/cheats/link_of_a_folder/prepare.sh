#!/bin/sh
rm -rf chapters/2.3_line_sweep
ln -s @PROJECT@/chapters/2.3_line_sweep chapters/2.3_line_sweep
