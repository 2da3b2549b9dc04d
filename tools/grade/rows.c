/* rows.c - the table of a class, with a row for each submission. */
#include "tools/grade/rows.h"

#include "lib/output.h"
#include "tools/grade/clean.h"
#include "tools/handout/basics.h"

#include <string.h>

static void
write_head(FILE *file, const assignment *a)
{
    fprintf(file, "submission,score,total,state");
    for (size_t p = 0; p < a->properties; p++)
        fprintf(file, ",%s %s", a->property[p].of->exercise, a->property[p].name);
    putc('\n', file);
}

/* Where not one of the files could be used, somebody should look. */
static const char *
state_of(const assignment *a, const submission *s, const result *r)
{
    bool refused = true;
    for (size_t p = 0; p < a->properties; p++)
        refused = refused && strcmp(r->mark[p].word, "refused") == 0;
    return s->path == NULL ? "missing" : refused ? "refused" : "graded";
}

/* A score that the grader owes is an empty cell, and not 0. */
static void
write_row(FILE *file, const assignment *a, const submission *s, const result *r)
{
    print_csv(file, r->name);
    if (r->fault != NULL)
        fprintf(file, ",,%d,infra_error", a->total);
    else
        fprintf(file, ",%d,%d,%s", result_score(a, r), a->total, state_of(a, s, r));
    for (size_t p = 0; p < a->properties; p++)
        if (r->fault != NULL)
            putc(',', file);
        else
            fprintf(file, ",%d", mark_earned(&r->mark[p]) ? a->property[p].points : 0);
    putc('\n', file);
}

static const char *
row_path(const grading *g, const submission *s)
{
    return format("%s/%s.row", g->work, s->name);
}

void
row_leave(const grading *g, const submission *s, const result *r)
{
    FILE *file = fopen(row_path(g, s), "w");
    if (file == NULL)
        give_up(row_path(g, s));
    write_row(file, &g->asked, s, r);
    if (fclose(file) != 0)
        give_up(row_path(g, s));
}

void
rows_join(const grading *g, const class *c, const char *path)
{
    output o;
    if (output_begin(&o, path) != TRI_OK)
        give_up(path);
    write_head(o.file, &g->asked);
    for (size_t i = 0; i < c->count; i++)
        fputs(file_bytes(row_path(g, &c->at[i]), NULL), o.file);
    if (output_commit(&o) != TRI_OK)
        give_up(path);
}
