/* triangulations.h - everything, with one include.
 *
 *     cc -I. program.c build/libtri.a -lm
 *
 * For C++, too, from C++17 on (predicates.h writes powers of two as 0x1p-51).
 */
#ifndef CHAPTERS_TRIANGULATIONS_H
#define CHAPTERS_TRIANGULATIONS_H

#ifdef __cplusplus
extern "C" {
#endif

#include "chapters/2.1_simplicial_complexes/complex.h"
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.1_voronoi_diagrams/voronoi.h"
#include "chapters/3.2_empty_circumcircle/empty_circle.h"
#include "chapters/3.2_empty_circumcircle/graphs.h"
#include "chapters/3.3_lifting_map/lifting.h"
#include "chapters/3.3_lifting_map/lower_hull.h"
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.5_edge_flips/flip_graph.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "chapters/3.6_randomized_incremental/biased_order.h"
#include "chapters/3.6_randomized_incremental/bucket_grid.h"
#include "chapters/3.6_randomized_incremental/incremental.h"
#include "chapters/3.7_divide_and_conquer/divide.h"
#include "chapters/3.7_divide_and_conquer/fast_divide.h"
#include "chapters/contents.h"
#include "lib/mesh.h"
#include "lib/options.h"
#include "lib/trace.h"

#ifdef __cplusplus
}
#endif

#endif
