#!/bin/sh
# run.sh BUILD [CASE...] - the grader is tested like the code.
#
# A case is a folder of tests/grading with a submission that somebody might hand in, and
# what the grader must make of it:
#
#     wrong/NAME      a plausible mistake: the property named fails, and its feedback says
#                     what is wrong
#     right/NAME      an unusual solution that is right: it gets full marks
#     cheats/NAME     an attack: it scores 0, and nothing outside its process has changed
#
# and each section with exercises is three cases more:
#
#     untouched/2.3   what was handed out: every property is `todo`
#     nothing/2.3     functions that return 0 and do nothing: no property holds
#     reference/2.3   the project's own code: every property holds
#
# case.ini says, in lines `key = value`,
#
#     about     =     what the student believes, or tries
#     exercise  =     2.3-b, or all of a section: 2.3
#     property  =     wrong: the one that must fail; others may
#     says      =     a piece of what is said then (cheats: if anything in particular)
#     result    =     wrong, cheats: how it comes out, if not `fail`: crash, timeout, ...
#     seconds   =     cheats: it is over by then
#
# and the submission is the project's own code with these changes, those that there are:
#
#     change          pieces of lines replaced, as tests/plant.awk explains it
#     solution.c      functions that take the place of those with the same names
#     prepare.sh      does what it likes with the folder that is handed in
#
# In the last two @PROJECT@ stands for the root of the project, @HANDOUT@ for that of the
# tree that was handed out, and @TREASURE@ for a file that nobody may touch.
#
# All is graded by build/grade, in its jail, as a class would be, two cases at a time.
# Prints a line for each case and ends with "N passed, N failed".
set -u
unset MAKEFLAGS MFLAGS

cd "$(dirname "$0")/../.." || exit 2
project=$PWD

key() { # key NAME FILE: the value, or nothing
    sed -n "s/^$1 *= *//p" "$2"
}

# ---- Bases: what was handed out, compiled once for all that is handed in. ----

# The tree of a section. A section without a checker has none, and its cases fail.
prepare_section() { # prepare_section SECTION
    base=$work/base/$1
    rm -rf "$base"
    if [ ! -f "tools/checks/$1.c" ]; then
        mkdir -p "$base"
        echo "there is no checker of $1" >"$base/missing"
    elif ! "$build/grade" --prepare -a "$1" -o "$base" >"$work/base/$1.said" 2>&1; then
        rm -rf "$base"
        mkdir -p "$base"
        cat "$work/base/$1.said" >"$base/missing"
    fi
}

# The same tree with one of its exercises, so that only this one is checked.
prepare_exercise() { # prepare_exercise EXERCISE
    [ -d "$work/base/$1" ] && return
    cp -Rp "$work/base/${1%-*}" "$work/base/$1"
    [ -f "$work/base/$1/assignment.ini" ] || return
    awk -v wanted="[$1]" '
        /^\[/ { keep = $0 == wanted || $0 == "[assignment]" }
        keep' "$work/base/${1%-*}/assignment.ini" >"$work/base/$1/assignment.ini"
}

# ---- Submissions. ----

# A function's definition goes from the line before its name, which begins a line, to a
# brace that begins one. The first that is replaced makes room for all of the solution.
apply_solution() { # apply_solution SOLUTION FILE
    awk '
    FILENAME == ARGV[1] {
        if (match($0, /^[a-z_][a-z_0-9]*\(/)) replaced[substr($0, 1, RLENGTH)]
        solution = solution $0 "\n"
        next
    }
    inside { inside = $0 !~ /^}/; next }
    match($0, /^[a-z_][a-z_0-9]*\(/) && substr($0, 1, RLENGTH) in replaced {
        inside = 1
        held = 0
        if (!done++) printf "%s", solution
        next
    }
    held { print line }
    { line = $0; held = 1 }
    END {
        if (held) print line
        if (!done) print "none of its functions is in " FILENAME | "cat >&2"
        exit !done
    }' "$1" "$2"
}

# Functions that are to be written return a zero of their type, at once.
do_nothing() { # do_nothing FILE
    awk '
    /^[a-z_][a-z_0-9]*\(/ { type = before; sub(/^static /, "", type) }
    {
        before = $0
        sub(/TODO\("[^"]*"\);/, type == "void" ? "return;" : "return (" type "){0};")
        print
    }' "$1"
}

fill_in() { # fill_in FILE: with the names of this run
    sed "s|@PROJECT@|$project|g; s|@TREASURE@|$treasure|g; s|@HANDOUT@|$base|g" "$1"
}

# What is handed in for the case, in $submission. Complaints go to standard error.
make_submission() {
    for file in $(key files "$base/assignment.ini"); do
        mkdir -p "$submission/${file%/*}"
        cp "$file" "$submission/$file" || return 1
    done
    if [ -f "$case/change" ]; then
        file=$(sed -n 's/^file: *//p' "$case/change")
        awk -f tests/plant.awk "$case/change" "$file" >"$submission/$file" || return 1
    fi
    if [ -f "$case/solution.c" ]; then
        file=$(awk -v wanted="[$exercise]" '/^\[/ { here = $0 == wanted }
            here && $1 == "function" { print $3 }' "$base/assignment.ini")
        fill_in "$case/solution.c" >"$here/solution.c"
        apply_solution "$here/solution.c" "$submission/$file" >"$here/changed" || return 1
        cp "$here/changed" "$submission/$file"
    fi
    if [ -f "$case/prepare.sh" ]; then
        fill_in "$case/prepare.sh" >"$here/prepare.sh"
        (cd "$submission" && sh "$here/prepare.sh") || return 1
    fi
}

# ---- What came out. ----

# "fail", "todo", "pass", ...: of one property, or of each.
word_of() { # word_of PROPERTY
    awk -v property="$1" '$1 ~ /^[0-9]+\/[0-9]+$/ {
        i = $2 == "(bonus)" ? 3 : 2
        if (property == "" || $(i + 1) == property) print $(i + 2)
    }' "$here/out/result.txt"
}

# What is said about one property, if that has its own text; else everything.
feedback_on() { # feedback_on PROPERTY
    awk -v begin="  $exercise $1: " '
        index($0, begin) == 1 { told = 1 }
        told && $0 == "" { exit }
        told { print; any = 1 }
        { all = all $0 "\n" }
        END { if (!any) printf "%s", all }' "$here/out/result.txt"
}

# Is the file one value of JSON? Strings become S and other simple values V; then what
# is innermost is folded, until one V is left.
is_json() { # is_json FILE
    awk '
    { text = text $0 " " }
    END {
        gsub(/"([^"\\]|\\["\\\/bfnrt]|\\u[0-9a-fA-F][0-9a-fA-F][0-9a-fA-F][0-9a-fA-F])*"/,
             "S", text)
        gsub(/[ \t]/, "", text)
        gsub(/-?[0-9]+(\.[0-9]+)?|true|false|null/, "V", text)
        do {
            before = text
            gsub(/\[([SV](,[SV])*)?\]|\{(S:[SV](,S:[SV])*)?\}/, "V", text)
        } while (text != before)
        exit text != "V"
    }' "$1"
}

# Prints why not, unless the mistake has been found and named.
judge_wrong() {
    wanted=$(key property "$case/case.ini")
    word=$(word_of "$wanted")
    result=$(key result "$case/case.ini")
    says=$(key says "$case/case.ini")
    if [ "$word" = pass ]; then
        echo "SURVIVED: $exercise $wanted holds"
    elif [ "$word" != "${result:-fail}" ]; then
        echo "$exercise $wanted comes out as '$word', not as ${result:-fail}"
    elif [ -z "$says" ] || ! feedback_on "$wanted" | grep -qF -- "$says"; then
        echo "$exercise $wanted fails, and does not say '$says'"
    fi
    summary="$exercise $wanted fails and says \"$says\""
}

judge_all() { # judge_all WORD
    others=$(word_of '' | grep -vxF -- "$1" | sort -u | paste -s -d , -)
    if [ -z "$(word_of '')" ]; then
        echo "there are no properties"
    elif [ -n "$others" ]; then
        echo "REFUSED: not each property comes out as $1, but $others"
    fi
    summary="$(sed -n '1s/.*: //p' "$here/out/result.txt"), each property is $1"
}

judge_nothing() {
    if word_of '' | grep -qx -e pass -e todo -e uncompiled; then
        echo "SURVIVED: $(word_of '' | sort -u | paste -s -d , -)"
    fi
    summary="no property holds: $(word_of '' | sort -u | paste -s -d , -)"
}

# Prints what a cheat has achieved.
judge_cheat() {
    limit=$(key seconds "$case/case.ini")
    says=$(key says "$case/case.ini")
    result=$(key result "$case/case.ini")
    summary="0 points in $seconds s: $(word_of '' | sort -u | paste -s -d , -)"
    word_of '' | grep -qx pass && echo "ESCAPED: it has points"
    [ -n "$result" ] && [ "$(word_of '' | sort -u)" != "$result" ] &&
        echo "its properties come out as $(word_of '' | sort -u | paste -s -d , -), not $result"
    [ -n "$says" ] && ! grep -qF -- "$says" "$here/out/result.txt" &&
        echo "it is not said that '$says'"
    [ "$(sed -n '1s/.*: //p' "$here/out/result.txt" | cut -d ' ' -f 1)" = 0 ] ||
        echo "ESCAPED: its score is not 0"
    [ "$(cat "$treasure")" = untouched ] || echo "ESCAPED: it has changed a file"
    [ "$seconds" -le "$limit" ] || echo "it took $seconds s, and not $limit"
    [ "$(find "$here/out" -type f | wc -l)" -le 20 ] || echo "ESCAPED: it has left files"
    if LC_ALL=C grep -rlq "$(printf '[\001-\010\013-\037\177]')" "$here/out"; then
        echo "ESCAPED: a control character is in the results"
    fi
    if find "$here/out" -type f ! -name result.txt -exec cat {} + | grep -qi '<script'; then
        echo "ESCAPED: a tag is in the results"
    fi
}

# What must be true after whatever was graded.
judge_grader() { # judge_grader STATUS
    [ "$1" -eq 0 ] || echo "the grader ended with status $1: $(head -n 3 "$here/said")"
    is_json "$here/out/results.json" 2>/dev/null || echo "results.json is no JSON"
    [ -z "$(ls -A "$scratch/$id")" ] || echo "files are left: $(ls -A "$scratch/$id")"
    for process in /proc/[0-9]*; do
        [ "${process##*/}" = "$$" ] && continue
        case $(readlink "$process/cwd" 2>/dev/null) in
        "$scratch/$id" | "$scratch/$id/"*) echo "ESCAPED: process ${process##*/} is left" ;;
        esac
    done
}

# ---- One case. ----

try_case() { # try_case KIND/NAME
    kind=${1%%/*}
    id=$kind-${1#*/}
    case=tests/grading/$1
    here=$work/$id
    submission=$here/submission
    treasure=$here/treasure
    rm -rf "$here"
    mkdir -p "$submission" "$here/out" "$scratch/$id"
    echo untouched >"$treasure"
    chmod 666 "$treasure"
    exercise=${1#*/}
    [ -f "$case/case.ini" ] && exercise=$(key exercise "$case/case.ini")
    base=$work/base/$exercise
    if [ -f "$base/missing" ]; then
        echo "not ok - $1: $(cat "$base/missing")"
        return
    elif [ "$kind" = untouched ]; then
        cp -R "$base/chapters" "$submission"
    elif [ "$kind" = nothing ]; then
        for file in $(key files "$base/assignment.ini"); do
            mkdir -p "$submission/${file%/*}"
            do_nothing "$base/$file" >"$submission/$file"
        done
    elif ! make_submission 2>"$here/complaint"; then
        echo "not ok - $1: it cannot be made: $(cat "$here/complaint")"
        return
    fi
    seconds=$(date +%s)
    TMPDIR=$scratch/$id "$build/grade" --base "$base" --seed-file "$work/seed" --one \
        --format text,gradescope -o "$here/out" "$submission" >"$here/said" 2>&1
    status=$?
    seconds=$(($(date +%s) - seconds))
    : >>"$here/out/result.txt"
    case $kind in
    wrong) judge_wrong ;;
    right | reference) judge_all pass ;;
    untouched) judge_all todo ;;
    nothing) judge_nothing ;;
    cheats) judge_cheat ;;
    esac >"$here/verdict"
    judge_grader "$status" >>"$here/verdict"
    if [ -s "$here/verdict" ]; then
        echo "not ok - $1: $(paste -s -d ';' "$here/verdict")"
        sed 's/^/    /' "$here/out/result.txt"
    else
        echo "ok - $1: $summary"
        [ -n "${KEEP-}" ] || rm -rf "$here"
    fi
}

# ---- All of them. ----

if [ "${1-}" = --one ] || [ "${1-}" = --section ]; then
    build=$2 work=$3 scratch=$4
    if [ "$1" = --section ]; then
        prepare_section "$5"
    else
        try_case "$5" >"$work/said.$$" 2>&1
        cat "$work/said.$$" # at once, not among the lines of another case
        rm "$work/said.$$"
    fi
    exit
fi

build=$(cd "${1:?usage: tests/grading/run.sh BUILD [CASE...]}" && pwd) || exit 2
shift
work=$build/grading
scratch=$(mktemp -d) || exit 2
chmod 755 "$scratch"
trap 'rm -rf "$scratch"' EXIT
trap 'exit 1' INT TERM
mkdir -p "$work/base"
echo 'the cases of verify-grading' >"$work/seed"

if [ $# -eq 0 ]; then
    for ini in chapters/*/exercises.ini; do
        section=${ini#chapters/}
        section=${section%%_*}
        set -- "$@" "untouched/$section" "nothing/$section" "reference/$section"
    done
    for ini in tests/grading/*/*/case.ini; do
        case=${ini#tests/grading/}
        set -- "$@" "${case%/case.ini}"
    done
fi

exercises=$(for case in "$@"; do
    if [ -f "tests/grading/$case/case.ini" ]; then
        key exercise "tests/grading/$case/case.ini"
    else
        echo "${case#*/}"
    fi
done | sort -u)
sections=$(echo "$exercises" | sed 's/-.*//' | sort -u)
rm -rf "${work:?}/base"
mkdir -p "$work/base"
echo "$sections" | xargs -n 1 -P 2 sh "$0" --section "$build" "$work" "$scratch"
for exercise in $exercises; do
    case $exercise in *-*) prepare_exercise "$exercise" ;; esac
done

printf '%s\n' "$@" | xargs -n 1 -P 2 sh "$0" --one "$build" "$work" "$scratch" |
    awk -v wanted=$# '
    { print }
    /^ok - / { passed++ }
    END {
        printf "%d passed, %d failed\n", passed, wanted - passed
        exit passed != wanted || wanted == 0
    }'
