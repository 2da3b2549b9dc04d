/* confine.c - the layers of the jail, but for the filter of system calls. */
#define _DEFAULT_SOURCE /* setgroups, syscall */
#include "tools/grade/confine.h"

#include <fcntl.h>
#include <grp.h>
#include <stdint.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

bool
confine_user(void)
{
    return geteuid() == 0 && setgroups(0, NULL) == 0 &&
        setgid(JAIL_USER) == 0 && setuid(JAIL_USER) == 0;
}

bool
confine_privileges(void)
{
    return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0;
}

/* ---- Landlock. ---- */

/* Numbers are spelled out: the headers of a system can be older than its kernel, and
 * what a version forbids is known by its number only. */
enum { CREATE_RULESET = 444, ADD_RULE = 445, RESTRICT_SELF = 446 };

enum {
    EXECUTE = 1, WRITE_FILE = 2, READ_FILE = 4, READ_DIR = 8, REMOVE_DIR = 16,
    REMOVE_FILE = 32, MAKE_DIR = 128, MAKE_REG = 256, TRUNCATE = 1 << 14,
    READING = EXECUTE | READ_FILE | READ_DIR,
    WRITING = READING | WRITE_FILE | REMOVE_DIR | REMOVE_FILE | MAKE_DIR | MAKE_REG |
              TRUNCATE,
    OF_A_FILE = EXECUTE | WRITE_FILE | READ_FILE | TRUNCATE
};

typedef struct ruleset {
    uint64_t files;  /* from version 1 */
    uint64_t net;    /* from version 4: binding and connecting sockets */
    uint64_t scoped; /* from version 6: abstract sockets and signals */
} ruleset;

typedef struct beneath {
    uint64_t allowed;
    int32_t folder;
} __attribute__((packed)) beneath;

int
landlock_version(void)
{
    long version = syscall(CREATE_RULESET, NULL, 0, 1);
    return version > 0 ? (int)version : 0;
}

/* All that the kernel's version can forbid, and how long its structure is. */
static ruleset
everything(int version, size_t *size)
{
    uint64_t bits = version >= 5 ? 16 : version >= 3 ? 15 : version == 2 ? 14 : 13;
    *size = version >= 6 ? 24 : version >= 4 ? 16 : 8;
    return (ruleset){((uint64_t)1 << bits) - 1, 3, 3};
}

/* A rule for what can be opened; one for a path that is not there is none. */
static bool
add_rule(int rules, uint64_t handled, opening o)
{
    int folder = open(o.path, O_RDONLY | O_CLOEXEC);
    struct stat about;
    if (folder < 0)
        return true;
    beneath b = {o.write ? WRITING : READING, folder};
    if (fstat(folder, &about) == 0 && !S_ISDIR(about.st_mode))
        b.allowed &= OF_A_FILE;
    b.allowed &= handled;
    bool added = syscall(ADD_RULE, rules, 1, &b, 0) == 0;
    close(folder);
    return added;
}

bool
confine_landlock(const opening *open, size_t count)
{
    int version = landlock_version();
    if (version == 0)
        return false;
    size_t size;
    ruleset forbidden = everything(version, &size);
    int rules = (int)syscall(CREATE_RULESET, &forbidden, size, 0);
    bool on = rules >= 0;
    for (size_t i = 0; on && i < count; i++)
        on = add_rule(rules, forbidden.files, open[i]);
    on = on && syscall(RESTRICT_SELF, rules, 0) == 0;
    if (rules >= 0)
        close(rules);
    return on;
}

/* ---- Limits. ---- */

/* A limit that stood lower before stays. */
static bool
limit(int resource, rlim_t most)
{
    struct rlimit r;
    if (getrlimit(resource, &r) != 0)
        return false;
    if (most > r.rlim_max)
        most = r.rlim_max;
    return setrlimit(resource, &(struct rlimit){most, most}) == 0;
}

/* The first limit of time is a signal that says so, SIGXCPU; the second, a second
 * later, is one that cannot be caught. */
static bool
limit_time(rlim_t seconds)
{
    return limit(RLIMIT_CPU, seconds + 1) &&
        setrlimit(RLIMIT_CPU, &(struct rlimit){seconds, seconds + 1}) == 0;
}

bool
confine_limits(limits most)
{
    const rlim_t megabyte = (rlim_t)1 << 20, stack = 8;
    bool set = limit_time(most.cpu_seconds) &&
        limit(RLIMIT_AS, most.megabytes * megabyte) &&
        limit(RLIMIT_FSIZE, most.file_megabytes * megabyte) &&
        limit(RLIMIT_NOFILE, most.files) && limit(RLIMIT_STACK, stack * megabyte) &&
        limit(RLIMIT_CORE, 0);
    return set && (!most.alone || limit(RLIMIT_NPROC, 0));
}
