/* memory.c - checked allocation; in the counted build, allocation that can fail. */
#include "lib/memory.h"

#include <stdint.h>
#include <stdlib.h>

#ifdef TRI_COUNTED
static unsigned long allocations_left; /* until the one that fails; 0: none fails */

void
memory_fail_at(unsigned long k)
{
    allocations_left = k;
}

static int
must_fail(void)
{
    return allocations_left != 0 && --allocations_left == 0;
}
#else
static int
must_fail(void)
{
    return 0;
}
#endif

void *
memory_array(size_t count, size_t size)
{
    return memory_resize(NULL, count, size);
}

void *
memory_resize(void *array, size_t count, size_t size)
{
    if (must_fail() || (size != 0 && count > SIZE_MAX / size))
        return NULL;
    size_t bytes = count * size;
    return realloc(array, bytes != 0 ? bytes : 1);
}

void
memory_free(void *array)
{
    free(array);
}
