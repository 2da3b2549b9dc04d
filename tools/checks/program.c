/* program.c - starting a student's program, feeding it, and outliving it. */
#include "tools/checks/program.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/* ---- Starting and ending. ---- */

static _Noreturn void
fault(const char *what)
{
    perror(what);
    exit(1);
}

/* Moves a descriptor out of the way of 0 to 4, and closes it in programs started
 * later. */
static int
set_apart(int descriptor)
{
    int moved = fcntl(descriptor, F_DUPFD_CLOEXEC, 10);
    if (moved < 0)
        fault("checker: no descriptor");
    close(descriptor);
    return moved;
}

static void
open_pipe(int ends[2])
{
    if (pipe(ends) != 0)
        fault("checker: no pipe");
    ends[0] = set_apart(ends[0]);
    ends[1] = set_apart(ends[1]);
}

static void
start(program *p)
{
    int to[2], from[2], chatter[2];
    open_pipe(to);
    open_pipe(from);
    open_pipe(chatter);
    p->said_count = 0;
    p->pid = fork();
    if (p->pid < 0)
        fault("checker: no process");
    if (p->pid == 0) {
        setpgid(0, 0);
        int nothing = open("/dev/null", O_RDONLY);
        dup2(nothing, 0);
        dup2(chatter[1], 1);
        dup2(chatter[1], 2);
        dup2(to[0], WIRE_FROM_CHECKER);
        dup2(from[1], WIRE_TO_CHECKER);
        execvp(p->command[0], p->command);
        perror(p->command[0]);
        _exit(127);
    }
    setpgid(p->pid, p->pid);
    close(to[0]);
    close(from[1]);
    close(chatter[1]);
    p->to = to[1];
    p->from = from[0];
    p->chatter = chatter[0];
    fcntl(p->to, F_SETFL, O_NONBLOCK);
    fcntl(p->chatter, F_SETFL, O_NONBLOCK);
}

/* Keeps the last 4 KB of what the program says to people. */
static void
listen_to(program *p)
{
    char heard[1024];
    for (int blocks = 0; blocks < 64; blocks++) { /* a flood is not our business */
        ssize_t got = read(p->chatter, heard, sizeof heard);
        if (got <= 0)
            return;
        size_t count = (size_t)got, most = sizeof p->said - 1;
        if (p->said_count + count > most) {
            size_t gone = p->said_count + count - most;
            memmove(p->said, p->said + gone, p->said_count - gone);
            p->said_count -= gone;
        }
        memcpy(p->said + p->said_count, heard, count);
        p->said_count += count;
    }
}

void
program_end(program *p)
{
    if (p->pid == 0)
        return;
    kill(-p->pid, SIGKILL);
    while (waitpid(p->pid, &p->status, 0) < 0 && errno == EINTR)
        ;
    listen_to(p);
    p->said[p->said_count] = '\0';
    close(p->to);
    close(p->from);
    close(p->chatter);
    p->pid = 0;
}

/* The program has closed its end: how did it come to that? Its death is waited for
 * a moment, so that its signal is known and not that of program_end. */
static fate
how_it_ended(program *p)
{
    for (int wait = 0; wait < 200; wait++) {
        pid_t pid = waitpid(p->pid, &p->status, WNOHANG);
        if (pid == p->pid) {
            int status = p->status;
            listen_to(p);
            p->said[p->said_count] = '\0';
            kill(-p->pid, SIGKILL); /* what it has left behind */
            close(p->to);
            close(p->from);
            close(p->chatter);
            p->pid = 0;
            int signal = WIFSIGNALED(status) ? WTERMSIG(status)
                         : WIFEXITED(status) && WEXITSTATUS(status) > 128
                             ? WEXITSTATUS(status) - 128
                             : 0;
            switch (signal) {
            case 0: return FATE_ENDED;
            case SIGABRT: return FATE_ASSERT;
            case SIGILL:
            case SIGTRAP: return FATE_UNDEFINED;
            case SIGSYS: return FATE_FORBIDDEN;
            case SIGXCPU:
            case SIGKILL: return FATE_TIMEOUT;
            default: return FATE_CRASH;
            }
        }
        struct timespec moment = {0, 5000000};
        nanosleep(&moment, NULL);
    }
    program_end(p);
    return FATE_ENDED;
}

/* ---- Talking. ---- */

static double
clock_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Waits until something can be read or written; false when the time is over. */
static bool
wait_for(program *p, bool writing, double deadline)
{
    for (;;) {
        double left = deadline - clock_now();
        if (left <= 0)
            return false;
        struct pollfd ends[2] = {{.fd = p->chatter, .events = POLLIN},
                                 {.fd = writing ? p->to : p->from,
                                  .events = writing ? POLLOUT : POLLIN}};
        int ready = poll(ends, 2, (int)(1000 * left) + 1);
        if (ready < 0 && errno != EINTR)
            return false;
        if (ready > 0 && ends[0].revents != 0)
            listen_to(p);
        if (ready > 0 && ends[1].revents != 0)
            return true;
        if (ready > 0 && (ends[0].revents & POLLHUP) != 0) {
            /* it closed its standard error, not the conversation: no busy waiting */
            struct timespec moment = {0, 1000000};
            nanosleep(&moment, NULL);
        }
    }
}

/* FATE_ANSWERED when all of it went through. */
static fate
send_bytes(program *p, const void *bytes, size_t count, double deadline)
{
    const char *next = bytes;
    while (count > 0) {
        ssize_t written = write(p->to, next, count);
        if (written > 0) {
            next += written;
            count -= (size_t)written;
        } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
            if (!wait_for(p, true, deadline))
                return FATE_TIMEOUT;
        } else if (errno != EINTR) {
            return how_it_ended(p);
        }
    }
    return FATE_ANSWERED;
}

static fate
receive_bytes(program *p, void *bytes, size_t count, double deadline)
{
    char *next = bytes;
    while (count > 0) {
        if (!wait_for(p, false, deadline))
            return FATE_TIMEOUT;
        ssize_t got = read(p->from, next, count);
        if (got == 0)
            return how_it_ended(p);
        if (got > 0) {
            next += got;
            count -= (size_t)got;
        } else if (errno != EINTR) {
            return how_it_ended(p);
        }
    }
    return FATE_ANSWERED;
}

/* ---- Questions. ---- */

/* Where the point with this ticket is; false: nobody has such a ticket. */
static bool
site_of(const questions *q, const uint64_t word[2], site *found)
{
    double x = real_of_word(word[0]), y = real_of_word(word[1]);
    if (q->owner == NULL || !(x >= 0 && x < q->n) || x != (uint32_t)x || y != 0)
        return false;
    *found = q->at[q->owner[(uint32_t)x]];
    return true;
}

/* A direction is what it is: small integers, or nothing. */
static bool
direction_of(const uint64_t word[2], site *found)
{
    double x = real_of_word(word[0]), y = real_of_word(word[1]);
    if (!(x >= -PLANE_REACH && x <= PLANE_REACH && y >= -PLANE_REACH &&
          y <= PLANE_REACH))
        return false;
    *found = (site){(int32_t)x, (int32_t)y};
    return found->x == x && found->y == y;
}

static bool
find_sites(const questions *q, wire_kind kind, const uint64_t *word, uint32_t count,
           site s[4])
{
    for (uint32_t i = 0; i < count; i++)
        if (kind == WIRE_ALONG && i == 0 ? !direction_of(word, &s[0])
                                         : !site_of(q, word + 2 * i, &s[i]))
            return false;
    return true;
}

/* The reply to a question; false when it is none. */
static bool
reply_to(questions *q, wire_kind kind, const uint64_t *word, size_t count,
         int64_t *reply)
{
    site s[4];
    if (kind == WIRE_RANDOM) {
        if (count != 1 || word[0] == 0 || word[0] > UINT32_MAX)
            return false;
        *reply = q->drawn < q->choices ? (int64_t)q->chosen[q->drawn] : 0;
        q->below[q->drawn++] = (uint32_t)word[0];
        return true;
    }
    size_t points = kind == WIRE_INCIRCLE || kind == WIRE_DISTANCE ? 4 : 3;
    if (count != 2 * points || !find_sites(q, kind, word, (uint32_t)points, s))
        return false;
    switch (kind) {
    case WIRE_ORIENT: *reply = plane_orient(s[0], s[1], s[2]); break;
    case WIRE_INCIRCLE: *reply = plane_incircle(s[0], s[1], s[2], s[3]); break;
    case WIRE_ALONG: *reply = plane_along(s[0], s[1], s[2]); break;
    case WIRE_DOT: *reply = plane_dot(s[0], s[1], s[2]); break;
    case WIRE_DISTANCE: {
        int64_t left = plane_length2(s[0], s[1]), right = plane_length2(s[2], s[3]);
        *reply = (left > right) - (left < right);
        break;
    }
    default: return false;
    }
    q->asked[kind]++;
    return true;
}

/* Reads messages and replies to them, up to the answer. */
static fate
converse(program *p, questions *q, double deadline, words *answer)
{
    for (;;) {
        uint64_t head[2];
        fate f = receive_bytes(p, head, sizeof head, deadline);
        if (f != FATE_ANSWERED)
            return f;
        if (head[0] >= WIRE_KINDS || head[1] > WIRE_MOST_WORDS)
            return FATE_MALFORMED;
        words_clear(answer);
        for (uint64_t i = 0; i < head[1]; i++)
            words_put(answer, 0);
        f = receive_bytes(p, answer->word, head[1] * sizeof *answer->word, deadline);
        if (f != FATE_ANSWERED)
            return f;
        if (head[0] == WIRE_ANSWER)
            return FATE_ANSWERED;
        if (head[0] == WIRE_TODO)
            return FATE_TODO;
        if (head[0] == WIRE_RANDOM && q->drawn == MOST_DRAWN)
            return FATE_TIMEOUT; /* it may never be content */
        int64_t reply;
        if (!reply_to(q, (wire_kind)head[0], answer->word, answer->count, &reply))
            return FATE_MALFORMED;
        const uint64_t message[3] = {WIRE_SIGN, 1, (uint64_t)reply};
        f = send_bytes(p, message, sizeof message, deadline);
        if (f != FATE_ANSWERED)
            return f;
    }
}

fate
program_ask(program *p, const words *given, questions *q, double seconds, words *answer)
{
    double deadline = clock_now() + seconds;
    if (p->pid == 0)
        start(p);
    const uint64_t head[2] = {WIRE_CASE, given->count};
    fate f = send_bytes(p, head, sizeof head, deadline);
    if (f == FATE_ANSWERED)
        f = send_bytes(p, given->word, given->count * sizeof *given->word, deadline);
    if (f == FATE_ANSWERED)
        f = converse(p, q, deadline, answer);
    if (f != FATE_ANSWERED)
        program_end(p);
    return f;
}

/* ---- In words. ---- */

const char *
fate_text(fate f)
{
    switch (f) {
    case FATE_ANSWERED: return "it answered";
    case FATE_TODO: return "the function still says TODO: nothing has been written yet";
    case FATE_CRASH:
        return "the program crashed: most often an index outside an array or "
               "a pointer that points nowhere";
    case FATE_ASSERT: return "an assertion failed: a function was called with what its "
                             "header does not allow";
    case FATE_UNDEFINED: return "undefined behaviour was trapped: an integer that "
                                "overflows, a shift too far, a null pointer";
    case FATE_TIMEOUT:
        return "no answer came in time: an endless loop, or far too many "
               "steps";
    case FATE_ENDED: return "the program ended without an answer";
    case FATE_MALFORMED: return "the program sent something that is no answer and no "
                                "question";
    case FATE_FORBIDDEN: return "the program tried something that a solution does not "
                                "need (a file, a process, the network) and was stopped";
    }
    return "";
}

const char *
fate_word(fate f)
{
    static const char *const word[] = {"answered", "todo",     "crash",
                                       "assert",   "undefined", "timeout",
                                       "noanswer", "malformed", "forbidden"};
    return word[f];
}

const char *
fate_verb(fate f)
{
    static const char *const verb[] = {"fails",
                                       "is still to be written",
                                       "crashes",
                                       "stops at an assertion",
                                       "does what C does not define",
                                       "does not answer in time",
                                       "ends without an answer",
                                       "sends what is no answer",
                                       "tries what is forbidden"};
    return verb[f];
}
