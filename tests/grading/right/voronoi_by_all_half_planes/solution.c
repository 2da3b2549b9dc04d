/* Do the regions of p and q have an edge in common, of all sites up to `last`? */
static bool
is_neighbour(const point2 *points, vertex_id p, vertex_id q, const vertex_id *site,
             uint32_t sites)
{
    for (uint32_t i = 0; i < sites; i++) {
        vertex_id a = site[i];
        int side = orient2d(points[p], points[q], points[a]);
        if (side == 0 && a != q && dot_sign(points[p], points[a], points[q]) < 0)
            return false;
        if (side == 0 && a != q && same_side(points[p], points[a], points[q]) &&
            compare_distance(points[p], points[a], points[p], points[q]) <= 0)
            return false;
        for (uint32_t k = 0; side > 0 && k < sites; k++)
            if (orient2d(points[p], points[q], points[site[k]]) < 0 &&
                incircle(points[p], points[q], points[a], points[site[k]]) >= 0)
                return false;
    }
    return true;
}

static void
cut(builder *b, const point2 *points, vertex_id p, vertex_id q)
{
    vertex_id *site = b->turned;
    uint32_t sites = b->region.size, kept = 0;
    for (uint32_t i = 0; i < sites; i++) {
        site[i] = b->region.neighbour[i];
        if (compare_along(along_x, points[site[i]], points[q]) == 0)
            return;
    }
    site[sites++] = q;
    for (uint32_t i = 0; i < sites; i++) {
        if (!is_neighbour(points, p, site[i], site, sites))
            continue;
        uint32_t k = kept++; /* insert it in the order of the directions */
        for (; k > 1 && compare_turn(points[p], points[b->region.neighbour[0]],
                                     points[b->region.neighbour[k - 1]], points[site[i]]) > 0; k--)
            b->region.neighbour[k] = b->region.neighbour[k - 1];
        b->region.neighbour[k] = site[i];
    }
    b->region.size = kept;
}
