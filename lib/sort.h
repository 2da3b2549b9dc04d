/* sort.h - sorting by whole numbers, in linear time.
 *
 * Needs: nothing. Used by the checks, which sort coordinates and edges; sorting
 * points along a direction is an algorithm of the notes and stands in 2.3.
 */
#ifndef LIB_SORT_H
#define LIB_SORT_H

#include <stddef.h>
#include <stdint.h>

typedef struct sort_item {
    uint64_t key;
    uint32_t id; /* travels with the key */
} sort_item;

/* Sorts item[0..n) by key; items with equal keys keep their order.
 * Requires: room for n items in scratch. Cost: O(n). Source: radix sort. */
void sort_by_key(sort_item *item, sort_item *scratch, size_t n);

/* A key that orders finite doubles as < does; -0 and +0 have the same one. */
uint64_t sort_key_of(double x);

#endif
