#include "tools/grade/grade.h"
void viva(const grading *g, const char *id, const char *path) { (void)g; (void)id; (void)path; }
void pack_gradescope(const char *project, const char *base, const char *seed_file, const char *output) {(void)project;(void)base;(void)seed_file;(void)output;}
