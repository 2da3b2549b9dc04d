#!/bin/sh
# Makes the point files of this folder from the two files they come from (SOURCES.md).
#
# usage: docs/data/make_data.sh ZONE1970.TAB LAND-110M.JSON
set -eu
if [ $# -ne 2 ]; then
    echo "usage: $0 ZONE1970.TAB LAND-110M.JSON (SOURCES.md says where they are)" >&2
    exit 2
fi
LC_ALL=C
export LC_ALL
folder=$(dirname "$0")

# ISO 6709: +DDMM or +DDMMSS, then the same for the longitude with DDD.
awk -F '\t' '
    function degrees(text, digits,    sign, d, m, s) {
        sign = substr(text, 1, 1) == "-" ? -1 : 1
        d = substr(text, 2, digits)
        m = substr(text, 2 + digits, 2)
        s = substr(text, 4 + digits, 2)
        return sign * (d + m / 60 + s / 3600)
    }
    function short(x,    text) {
        text = sprintf("%.4f", x)
        sub(/0+$/, "", text)
        sub(/\.$/, "", text)
        return text == "-0" ? "0" : text
    }
    BEGIN { print "name,lon,lat" }
    !/^#/ {
        at = match(substr($2, 2), /[-+]/) + 1
        printf "%s,%s,%s\n", $3, short(degrees(substr($2, at), 3)),
               short(degrees(substr($2, 1, at - 1), 2))
    }' "$1" > "$folder/timezones.csv"

# TopoJSON: "arcs":[[[x,y],[dx,dy],...],...] are steps on a grid, which "transform"
# maps to degrees. An arc that is closed repeats its first point at its end.
tr -d ' \n' < "$2" | awk '
    function pair(name) {
        match($0, "\"" name "\":\\[[^]]*\\]")
        split(substr($0, RSTART + length(name) + 4, RLENGTH), two, ",")
    }
    {
        pair("scale"); sx = two[1] + 0; sy = two[2] + 0
        pair("translate"); tx = two[1] + 0; ty = two[2] + 0
        match($0, /"arcs":\[\[\[-?[0-9]+,-?[0-9]+\],/)
        arcs = split(substr($0, RSTART + 10), arc, /\]\],\[\[/)
        for (a = 1; a <= arcs; a++) {
            sub(/\]\]\].*/, "", arc[a])
            gsub(/\[/, "", arc[a])
            steps = split(arc[a], step, /\],?/)
            x = y = 0
            for (i = 1; i <= steps; i++) {
                if (split(step[i], two, ",") != 2)
                    continue
                x += two[1]; y += two[2]
                if (!((x, y) in seen))
                    point[++n] = sprintf("%.3f %.3f", sx * x + tx, sy * y + ty)
                seen[x, y] = 1
            }
        }
        print n, 2, 0, 0
        for (i = 1; i <= n; i++)
            print i, point[i]
    }' > "$folder/coast.node"
