static void
keep_tree(edge_list *edges, vertex_id *parent)
{
    uint32_t kept = 0;
    for (uint32_t i = 0; i < edges->count; i++) {
        vertex_id v = edges->ends[i][0], w = edges->ends[i][1];
        if (parent[v] == parent[w])
            continue;
        parent[w] = parent[v]; /* and those that w stood for? */
        edges->ends[kept][0] = v;
        edges->ends[kept++][1] = w;
    }
    edges->count = kept;
}
