/* attack.c - tries to get out of the jail; tests/tools_jail.c runs it there.
 *
 * The argument says what to try. Exit status 40: it did not work, and the program still
 * lives; 41: it worked. What it prints says more.
 */
#define _GNU_SOURCE
#include <assert.h>
#include <errno.h>
#include <fcntl.h>
#include <grp.h>
#include <sched.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/auxv.h>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

static const char *what;

static int
is(const char *name)
{
    return strcmp(what, name) == 0;
}

/* How a system call went. */
static int
says(long result)
{
    printf("%s: %ld, errno %d\n", what, result, errno);
    return result < 0 ? 40 : 41;
}

/* ---- What an honest program does, and a careless one. ---- */

static int
order(const void *a, const void *b)
{
    const int *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

static int
honest(void)
{
    enum { N = 1000000 };
    int *a = malloc(N * sizeof *a), sorted = 1;
    char c[8];
    for (int i = 0; i < N; i++)
        a[i] = rand();
    qsort(a, N, sizeof *a, order);
    for (int i = 1; i < N; i++)
        sorted &= a[i - 1] <= a[i];
    free(a);
    fprintf(stderr, "to people\n");
    printf("sorted %d\n", sorted);
    return read(3, c, 8) == 8 && write(4, c, 8) == 8 ? 0 : 9;
}

static int
deep(volatile int *up)
{
    volatile int here[1000];
    here[0] = *up ^ 1;
    if (here[0] == 2) /* it is 0 or 1 */
        return 0;
    return deep(here) ^ here[0];
}

static int
careless(void)
{
    volatile int most = 0x7fffffff, zero = 0;
    volatile size_t nowhere = 64;
    if (is("exit"))
        return 42;
    if (is("assert"))
        assert(what[0] == 'b');
    if (is("overflow"))
        most = most + 1;
    if (is("pointer"))
        return *(volatile char *)nowhere;
    if (is("recursion"))
        return deep(&zero);
    return -1;
}

/* ---- More than its share. ---- */

static void
ignore(int signal_number)
{
    (void)signal_number;
}

static int
greedy(void)
{
    char c[16] = "";
    if (is("hog")) {
        for (int megabytes = 0; megabytes < 600; megabytes++)
            if (calloc(1 << 20, 1) == NULL)
                return 40;
        return 41;
    }
    if (is("stubborn"))
        signal(SIGXCPU, ignore);
    if (is("name")) {
        printf("%d\n", (int)getpid());
        fflush(stdout);
    }
    if (is("loop") || is("stubborn") || is("name"))
        for (volatile unsigned i = 0;; i++)
            ;
    if (is("stop"))
        raise(SIGSTOP);
    if (is("flood"))
        for (;;)
            if (write(1, c, sizeof c) < 0)
                return 40;
    return -1;
}

/* ---- What it was left. ---- */

static int
curious(void)
{
    char c;
    if (is("environment"))
        return environ[0] != NULL ? 41 : 40;
    if (is("user"))
        return getauxval(AT_UID) == 0 ? 41 : 40;
    if (is("inherited")) {
        for (int d = 5; d < 100; d++)
            if (read(d, &c, 1) >= 0)
                return 41;
        return read(0, &c, 1) == 0 ? 40 : 41;
    }
    return -1;
}

/* ---- Files, processes, code. ---- */

static int
files(void)
{
    if (is("open"))
        return says(open("/etc/passwd", O_RDONLY));
    if (is("create"))
        return says(open("loot", O_WRONLY | O_CREAT, 0666));
    if (is("unlink"))
        return says(unlink("treasure"));
    if (is("chmod"))
        return says(chmod("treasure", 0));
    if (is("list"))
        return says(open(".", O_RDONLY | O_DIRECTORY));
    if (is("memfd"))
        return says(memfd_create("x", 0));
    if (is("dup"))
        return says(dup(1));
    if (is("mount"))
        return says(syscall(SYS_mount, 0, 0, 0, 0, 0));
    if (is("socket"))
        return says(socket(AF_INET, SOCK_STREAM, 0));
    return -1;
}

static int
run_thread(void *nothing)
{
    (void)nothing;
    return 0;
}

static int
processes(int other)
{
    static char stack[1 << 14];
    const struct rlimit most = {1 << 20, 1 << 20};
    if (is("fork")) {
        pid_t child = fork();
        if (child == 0)
            _exit(0);
        return says(child);
    }
    if (is("thread"))
        return says(clone(run_thread, stack + sizeof stack,
                          CLONE_VM | CLONE_SIGHAND | CLONE_THREAD, NULL));
    if (is("parent"))
        return says(kill(getppid(), SIGKILL));
    if (is("all"))
        return says(kill(-1, SIGKILL));
    if (is("other"))
        return says(syscall(SYS_tgkill, other, other, SIGKILL));
    if (is("ptrace"))
        return says(ptrace(PTRACE_ATTACH, other, NULL, NULL));
    if (is("peek"))
        return says(syscall(SYS_process_vm_readv, other, 0, 0, 0, 0, 0));
    if (is("prlimit"))
        return says(prlimit(other, RLIMIT_CPU, &most, NULL));
    if (is("raise"))
        return says(setrlimit(RLIMIT_AS, &most));
    if (is("nice"))
        return says(setpriority(PRIO_PROCESS, 0, 19));
    if (is("sleep"))
        return says(sleep(100));
    if (is("unshare"))
        return says(unshare(CLONE_NEWUSER));
    if (is("session"))
        return says(setsid());
    return -1;
}

static int
code(char **argv)
{
    const int all = PROT_READ | PROT_WRITE | PROT_EXEC;
    static char page[1 << 14];
    if (is("exec"))
        return says(execl("/bin/sh", "sh", "-c", "", NULL));
    if (is("again")) /* the descriptor from which it was started */
        return says(syscall(SYS_execveat, 5, "", argv, environ, AT_EMPTY_PATH));
    if (is("path"))
        return says(syscall(SYS_execveat, 5, "/bin/sh", argv, environ, 0));
    if (is("code"))
        return says((long)mmap(NULL, 4096, all, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
    if (is("protect"))
        return says(mprotect(page + 4096 - (size_t)page % 4096, 4096, all));
#ifdef __x86_64__
    if (is("x32")) /* the same calls under other numbers */
        return says(syscall(0x40000000 + SYS_getpid));
    if (is("i386")) { /* getpid is 20 there, and 20 is writev here */
        long result = 20;
        __asm__ volatile("int $0x80" : "+a"(result) : : "memory");
        return says(result);
    }
#endif
    return -1;
}

int
main(int argc, char **argv)
{
    what = argc > 1 ? argv[1] : "nothing";
    if (is("honest"))
        return honest();
    if (is("as_nobody")) { /* for the test itself: what follows, as another user */
        if (setgroups(0, NULL) != 0 || setgid(65534) != 0 || setuid(65534) != 0)
            return 8;
        return execvp(argv[2], argv + 2);
    }
    int other = argc > 2 ? atoi(argv[2]) : 1;
    int results[] = {careless(), greedy(), curious(), files(), processes(other),
                     code(argv)};
    for (int i = 0; i < 6; i++)
        if (results[i] >= 0)
            return results[i];
    return 99; /* there is no such attempt */
}
