/* waiting.h - into which of the new triangles does a point go that waits?
 *
 * Notes: section 3.6.4. Needs: 3.4, lib/mesh.h.
 *
 * When triangles are destroyed and others take their place, the new ones have a
 * corner s in common and are divided by rays from s. Where a waiting point goes
 * is decided by the side of these rays on which it lies. Buckets ask at once,
 * the history graph when the point's turn has come; they ask the same.
 *
 * Outside of the hull, too, every point has its triangle. Let o be the first vertex.
 * The ghost triangle of a hull edge is what lies behind it, seen from o, and the ray
 * from s to GHOST runs straight away from o. If o is on the hull itself, what lies
 * behind o belongs to one or the other of the hull edges at o.
 */
#ifndef CHAPTERS_3_6_WAITING_H
#define CHAPTERS_3_6_WAITING_H

#include "lib/mesh.h"

/* Two triangles divided by the ray from s to w: does q go to the left one?
 *
 * `right` is the third corner of the triangle on the right. It matters if w is GHOST
 * and q in line with the ray, as on a path: then the left one gets what does not lie
 * towards `right`.
 * Requires: q lies in one of the two, or on their sides.
 * Cost: 1 orientation test, and another one in that case.
 */
bool goes_left(const point2 *points, vertex_id o, vertex_id s, vertex_id w,
               vertex_id right, vertex_id q);

/* Three triangles around s, divided by the rays to ray[0], ray[1], ray[2], which
 * are in counterclockwise order: returns the i for which q goes to the triangle
 * between ray[i] and the ray after it.
 *
 * Cost: 3 orientation tests.
 */
int goes_between(const point2 *points, vertex_id o, vertex_id s,
                 const vertex_id ray[3], vertex_id q);

#endif
