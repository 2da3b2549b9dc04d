/* confine.h - the layers of the jail: what a process gives up, for good.
 *
 * Needs: a Linux kernel; no library. Each layer is put on by the process itself, in
 * the order below, and can never be taken off again. None is trusted alone: a program
 * that gets through one of them is still held by the others.
 *
 *   user      root becomes a user without name, files or other processes
 *   landlock  files may be opened below the given folders only (Linux 5.13)
 *   limits    time, memory, sizes of files, numbers of files and processes
 *   seccomp   system calls outside a short list kill the process (Linux 3.17)
 */
#ifndef TOOLS_GRADE_CONFINE_H
#define TOOLS_GRADE_CONFINE_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

/* Debian gives this number to nobody: it owns no file and runs no process. */
enum { JAIL_USER = 65533 };

/* Layers as bits: which are on. */
enum { LAYER_USER = 1, LAYER_LANDLOCK = 2, LAYER_LIMITS = 4, LAYER_SECCOMP = 8 };

typedef struct limits {
    unsigned cpu_seconds;
    unsigned megabytes;       /* of address space */
    unsigned file_megabytes;  /* 0: no file can grow */
    unsigned files;           /* descriptors below this number */
    bool alone;               /* no further process or thread */
} limits;

/* Folders and files that can still be opened. */
typedef struct opening {
    const char *path;
    bool write; /* false: to read and to execute */
} opening;

/* Root becomes JAIL_USER. False when this is not root, or may not. */
bool confine_user(void);

/* From now on no program gains rights by being executed; landlock and seccomp need it.
 * False when the kernel refuses. */
bool confine_privileges(void);

/* Only `open[0 .. count-1]` can be opened; those that do not exist are skipped. No
 * rule at all: nothing can. False when the kernel has no Landlock.
 * Requires: confine_privileges. */
bool confine_landlock(const opening *open, size_t count);

/* The version of Landlock in the kernel; 0: none. */
int landlock_version(void);

/* True unless the kernel refuses a limit. */
bool confine_limits(limits most);

/* What is left is arithmetic, memory, the descriptors that are open, and an end by
 * assert or a trap; and `binary` can be executed, once if it closes then.
 * False when the kernel or the machine has no filters.
 * Requires: confine_privileges. */
bool confine_seccomp(int binary, pid_t self);

#endif
