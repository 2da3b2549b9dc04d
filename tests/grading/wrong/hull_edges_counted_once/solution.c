static uint32_t
walk_length(const plane_graph *g, halfedge_id h)
{
    uint32_t sides = 0;
    halfedge_id s = h;
    do {
        halfedge_id t = h;
        while (t != s && t / 2 != s / 2) /* is the edge there already? */
            t = g->next[t];
        sides += t == s;
        s = g->next[s];
    } while (s != h);
    return sides;
}
