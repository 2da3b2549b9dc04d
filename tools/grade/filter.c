/* filter.c - the system calls that a student's program may make.
 *
 * A filter is a small program that the kernel runs before each call: it loads words of
 * the call's number and arguments, compares, jumps forwards and returns what becomes
 * of the call. This one is a list of rules, one after the other; a call to which no
 * rule applies kills the process.
 */
#define _DEFAULT_SOURCE /* syscall, MAP_ANONYMOUS */
#include "tools/grade/confine.h"

#include <errno.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

/* The machines whose calls are known: numbers and arguments of 64 bits, the low word
 * first. */
#if defined __x86_64__ && !defined __ILP32__
#define MACHINE AUDIT_ARCH_X86_64
#elif defined __aarch64__ && defined __AARCH64EL__ && !defined __ILP32__
#define MACHINE AUDIT_ARCH_AARCH64
#endif

#ifndef MACHINE

/* On any other one this layer is off, as `jail --layers` says. */
bool
confine_seccomp(int binary, pid_t self)
{
    (void)binary, (void)self;
    return false;
}

#else

enum { EMPTY_PATH = 0x1000 }; /* AT_EMPTY_PATH: no name, the descriptor itself */

typedef enum when {
    ALWAYS,
    REFUSED,        /* fails with EPERM: the C library asks and lives without it */
    ANONYMOUS,      /* mmap: memory, no file, and no code */
    NO_CODE,        /* mprotect: not to execute */
    READ_OWN_LIMIT, /* prlimit64: of the caller, and nothing set */
    TO_ITSELF,      /* tgkill, tkill: how abort ends a process */
    THE_BINARY      /* execveat: the open descriptor, which closes then */
} when;

typedef struct rule {
    long call;
    when when;
} rule;

/* Numbers differ between machines, and some calls are on one only. */
static const rule rules[] = {
    {SYS_read, ALWAYS}, {SYS_write, ALWAYS}, {SYS_writev, ALWAYS},
    {SYS_close, ALWAYS}, {SYS_lseek, ALWAYS}, {SYS_fstat, ALWAYS},
    /* memory */
    {SYS_brk, ALWAYS}, {SYS_mmap, ANONYMOUS}, {SYS_munmap, ALWAYS},
    {SYS_mremap, ALWAYS}, {SYS_mprotect, NO_CODE}, {SYS_madvise, ALWAYS},
    /* the beginning, and exit; qsort asks sysinfo */
    {SYS_execveat, THE_BINARY}, {SYS_set_tid_address, ALWAYS},
    {SYS_set_robust_list, ALWAYS}, {SYS_getrandom, ALWAYS}, {SYS_uname, ALWAYS},
    {SYS_sysinfo, ALWAYS}, {SYS_prlimit64, READ_OWN_LIMIT},
    {SYS_clock_gettime, ALWAYS}, {SYS_exit, ALWAYS}, {SYS_exit_group, ALWAYS},
#ifdef SYS_arch_prctl
    {SYS_arch_prctl, ALWAYS},
#endif
#ifdef SYS_rseq
    {SYS_rseq, ALWAYS},
#endif
    /* assert and abort */
    {SYS_rt_sigaction, ALWAYS}, {SYS_rt_sigprocmask, ALWAYS},
    {SYS_rt_sigreturn, ALWAYS}, {SYS_getpid, ALWAYS}, {SYS_gettid, ALWAYS},
    {SYS_tgkill, TO_ITSELF}, {SYS_tkill, TO_ITSELF}, {SYS_futex, ALWAYS},
    /* what is asked of files on the way */
#ifdef SYS_readlink
    {SYS_readlink, REFUSED},
#endif
    {SYS_readlinkat, REFUSED}, {SYS_newfstatat, REFUSED}, {SYS_ioctl, REFUSED},
};
enum { RULES = sizeof rules / sizeof rules[0] };

/* ---- Writing the filter. ---- */

typedef struct filter {
    struct sock_filter at[16 * RULES];
    unsigned short length;
} filter;

static void
put(filter *f, unsigned code, uint32_t value, unsigned if_true, unsigned if_false)
{
    f->at[f->length++] = (struct sock_filter){
        (unsigned short)code, (unsigned char)if_true, (unsigned char)if_false, value};
}

static void
load(filter *f, size_t offset)
{
    put(f, BPF_LD | BPF_W | BPF_ABS, (uint32_t)offset, 0, 0);
}

static void
answer(filter *f, uint32_t action)
{
    put(f, BPF_RET | BPF_K, action, 0, 0);
}

/* A word of an argument: both machines have the low one first. */
enum { LOW = 0, HIGH = 4 };

static size_t
word(unsigned argument, unsigned half)
{
    return offsetof(struct seccomp_data, args) + 8 * argument + half;
}

/* The process dies unless the word, under the mask, is the value. */
static void
demand(filter *f, unsigned argument, unsigned half, uint32_t mask, uint32_t value)
{
    load(f, word(argument, half));
    put(f, BPF_ALU | BPF_AND | BPF_K, mask, 0, 0);
    put(f, BPF_JMP | BPF_JEQ | BPF_K, value, 1, 0);
    answer(f, SECCOMP_RET_KILL_PROCESS);
}

static void
demand_whole(filter *f, unsigned argument, uint32_t value)
{
    demand(f, argument, LOW, UINT32_MAX, value);
    demand(f, argument, HIGH, UINT32_MAX, 0);
}

/* What is demanded of a call that is allowed sometimes. */
static void
put_conditions(filter *f, when w, int binary, pid_t self)
{
    if (w == ANONYMOUS) {
        demand(f, 2, LOW, PROT_EXEC, 0);
        demand(f, 3, LOW, MAP_ANONYMOUS, MAP_ANONYMOUS);
    } else if (w == NO_CODE) {
        demand(f, 2, LOW, PROT_EXEC, 0);
    } else if (w == READ_OWN_LIMIT) {
        demand_whole(f, 0, 0);
        demand_whole(f, 2, 0);
    } else if (w == TO_ITSELF) {
        demand_whole(f, 0, (uint32_t)self);
    } else if (w == THE_BINARY) {
        demand_whole(f, 0, (uint32_t)binary);
        demand_whole(f, 4, EMPTY_PATH);
    }
}

/* One rule: it applies to its own call, and jumps over itself for the others. */
static void
put_rule(filter *f, rule r, int binary, pid_t self)
{
    load(f, offsetof(struct seccomp_data, nr));
    unsigned short jump = f->length;
    put(f, BPF_JMP | BPF_JEQ | BPF_K, (uint32_t)r.call, 0, 0);
    put_conditions(f, r.when, binary, self);
    answer(f, r.when == REFUSED ? SECCOMP_RET_ERRNO | EPERM : SECCOMP_RET_ALLOW);
    f->at[jump].jf = (unsigned char)(f->length - jump - 1);
}

bool
confine_seccomp(int binary, pid_t self)
{
    filter f = {.length = 0};
    load(&f, offsetof(struct seccomp_data, arch));
    put(&f, BPF_JMP | BPF_JEQ | BPF_K, MACHINE, 1, 0);
    answer(&f, SECCOMP_RET_KILL_PROCESS);
    for (size_t i = 0; i < RULES; i++)
        put_rule(&f, rules[i], binary, self);
    answer(&f, SECCOMP_RET_KILL_PROCESS);
    struct sock_fprog program = {f.length, f.at};
    return syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &program) == 0;
}

#endif
