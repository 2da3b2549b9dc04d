#!/bin/sh
# check.sh BUILD - all that can be checked without geometry: `make check` runs it.
#
# What the pages, the tests, the documents and the sources say of each other must be
# true. Each check is a function that prints what is wrong and what to do, a line each
# beginning with file:line where there is one, and fails if there is anything.
set -u
LC_ALL=C
export LC_ALL
build=${1:?usage: tools/check.sh BUILD, in the root of the project}
scratch=$build/check.$$
mkdir -p "$scratch" || exit 2
trap 'rm -rf "$scratch"' EXIT
trap 'exit 2' HUP INT TERM

# ---- What the others say, as tables of words. ---- #

# NAME FILE:LINE asserted|argued, for each claim that begins a paragraph or an item.
claims_of_pages() {
    awk '
    match($0, /^ *([-*] |[0-9]+\. )?\*\*[a-z][a-z0-9.]*\.P[0-9]+[a-z]?\.?\*\*/) {
        name = substr($0, 1, RLENGTH)
        rest = substr($0, RLENGTH + 1)
        gsub(/^[^a-z]*|\.?\*\*$/, "", name)
        print name, FILENAME ":" FNR, rest ~ /^ \(argued\)/ ? "argued" : "asserted"
    }' chapters/*/README.md
}

# NAME FILE:LINE, for each CLAIM and claim_verdict, which may be broken over lines.
claims_of_tests() {
    awk '
    BEGIN { RS = "\001" }
    {
        line = 1
        while (match($0, /(CLAIM|claim_verdict)\([ \n]*"[^"]+"/)) {
            name = substr($0, RSTART, RLENGTH)
            line += gsub(/\n/, "\n", name) + newlines(substr($0, 1, RSTART - 1))
            $0 = substr($0, RSTART + RLENGTH)
            split(name, part, "\"")
            print part[2], FILENAME ":" line
        }
    }
    function newlines(s) { return gsub(/\n/, "", s) }
    ' tests/*.c tests/oracle/*.c
}

# NUMBER FILE:LINE LAST-COLUMN, for each erratum.
errata() {
    awk -F' *[|] *' '/^\| E[0-9]+ \|/ {
        gsub(/`/, "", $(NF - 1)); print $2, FILENAME ":" FNR, $(NF - 1)
    }' docs/errata.md
}

# ID FILE:LINE SECTION CODE TEST STATUS, for each row of the map; "-" is an empty cell.
map_rows() {
    awk -F' *[|] *' '/^\|/ && !/^\|[- |]*$/ && $2 != "id" {
        if (NF != 9) { print $2, FILENAME ":" FNR, "broken"; next }
        for (i = 2; i < NF; i++) gsub(/ /, "_", $i)
        print $2, FILENAME ":" FNR, $3, $5, $6, $8
    }' docs/notes_map.md
}

# ---- The checks. ---- #

library_has_no_writable_globals() {
    nm -A -f sysv "$build/libtri.a" >"$scratch/symbols" || return 1
    awk -F' *[|] *' '
    $7 ~ /^\.(data|bss|tdata|tbss)/ && $7 !~ /^\.data\.rel\.ro/ || $7 ~ /COM/ {
        print $1 " is writable (" $7 "): make it const, or give it to the caller"
        bad = 1
    }
    END { exit bad }' "$scratch/symbols"
}

# A program may have set any locale. lib/decimal.c reads and writes numbers in all of
# them; the others ask it.
# shellcheck disable=SC2016 # the dollars are awk's
library_asks_no_locale() {
    nm -A -P "$build/libtri.a" >"$scratch/symbols" || return 1
    awk '
    function wrong(what) { print what ": leave it to lib/decimal.c"; bad = 1 }
    BEGIN {
        of_the_locale = "^(strto(d|f|ld)|atof|.*scanf|" \
            "__ctype_.*|is(alpha|digit|space|upper|lower)|to(upper|lower))$"
    }
    FILENAME ~ /symbols$/ {
        if ($3 == "U" && $1 !~ /[[]decimal[.]o[]]/ && $2 ~ of_the_locale)
            wrong($1 " " $2 " depends on the locale")
        next
    }
    FILENAME != "lib/decimal.c" && FILENAME !~ /figures[.]c$/ &&
    /"[^"]*%[-+ #0-9.*]*L?[aefgAEFG]/ {
        wrong(FILENAME ":" FNR ": printf writes the point of the locale")
    }
    END { exit bad }' "$scratch/symbols" lib/*.c chapters/*/*.c
}

# What others hand in (tests/grading/*/) may look as they like.
# shellcheck disable=SC2016 # the dollars are awk's
lines_fit() {
    find lib chapters tests tools -name '*.[ch]' ! -path 'tests/grading/*/*' |
        sort >"$scratch/files"
    xargs awk '
    length($0) > 88 { print FILENAME ":" FNR ": wider than 88 columns"; bad = 1 }
    END { exit bad }' <"$scratch/files"
}

claims_are_paired() {
    claims_of_pages >"$scratch/pages"
    claims_of_tests >"$scratch/tests"
    awk '
    function wrong(where, what) { print where ": " what; bad = 1 }
    FILENAME ~ /pages$/ {
        if ($1 in where)
            wrong($2, $1 " is also stated in " where[$1] "; number it anew")
        where[$1] = $2; how[$1] = $3; next
    }
    { tested[$1] = $2 }
    $1 ~ /\.P[0-9]+[a-z]?$/ && !($1 in where) && !said[$1]++ {
        wrong($2, $1 " stands on no page; state it there, in bold, and prove it")
    }
    END {
        for (name in where) {
            if (how[name] == "argued" && name in tested)
                wrong(where[name], name " is asserted in " tested[name] \
                    "; drop (argued)")
            if (how[name] == "asserted" && !(name in tested))
                wrong(where[name], name " is asserted by no test; add CLAIM(\"" name \
                    "\", ...), or write (argued) after the name")
        }
        exit bad
    }' "$scratch/pages" "$scratch/tests"
}

errata_are_paired() {
    errata >"$scratch/errata"
    claims_of_tests >"$scratch/tests"
    awk '
    function wrong(where, what) { print where ": " what; bad = 1 }
    FILENAME ~ /errata$/ {
        if ($1 in where) wrong($2, "the number " $1 " stands twice; choose another")
        where[$1] = $2; test[$1] = $3; next
    }
    $1 ~ /^E[0-9]+$/ {
        split($2, file, ":")
        if (index(asserted[$1] " ", " " file[1] " ") == 0)
            asserted[$1] = asserted[$1] " " file[1]
        if (!($1 in where)) wrong($2, $1 " has no row in docs/errata.md; add it")
    }
    END {
        for (e in where) {
            promised = test[e] != "planned" && test[e] != "argued"
            if (promised && index(asserted[e] " ", " " test[e] " ") == 0)
                wrong(where[e], e " is not asserted in " test[e] \
                    "; add CLAIM(\"" e "\", ...)")
            if (!promised && e in asserted)
                wrong(where[e], e " is asserted in" asserted[e] \
                    "; name it in the last column")
        }
        exit bad
    }' "$scratch/errata" "$scratch/tests"
}

# Where the paths of the map lead is for `weave --check` to say.
map_is_complete() {
    map_rows >"$scratch/map"
    for test in tests/[0-9]*.c; do
        grep -qF "$test" docs/notes_map.md ||
            echo "$test is in no row of docs/notes_map.md; add it to the rows it tests"
    done >"$scratch/missing"
    cat "$scratch/missing"
    awk '
    function wrong(what) { print $2 ": " what; bad = 1 }
    $3 == "broken" { wrong("the row has not seven cells"); next }
    seen[$1]++ { wrong("the id " $1 " stands twice; choose another") }
    $6 != "stands" && $6 != "planned" { wrong("the status is stands or planned") }
    $6 == "stands" && ($4 == "-" || $5 == "-") {
        wrong($1 " stands, but without code or test; name them, or write planned")
    }
    END { exit bad }' "$scratch/map" && [ ! -s "$scratch/missing" ]
}

glossary_names_exist() {
    awk -F'|' '/^\|/ { while (match($2, /`[^`]+`/)) {
        print substr($2, RSTART + 1, RLENGTH - 2), FILENAME ":" FNR
        $2 = substr($2, RSTART + RLENGTH)
    } }' docs/glossary.md >"$scratch/words"
    cat lib/*.h chapters/*.h chapters/*/*.h | tr -c 'A-Za-z0-9_' '\n' |
        sort -u >"$scratch/names"
    awk '
    FILENAME ~ /names$/ { name[$1] = 1; next }
    !($1 in name) { print $2 ": no header has the name " $1 "; correct it"; bad = 1 }
    END { exit bad }' "$scratch/names" "$scratch/words"
}

pictures_are_shown() {
    status=0
    for picture in chapters/*/figures/*.svg; do
        folder=${picture%/figures/*}
        [ -f "$picture" ] || continue
        grep -qF "figures/${picture##*/}" "$folder/README.md" && continue
        echo "$picture is shown on no page; show it in $folder/README.md or drop it"
        status=1
    done
    return $status
}

# Draws every figure again and compares the bytes with what is committed.
pictures_are_current() {
    status=0
    for source in chapters/*/figures.c; do
        folder=${source%/figures.c}
        section=${folder#chapters/}
        drawn=$scratch/figures/$section
        mkdir -p "$drawn"
        "${MAKE:-make}" -s BUILD="$build" "$build/figures/$section" &&
            "$build/figures/$section" "$drawn" || status=1
        for picture in "$drawn"/*.svg "$folder"/figures/*.svg; do
            [ -f "$picture" ] || continue
            name=${picture##*/}
            cmp -s "$drawn/$name" "$folder/figures/$name" && continue
            echo "$folder/figures/$name is not what $source draws; run make figures"
            status=1
        done
    done
    return $status
}

# A line that has been wrapped or renamed is no longer where a bug can be planted.
bugs_have_their_places() {
    status=0
    for bug in tests/mutants/*.mutant; do
        source=$(sed -n 's/^file: *//p' "$bug")
        awk -f tests/plant.awk "$bug" "$source" >"$scratch/planted" && continue
        echo "$bug cannot be planted in $source; correct its line replace:"
        status=1
    done
    return $status
}

# ---- One after the other. ---- #

passed=0
failed=0
check() {
    if "$2" >"$scratch/said" 2>&1; then
        passed=$((passed + 1))
        echo "ok     - $1"
    else
        failed=$((failed + 1))
        echo "not ok - $1"
        sort -u "$scratch/said" | sed 's/^/  /'
    fi
}
weave_check() { "$build/weave" --check; }
say_check() { "${0%/*}/book/say.sh" "$build" --check; }
deps() { "$build/deps"; }

check "the pages quote what the sources say, and their references lead somewhere" \
    weave_check
check "the pages show the steps that the algorithms take" say_check
check "lib, chapters and programs include only what they may" deps
check "the library has no writable globals" library_has_no_writable_globals
check "what the library reads and writes is the same in every locale" \
    library_asks_no_locale
check "no line of the sources is wider than 88 columns" lines_fit
check "each claim of a page is asserted by a test, and the other way round" \
    claims_are_paired
check "each erratum with a witness has a test, and the other way round" \
    errata_are_paired
check "the map of the notes has every test, and code for all that stands" \
    map_is_complete
check "the names in the glossary exist" glossary_names_exist
check "every picture is shown on its page" pictures_are_shown
check "every picture is what its program draws" pictures_are_current
check "every bug of tests/mutants can be planted" bugs_have_their_places

echo "to come: $(map_rows | grep -c ' planned$') rows of the map," \
    "$(errata | grep -c ' planned$') errata"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
