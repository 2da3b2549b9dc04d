/* fast_share.c - threads that take one task after the other. */
#include "chapters/3.7_divide_and_conquer/fast_share.h"

#ifdef FAST_THREADS
#include <threads.h>
#endif

typedef struct crew {
    fast_work *work;
    uint32_t tasks;
    fast_count taken;
} crew;

static int
help(void *shared)
{
    crew *c = shared;
    for (;;) {
        uint32_t number = fast_count_up(&c->taken);
        if (number >= c->tasks)
            return 0;
        c->work->task(c->work, number);
    }
}

void
fast_share(fast_work *work, uint32_t tasks, uint32_t threads)
{
    crew c = {.work = work, .tasks = tasks};
#ifdef FAST_THREADS
    thrd_t helper[FAST_MOST_THREADS];
    uint32_t helpers = 0;
    while (helpers + 1 < threads && helpers + 1 < tasks &&
           helpers < FAST_MOST_THREADS &&
           thrd_create(&helper[helpers], help, &c) == thrd_success)
        helpers++;
    help(&c);
    for (uint32_t i = 0; i < helpers; i++)
        thrd_join(helper[i], NULL);
#else
    (void)threads;
    help(&c);
#endif
}
