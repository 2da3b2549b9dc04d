#!/bin/sh
# run.sh EXERCISE:PROGRAM... - checks the exercises and adds up the points.
#
# BUILD, SEED, CASE, VARIANT, PROPERTY, TARGET (check or sanitize) and EXERCISES (all
# that there are) are set by make. What is wrong stands in BUILD/feedback/EXERCISE/: a text
# and a picture for each property that fails. Exit status: 0 all is right; 1 not yet;
# 2 the checker itself has failed, or there is nothing that it could check.
set -u

if [ $# -eq 0 ]; then
    echo "There is no such exercise here, or no check of it. There are: $EXERCISES" >&2
    exit 2
fi
case $SEED in
*[!0-9]*)
    echo "SEED is a number, and not: $SEED" >&2
    exit 2 ;;
esac

status=0
checked=
for pair in "$@"; do
    exercise=${pair%%:*}
    program=${pair#*:}
    feedback=$BUILD/feedback/$exercise
    rm -rf "$feedback"
    mkdir -p "$feedback"
    again="make $TARGET EX=$exercise SEED=$SEED"
    set -- "$exercise" --seed "$SEED" --feedback "$feedback" --again "$again" \
        --again-case "make $TARGET EX=$exercise"
    [ -n "$CASE" ] && set -- "$@" --case "$CASE"
    [ -n "$VARIANT" ] && set -- "$@" --variant "$VARIANT"
    [ -n "$PROPERTY" ] && set -- "$@" --property "$PROPERTY"
    instances=checks/${exercise%-*}.instances
    [ -f "$instances" ] && set -- "$@" --instances "$instances"
    echo "== $exercise"
    "$BUILD/checker_${exercise%-*}" "$@" -- "$program"
    case $? in
    42) ;;
    43) [ $status -eq 2 ] || status=1 ;;
    *)  echo "The checker of $exercise has failed; this is not your fault." >&2
        status=2 ;;
    esac
    echo
    [ -z "$CASE" ] && [ -f "$feedback/properties.tsv" ] && checked="$checked $exercise"
done

# The points, by property: assignment.ini says how many, properties.tsv which are earned.
for exercise in $checked; do
    awk -v exercise="$exercise" '
    FILENAME == "assignment.ini" && /^\[/ { here = $0 == "[" exercise "]"; next }
    FILENAME == "assignment.ini" && here && $1 == "points" {
        for (i = 3; i <= NF; i++) {
            split($i, part, ":")
            name[++count] = part[1]
            points[count] = part[2]
        }
    }
    FILENAME == "assignment.ini" { next }
    { split($0, cell, "\t"); result[cell[1]] = cell[2] }
    END {
        for (i = 1; i <= count; i++) {
            earned = result[name[i]] == "pass" ? points[i] : 0
            sum += earned
            all += points[i]
            line = line "  " name[i] " " earned "/" points[i]
        }
        printf "%-6s %2d of %2d points:%s\n", exercise, sum, all, line
    }' assignment.ini "$BUILD/feedback/$exercise/properties.tsv"
done | awk '
FILENAME == "assignment.ini" && /^\[/ { here = substr($0, 2, length($0) - 2) }
FILENAME == "assignment.ini" && /^bonus *= *yes/ { bonus[here] = 1 }
FILENAME == "assignment.ini" { next }
{ print; lines++; sum += $2; all += bonus[$1] ? 0 : $4 }
END { if (lines > 1) printf "%-6s %2d of %2d points\n", "all", sum, all }' assignment.ini -
exit $status
