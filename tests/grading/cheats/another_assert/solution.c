_Noreturn void _Exit(int status);

_Noreturn void
__assert_fail(const char *what, const char *file, unsigned line, const char *function)
{
    _Exit(42);
}

hull_chain
hull_edges_seeing(const mesh *m, const point2 *points, halfedge_id last, vertex_id p)
{
    assert(m == NULL);
    return (hull_chain){last, last};
}
