/* fast_share.h - work in numbered tasks, shared by threads; no program includes it.
 *
 * Notes: section 3.7. Needs: nothing.
 *
 * C11 threads, where the compiler has them; without them everything is done by the
 * caller. Nothing here depends on who does what, and a thread that cannot be had is
 * done without.
 */
#ifndef CHAPTERS_3_7_FAST_SHARE_H
#define CHAPTERS_3_7_FAST_SHARE_H

#include <stdint.h>

#if !defined __STDC_NO_THREADS__ && !defined __STDC_NO_ATOMICS__
#define FAST_THREADS
#include <stdatomic.h>
typedef atomic_uint fast_count;
#else
typedef unsigned fast_count;
#endif

enum { FAST_MOST_THREADS = 64 }; /* more are not used */

/* What is to be done: a struct that begins with this one and adds what the tasks
 * need. */
typedef struct fast_work {
    void (*task)(struct fast_work *self, uint32_t number);
} fast_work;

/* Does tasks 0 .. tasks-1, each once, by up to that many threads, the caller included;
 * returns when all are done. Requires: threads >= 1. */
void fast_share(fast_work *work, uint32_t tasks, uint32_t threads);

/* Of `count` things, task number `task` of `tasks` begins with this one, and ends
 * before that of the next task. */
static inline uint32_t
fast_begin(uint32_t task, uint32_t tasks, uint32_t count)
{
    return (uint32_t)((uint64_t)count * task / tasks);
}

/* Adds 1 and returns what was there before: in one step, whoever else does the same. */
static inline unsigned
fast_count_up(fast_count *count)
{
#ifdef FAST_THREADS
    return atomic_fetch_add(count, 1);
#else
    return (*count)++;
#endif
}

#endif
