/* qhull.c - Qhull (Barber, Dobkin, Huhdanpaa 1996): the hull of the lifted
 * points, in rounded arithmetic; what is nearly coplanar is merged, and
 * triangulated at the end.
 *
 * Needs: the package libqhull-dev.
 */
#include "lib/memory.h"
#include "tools/bench/peers/peer.h"

#include <libqhull_r/libqhull_r.h>
#include <stdio.h>

static const point2 *points;
static int count;
static qhT hull;
static bool made;
static FILE *advice; /* Qhull's page or two of why it has failed */

bool
peer_prepare(const point2 *given, uint32_t n, size_t rounds)
{
    (void)rounds;
    points = given;
    count = (int)n;
    advice = fopen("/dev/null", "w");
    return advice != NULL && n <= INT32_MAX;
}

static void
free_hull(void)
{
    int blocks, bytes;
    qh_freeqhull(&hull, !qh_ALL);
    qh_memfreeshort(&hull, &blocks, &bytes);
}

/* Qhull changes the points that it is given only with options that are not
 * these. */
bool
peer_round(void)
{
    static char command[] = "qhull d Qt Qbb Qc Qz";
    if (made)
        free_hull();
    made = true;
    qh_zero(&hull, advice);
    return qh_new_qhull(&hull, 2, count, (coordT *)(uintptr_t)points, False,
                        command, NULL, advice) == 0;
}

/* The lower side of the hull. Qhull names corners by the sign of the facet
 * (toporient): the order that is counterclockwise seen from above the
 * paraboloid. */
bool
peer_result(peer_answer *out)
{
    qhT *qh = &hull; /* the name that the macros of Qhull want */
    facetT *facet;
    vertexT *vertex, **vertexp;
    size_t room = 0;
    FORALLfacets {
        room += !facet->upperdelaunay;
    }
    out->list.corner = memory_array(room, sizeof *out->list.corner);
    if (out->list.corner == NULL)
        return false;
    FORALLfacets {
        if (facet->upperdelaunay)
            continue;
        vertex_id *corner = out->list.corner[out->list.count++];
        int i = 0;
        FOREACHvertex_(facet->vertices) {
            if (i < 3)
                corner[i++] = (vertex_id)qh_pointid(qh, vertex->point);
        }
        if (i != 3)
            return false;
        if (!facet->toporient) {
            vertex_id exchanged = corner[1];
            corner[1] = corner[2];
            corner[2] = exchanged;
        }
    }
    return true;
}
