/* lib/memory: sizes are checked, and the k-th allocation fails when it is told to.
 *
 * Hypotheses: none.
 */
#include "lib/memory.h"

#include "tests/harness/harness.h"

#include <string.h>

static void
sizes_are_checked(void)
{
    void *nothing = memory_array(0, 8);
    CLAIM("memory_array", nothing != NULL, "NULL for no items");
    memory_free(nothing);
    memory_free(NULL);
    for (size_t size = 2; size != 0; size *= 2) {
        /* in size_t the products are 0 and `size`, which would be granted */
        size_t count = SIZE_MAX / size + 1;
        CLAIM("memory_array", memory_array(count, size) == NULL,
              "%zu items of %zu bytes", count, size);
        CLAIM("memory_array", memory_array(count + 1, size) == NULL,
              "%zu items of %zu bytes", count + 1, size);
    }
}

static void
resizing_keeps_what_was_there(void)
{
    random_source *r = test_random_source();
    for (int i = 0; i < 1000; i++) {
        uint32_t before = random_below(r, 100), after = random_below(r, 100);
        unsigned char *array = memory_array(before, 1);
        for (uint32_t k = 0; k < before; k++)
            array[k] = (unsigned char)k;

        void *none = memory_resize(array, SIZE_MAX / 2, 4);
        CLAIM("memory_resize", none == NULL, "room for half of all addresses");
        unsigned char *resized = memory_resize(array, after, 1);
        CLAIM("memory_resize", resized != NULL, "no room for %u bytes",
              (unsigned)after);
        for (uint32_t k = 0; k < before && k < after; k++)
            CLAIM("memory_resize", resized[k] == k, "byte %u has changed", (unsigned)k);
        memory_free(resized);
    }
}

/* Of five allocations the k-th fails, and no other. */
static void
the_kth_allocation_fails(void)
{
    for (unsigned long k = 0; k <= 6; k++) {
        memory_fail_at(k);
        for (unsigned long i = 1; i <= 5; i++) {
            void *array = i % 2 == 0 ? memory_array(1, 1) : memory_resize(NULL, 1, 1);
            CLAIM("memory_fail_at", (array == NULL) == (i == k),
                  "allocation %lu when %lu shall fail", i, k);
            memory_free(array);
        }
    }
    memory_fail_at(0);
    char *text = memory_array(7, 1);
    strcpy(text, "stands");
    memory_fail_at(1);
    CLAIM("memory_resize", memory_resize(text, 60, 1) == NULL, "it did not fail");
    CLAIM("memory_resize", strcmp(text, "stands") == 0, "the old array is lost");
    memory_free(text);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "lib/memory: checked sizes, and failure on demand");
    test_run("sizes are checked", sizes_are_checked);
    test_run("resizing keeps what was there", resizing_keeps_what_was_there);
    test_run("the k-th allocation fails", the_kth_allocation_fails);
    return test_end((test_minima){.trials = 3});
}
