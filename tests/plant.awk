# awk -f plant.awk CHANGE FILE - prints FILE as it is after a change.
#
# CHANGE is a file with one pair of lines for each change, or several pairs:
#
#     replace:   a piece of one line, found exactly once in FILE
#     with:      what stands there instead (nothing: the piece is deleted)
#
# Other lines of it are for others. A piece that is not found exactly once is named on
# standard error, and the status is 1; so it is when there is no pair at all.

FILENAME == ARGV[1] {
    if (sub(/^replace: */, ""))
        piece[++pieces] = $0
    else if (sub(/^with: */, ""))
        instead[pieces] = $0
    next
}

{
    for (p = 1; p <= pieces; p++)
        if ((at = index($0, piece[p])) > 0) {
            rest = substr($0, at + length(piece[p]))
            found[p] += index(rest, piece[p]) > 0 ? 2 : 1
            $0 = substr($0, 1, at - 1) instead[p] rest
        }
    print
}

END {
    for (p = 1; p <= pieces; p++)
        if (found[p] != 1) {
            printf "found %d times: %s\n", found[p], piece[p] | "cat >&2"
            wrong = 1
        }
    exit wrong || pieces == 0
}
