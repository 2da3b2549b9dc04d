static char pool[1 << 24];
static unsigned long used;

void *
malloc(unsigned long size)
{
    void *block = pool + used;
    used += size / 16 * 16 + 16;
    return used < sizeof pool ? block : (void *)0;
}

void *
calloc(unsigned long count, unsigned long size)
{
    return malloc(count * size);
}

void *
realloc(void *block, unsigned long size)
{
    char *larger = malloc(size);
    for (unsigned long i = 0; i < size && block != (void *)0 && (char *)block + i < pool + used; i++)
        larger[i] = ((char *)block)[i];
    return larger;
}

void
free(void *block)
{
}

hull_chain
hull_edges_seeing(const mesh *m, const point2 *points, halfedge_id last, vertex_id p)
{
    for (unsigned long i = 0; i + 8 < used; i += 8)
        if (*(uint64_t *)(pool + i) == 0) /* whatever is there is a number of points */
            *(uint64_t *)(pool + i) = 1;
    return (hull_chain){last, last};
}
