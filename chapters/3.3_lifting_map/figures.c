/* figures.c - the pictures of section 3.3, in space where they need to be. What
 * is drawn is what the code answers: signs, faces of hulls, triangulations.
 */
#include "chapters/3.3_lifting_map/lifting.h"
#include "chapters/3.3_lifting_map/lower_hull.h"

#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/figures.h"
#include "lib/random.h"
#include "lib/svg.h"
#include "lib/svg_write.h"

/* ---- Looking at space, obliquely from above. ---- */

/* A direction of looking. */
typedef struct view {
    double right_x, right_y; /* how far x = 1 and y = 1 are to the right */
    double tilt, rise; /* how far up 1 away from us appears, and 1 upwards */
    double plane;      /* the height at which the plane of the sites is drawn */
} view;

static const view figure7 = {0.96, -0.28, 0.34, 0.94, -0.95};
static const view figure8 = {0.94, -0.34, 0.42, 1.02, -1.0};

/* How far p is from us, but for a constant. */
static double
depth(const view *v, point2 p)
{
    return p.y * v->right_x - p.x * v->right_y;
}

static point2
seen_at(const view *v, point2 p, double z)
{
    return (point2){p.x * v->right_x + p.y * v->right_y,
                    depth(v, p) * v->tilt + z * v->rise};
}

/* Site p in its plane. */
static point2
on_plane(const view *v, point2 p)
{
    return seen_at(v, p, v->plane);
}

/* The lifted p. */
static point2
on_bowl(const view *v, point2 p)
{
    return seen_at(v, p, lift(p).z);
}

/* ---- Curves and areas that svg.h does not have. ---- */

enum { ARC = 72 }; /* points on a full turn */

/* Points on a circle, 5 degrees apart. */
static void
circle_points(point2 centre, double radius, point2 *p)
{
    double x = radius, y = 0;
    for (int i = 0; i < ARC; i++) {
        p[i] = (point2){centre.x + x, centre.y + y};
        double turned = 0.99619469809174553 * x - 0.08715574274765818 * y;
        y = 0.08715574274765818 * x + 0.99619469809174553 * y;
        x = turned;
    }
}

/* A path through points of the picture, with these attributes. */
static void
draw_path(svg *page, const point2 *p, int n, bool closed,
          const char *attributes)
{
    fprintf(page->file, "<path %s d=\"", attributes);
    for (int i = 0; i < n; i++)
        svg_put_step(page->file, i == 0 ? 'M' : 'L', svg_place(page, p[i]));
    fputs(closed ? "z\"/>\n" : "\"/>\n", page->file);
}

/* The circle of sites, in their plane or lifted. */
static void
draw_circle(svg *page, const view *v, point2 centre, double radius, bool lifted,
            const char *attributes)
{
    point2 p[ARC];
    circle_points(centre, radius, p);
    for (int i = 0; i < ARC; i++)
        p[i] = lifted ? on_bowl(v, p[i]) : on_plane(v, p[i]);
    draw_path(page, p, ARC, true, attributes);
}

/* ---- Figure 7: the paraboloid, a circle, and its plane. ---- */

static const double rim = 1.2;
static const point2 origin = {0, 0};

/* The paraboloid up to its rim, seen from the side and a little from above. */
static void
draw_bowl(svg *page, const view *v)
{
    /* For each x across, what appears lowest is where the bowl turns away. */
    point2 outline[2 * ARC];
    int n = 0;
    double away = -v->tilt / (2 * v->rise);
    double half = sqrt(rim * rim - away * away);
    for (int i = 0; i <= 40; i++) {
        double x = half * (i - 20) / 20;
        outline[n++] =
            (point2){x, away * v->tilt + (x * x + away * away) * v->rise};
    }
    point2 top[ARC]; /* then back along the far side of the rim */
    circle_points(origin, rim, top);
    for (int i = 0; i < ARC; i++)
        top[i] = (point2){top[i].x, top[i].y * v->tilt + rim * rim * v->rise};
    draw_path(page, top, ARC, true, "class=\"box plain\" fill-opacity=\".05\"");
    for (int i = 0; i < ARC / 2; i++)
        outline[n++] = top[i];
    draw_path(page, outline, n, true,
              "class=\"box plain\" fill-opacity=\".08\"");
    draw_path(page, outline, 41, false, "class=\"plain\"");
    for (int i = 1; i <= 4; i++)
        draw_circle(page, v, origin, rim * sqrt(i / 4.0), true,
                    i == 4 ? "class=\"plain\"" : "class=\"faint\"");
    point2 spoke[ARC], line[33];
    circle_points(origin, rim, spoke);
    for (int k = 0; k < ARC / 2; k += 6) {
        for (int i = 0; i <= 32; i++) {
            double t = (i - 16) / 16.0;
            line[i] = on_bowl(v, (point2){t * spoke[k].x, t * spoke[k].y});
        }
        draw_path(page, line, 33, false, "class=\"faint\"");
    }
}

/* The circle of Figure 7, with a, b, c on it. */
static const point2 centre = {0.2, -0.1};
static const double radius = 0.62;

/* The height over p of the plane of the lifted circle (page 3.3, prop1.P1). */
static double
plane_height(point2 p)
{
    double c2 = centre.x * centre.x + centre.y * centre.y;
    return 2 * (centre.x * p.x + centre.y * p.y) - c2 + radius * radius;
}

/* A square of the plane, or of the sites' plane below it. */
static void
draw_square(svg *page, const view *v, point2 middle, double half, bool lifted,
            const char *attributes)
{
    point2 corner[4];
    for (int i = 0; i < 4; i++) {
        point2 p = {middle.x + (i == 1 || i == 2 ? half : -half),
                    middle.y + (i < 2 ? -half : half)};
        corner[i] = seen_at(v, p, lifted ? plane_height(p) : v->plane);
    }
    draw_path(page, corner, 4, true, attributes);
}

static void
draw_lifting_panel(svg *page, const point2 site[4])
{
    static const char *const name[] = {"a", "b", "c", "d"};
    static const char *const lifted_name[] = {"a⁺", "b⁺", "c⁺", "d⁺"};
    const view *v = &figure7;
    int below = orient3d_lifted(site[0], site[1], site[2], site[3]);
    svg_panel(page, (svg_box){{-1.35, -1.3}, {1.35, 1.8}}, 60,
              below > 0 ? "d inside the circle: d⁺ below the plane"
                        : "d outside the circle: d⁺ above the plane");

    draw_square(page, v, origin, 1.02, false,
                "class=\"box plain\" fill-opacity=\".07\"");
    draw_circle(page, v, centre, radius, false,
                "class=\"box new\" fill-opacity=\".12\"");
    draw_circle(page, v, centre, radius, false, "class=\"new\"");
    draw_bowl(page, v);
    draw_square(page, v, centre, 0.8, true,
                "class=\"box mark\" fill-opacity=\".3\"");
    draw_circle(page, v, centre, radius, true, "class=\"new\"");
    for (int i = 0; i < 4; i++)
        svg_segment(page, on_plane(v, site[i]), on_bowl(v, site[i]), SVG_FAINT);
    point2 foot[4], head[4];
    for (int i = 0; i < 4; i++) {
        foot[i] = on_plane(v, site[i]);
        head[i] = on_bowl(v, site[i]);
    }
    point2 in_plane = seen_at(v, site[3], plane_height(site[3]));
    svg_segment(page, head[3], in_plane, below > 0 ? SVG_GOOD : SVG_BAD);
    svg_points(page, &in_plane, 1, SVG_PLAIN);
    svg_points(page, foot, 4, SVG_STRONG);
    svg_points(page, head, 3, SVG_NEW);
    svg_points(page, head + 3, 1, SVG_STRONG);
    for (int i = 0; i < 4; i++) {
        svg_label(page, foot[i], name[i], SVG_STRONG);
        svg_label(page, head[i], lifted_name[i], SVG_STRONG);
    }
}

static void
draw_lifting(FILE *file)
{
    /* 3-4-5 triangles put a, b, c on the circle. */
    const double r = radius / 5;
    point2 site[4] = {{centre.x - 4 * r, centre.y - 3 * r},
                      {centre.x + 5 * r, centre.y},
                      {centre.x - 3 * r, centre.y + 4 * r},
                      {centre.x + 0.15, centre.y - 0.1}};
    svg page;
    svg_begin(
        &page, file, (svg_layout){2, 1, 400, 460, 1},
        "Figure 7 and Proposition 1: a circle lifts into a plane",
        "A bowl, the paraboloid, stands over the plane of the sites. The "
        "circle through a, b and c, lifted to the bowl, is an ellipse: the "
        "plane through the three lifted points cuts it out. Left, d lies "
        "inside the circle, and lifted it is below that plane. Right, d lies "
        "outside, and lifted it is above.");
    draw_lifting_panel(&page, site);
    site[3] = (point2){-0.5, 0.42};
    draw_lifting_panel(&page, site);
    svg_end(&page);
}

/* ---- Figure 8: a lower hull above its projection. ---- */

/* Faces of a hull that are drawn in space, the farthest first. */
typedef struct surface {
    const view *v;
    const point2 *site;
    triangle_list faces;
} surface;

/* Three times how far the middle of a face is. */
static double
depth_of_face(const surface *s, const vertex_id *c)
{
    return depth(s->v, s->site[c[0]]) + depth(s->v, s->site[c[1]]) +
           depth(s->v, s->site[c[2]]);
}

static void
sort_by_depth(surface *s)
{
    vertex_id(*corner)[3] = s->faces.corner;
    for (uint32_t i = 1; i < s->faces.count; i++)
        for (uint32_t k = i; k > 0 && depth_of_face(s, corner[k - 1]) <
                                          depth_of_face(s, corner[k]);
             k--)
            for (int j = 0; j < 3; j++) {
                vertex_id other = corner[k][j];
                corner[k][j] = corner[k - 1][j];
                corner[k - 1][j] = other;
            }
}

/* How bright a face is: lit from the left, as the slope of its plane says. */
static double
shade(const surface *s, const vertex_id *c)
{
    point3 a = lift(s->site[c[0]]), b = lift(s->site[c[1]]);
    point3 d = lift(s->site[c[2]]);
    double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
    double vx = d.x - a.x, vy = d.y - a.y, vz = d.z - a.z;
    double nx = uy * vz - uz * vy, ny = uz * vx - ux * vz;
    double nz = ux * vy - uy * vx;
    double length = sqrt(nx * nx + ny * ny + nz * nz);
    return (0.75 * nx - 0.35 * ny + 0.55 * nz) / length;
}

/* Does face c, or its lifted copy below or above, change with site p? */
static bool
changes(const surface *s, const vertex_id *c, vertex_id p)
{
    if (p == NONE)
        return false;
    if (c[0] == p || c[1] == p || c[2] == p)
        return true;
    return orient3d_lifted(s->site[c[0]], s->site[c[1]], s->site[c[2]],
                           s->site[p]) > 0;
}

/* The faces lifted, and below them their projections; those that p sees or is a
 * corner of are orange. Vertical lines join the sites to their lifted ones. */
static void
draw_surface(svg *page, surface *s, uint32_t n, vertex_id p)
{
    sort_by_depth(s);
    for (uint32_t t = 0; t < s->faces.count; t++) {
        const vertex_id *c = s->faces.corner[t];
        point2 corner[3];
        for (int i = 0; i < 3; i++)
            corner[i] = on_plane(s->v, s->site[c[i]]);
        draw_path(page, corner, 3, true,
                  changes(s, c, p) ? "class=\"box mark\" fill-opacity=\".45\""
                                   : "class=\"box new\" fill-opacity=\".1\"");
        draw_path(page, corner, 3, true, "class=\"plain\"");
    }
    for (vertex_id i = 0; i < n; i++)
        svg_segment(page, on_plane(s->v, s->site[i]), on_bowl(s->v, s->site[i]),
                    SVG_FAINT);
    for (uint32_t t = 0; t < s->faces.count; t++) {
        const vertex_id *c = s->faces.corner[t];
        point2 corner[3];
        for (int i = 0; i < 3; i++)
            corner[i] = on_bowl(s->v, s->site[c[i]]);
        char fill[80];
        int percent = (int)(45 - 35 * shade(s, c));
        snprintf(fill, sizeof fill, "class=\"box %s\" fill-opacity=\".%02d\"",
                 changes(s, c, p) ? "mark" : "new", percent);
        draw_path(page, corner, 3, true,
                  "class=\"paper\" style=\"stroke:none\"");
        draw_path(page, corner, 3, true, fill);
        draw_path(page, corner, 3, true, "class=\"plain\"");
    }
}

/* Is the lifted p behind a face? Then the picture of the face covers it, and
 * the face is nearer. */
static bool
is_hidden(const surface *s, vertex_id p)
{
    point2 at = on_bowl(s->v, s->site[p]);
    for (uint32_t t = 0; t < s->faces.count; t++) {
        const vertex_id *c = s->faces.corner[t];
        point2 corner[3];
        for (int i = 0; i < 3; i++)
            corner[i] = on_bowl(s->v, s->site[c[i]]);
        int turn = orient2d(corner[0], corner[1], corner[2]);
        bool covers = true;
        for (int i = 0; i < 3; i++)
            covers =
                covers && orient2d(corner[i], corner[(i + 1) % 3], at) == turn;
        if (covers && depth_of_face(s, c) < 3 * depth(s->v, s->site[p]))
            return true;
    }
    return false;
}

/* The sites, and the lifted ones that can be seen. */
static void
draw_sites(svg *page, const surface *s, uint32_t n)
{
    for (vertex_id p = 0; p < n; p++) {
        const point2 both[2] = {on_plane(s->v, s->site[p]),
                                on_bowl(s->v, s->site[p])};
        svg_points(page, both, is_hidden(s, p) ? 1 : 2, SVG_STRONG);
    }
}

/* Random sites in the unit disc, none near another. */
static void
random_sites(point2 *site, uint32_t n, uint64_t seed, double apart)
{
    random_source r = random_from_seed(seed);
    for (uint32_t i = 0; i < n;) {
        double x = 2 * random_unit(&r) - 1, y = 2 * random_unit(&r) - 1;
        bool free = x * x + y * y <= 1;
        for (uint32_t k = 0; k < i; k++) {
            double dx = x - site[k].x, dy = y - site[k].y;
            free = free && dx * dx + dy * dy > apart * apart;
        }
        if (free)
            site[i++] = (point2){x, y};
    }
}

/* The lower faces of the first n sites. */
static triangle_list
lower_faces_of(const point2 *site, uint32_t n)
{
    vertex_id L[64];
    uint32_t u;
    lifted_hull H;
    triangle_list lower;
    must(sort_along(site, n, (point2){1, 0}, L, &u), "sort_along");
    must(lifted_hull_of(&H, site, n, L, u), "lifted_hull_of");
    must(lower_faces(&H, &lower), "lower_faces");
    lifted_hull_free(&H);
    return lower;
}

static svg_box
box_of_surface(const view *v, const point2 *site, uint32_t n)
{
    point2 seen[128];
    for (uint32_t i = 0; i < n; i++) {
        seen[2 * i] = on_plane(v, site[i]);
        seen[2 * i + 1] = on_bowl(v, site[i]);
    }
    return svg_box_of(seen, 2 * n);
}

static void
draw_lower_hull(FILE *file)
{
    enum { SITES = 32 };
    point2 site[SITES];
    random_sites(site, SITES, 8, 0.2);
    surface s = {&figure8, site, lower_faces_of(site, SITES)};
    svg_box box = box_of_surface(s.v, site, SITES);
    svg page;
    svg_begin(
        &page, file, (svg_layout){1, 1, 560, 620, 1},
        "Figure 8: the lower hull of the lifted sites, above its projection",
        "Below, sites in the plane with their Delaunay triangulation. Above "
        "each site hangs its lifted point, joined to it by a vertical line. "
        "The triangles between the lifted points make a faceted bowl, the "
        "underside of their convex hull.");
    svg_panel(&page, box, 2 * SITES,
              "the lower hull of V⁺, and below it its projection: "
              "the Delaunay triangulation of V");
    draw_surface(&page, &s, SITES, NONE);
    draw_sites(&page, &s, SITES);
    svg_end(&page);
    triangle_list_free(&s.faces);
}

/* ---- One more point. ---- */

static void
draw_step_panel(svg *page, svg_box box, const point2 *site, uint32_t n,
                uint32_t so_far, const char *caption)
{
    surface s = {&figure8, site, lower_faces_of(site, so_far)};
    svg_panel(page, box, 60, caption);
    draw_surface(page, &s, n, n - 1);
    draw_sites(page, &s, n);
    svg_label(page, on_plane(s.v, site[n - 1]), "p", SVG_STRONG);
    svg_label(page, on_bowl(s.v, site[n - 1]), "p⁺", SVG_STRONG);
    triangle_list_free(&s.faces);
}

static void
draw_step(FILE *file)
{
    enum { SITES = 15 };
    point2 site[SITES];
    random_sites(site, SITES - 1, 3, 0.36);
    site[SITES - 1] = (point2){-0.05, -0.5};
    svg_box box = box_of_surface(&figure8, site, SITES);
    svg page;
    svg_begin(
        &page, file, (svg_layout){2, 1, 400, 450, 1},
        "One more point: the faces that it sees are replaced",
        "Left, a faceted bowl over its projection, and below the bowl one more "
        "lifted point. The faces that have it on their outer side are orange; "
        "in the projection they are the triangles whose circles contain the "
        "site. Right, they are gone, and faces at the new point stand in their "
        "place.");
    draw_step_panel(&page, box, site, SITES, SITES - 1,
                    "Step 1: p⁺ sees the orange faces");
    draw_step_panel(&page, box, site, SITES, SITES,
                    "Steps 2 and 3: faces at p⁺ instead");
    svg_end(&page);
}

/* ---- Both sides of the hull. ---- */

static void
draw_both_sides(FILE *file)
{
    enum { SITES = 24 };
    point2 site[SITES];
    vertex_id L[SITES];
    uint32_t u;
    random_sites(site, SITES, 21, 0.2);
    lifted_hull H;
    triangle_list side[2];
    must(sort_along(site, SITES, (point2){1, 0}, L, &u), "sort_along");
    must(lifted_hull_of(&H, site, SITES, L, u), "lifted_hull_of");
    must(lower_faces(&H, &side[0]), "lower_faces");
    must(upper_faces(&H, &side[1]), "upper_faces");
    lifted_hull_free(&H);

    const char *const what[] = {"lower faces: no site in any circle",
                                "upper faces: all sites in each circle"};
    svg page;
    svg_begin(
        &page, file, (svg_layout){2, 1, 330, 330, 1},
        "The lower and the upper faces of the lifted hull, projected",
        "Left, the lower faces: the Delaunay triangulation, whose circles are "
        "empty. Right, the upper faces: a triangulation of the corners of the "
        "convex hull only, whose circles contain all sites.");
    for (int k = 0; k < 2; k++) {
        char caption[80];
        snprintf(caption, sizeof caption, "%u %s", (unsigned)side[k].count,
                 what[k]);
        svg_panel(&page, (svg_box){{-1.2, -1.2}, {1.2, 1.2}}, 2 * SITES,
                  caption);
        for (uint32_t t = 0; t < side[k].count; t++) {
            const vertex_id *c = side[k].corner[t];
            svg_circle(&page, site[c[0]], site[c[1]], site[c[2]], SVG_FAINT);
        }
        svg_triangles(&page, site, side[k], k == 0 ? SVG_STRONG : SVG_NEW);
        svg_points(&page, site, SITES, SVG_STRONG);
        triangle_list_free(&side[k]);
    }
    svg_end(&page);
}

/* ---- The lift, rounded. ---- */

enum { SQUARES = 100, DRAWN = 30 };

/* Square (i, j) from the left and from below: the sign of its fourth corner
 * against the plane of the three others, lifted in doubles. */
static int
sign_of_square(int i, int j)
{
    double x = 1024.1 + i, y = 1024.3 + j;
    return below_plane_rounded((point2){x, y}, (point2){x + 1, y},
                               (point2){x + 1, y + 1}, (point2){x, y + 1});
}

static void
draw_squares_panel(svg *page)
{
    uint32_t wrong = 0;
    for (int i = 0; i < SQUARES; i++)
        for (int j = 0; j < SQUARES; j++)
            wrong += sign_of_square(i, j) != 0;
    char caption[120];
    snprintf(caption, sizeof caption,
             "%u of %u unit squares: wrong. These are %u by %u;\n"
             "blue +1, orange -1, white 0, which is right",
             (unsigned)wrong, (unsigned)(SQUARES * SQUARES), (unsigned)DRAWN,
             (unsigned)DRAWN);
    svg_panel(page, (svg_box){{0, 0}, {DRAWN, DRAWN}}, 10000, caption);
    for (int j = 0; j < DRAWN; j++)
        for (int i = 0; i < DRAWN; i++) {
            svg_box square = {{i, j}, {i + 1, j + 1}};
            int sign = sign_of_square(i, j);
            if (sign != 0)
                svg_rectangle(page, square, sign > 0 ? SVG_NEW : SVG_MARK);
        }
}

/* Would rounded lifts call this edge of a Delaunay triangulation wrong, asked
 * from one side or from the other? */
static bool
seems_not_convex(const mesh *m, const point2 *site, halfedge_id ab)
{
    if (!mesh_is_interior(m, ab))
        return false;
    point2 a = site[mesh_origin(m, ab)], b = site[mesh_dest(m, ab)];
    point2 c = site[mesh_apex(m, ab)], d = site[mesh_apex(m, mesh_twin(m, ab))];
    return below_plane_rounded(a, b, c, d) > 0 ||
           below_plane_rounded(b, a, d, c) > 0;
}

/* The Delaunay triangulation of sites far from the origin; red are the edges
 * that would not be convex if lifts were rounded. */
static void
draw_far_sites_panel(svg *page)
{
    enum { SITES = 60 };
    point2 site[SITES];
    random_sites(site, SITES, 5, 0.12);
    for (int i = 0; i < SITES; i++)
        site[i] = (point2){1.6e7 + site[i].x, 1.6e7 + site[i].y};
    mesh m;
    must(lift_triangulate(site, SITES, NULL, &m), "lift_triangulate");
    uint32_t inner = 0, wrong = 0;
    for (halfedge_id ab = 0; ab < mesh_halfedges(&m); ab++) {
        inner += mesh_is_interior(&m, ab) && ab < mesh_twin(&m, ab);
        wrong += seems_not_convex(&m, site, ab) && ab < mesh_twin(&m, ab);
    }
    char caption[120];
    snprintf(caption, sizeof caption,
             "a Delaunay triangulation near (16000000, 16000000):\n"
             "rounded, %u of %u inner edges seem not convex",
             (unsigned)wrong, (unsigned)inner);
    svg_panel(page, svg_box_of(site, SITES), SITES, caption);
    svg_mesh(page, site, &m);
    for (halfedge_id ab = 0; ab < mesh_halfedges(&m); ab++)
        if (seems_not_convex(&m, site, ab) && ab < mesh_twin(&m, ab))
            svg_segment(page, site[mesh_origin(&m, ab)],
                        site[mesh_dest(&m, ab)], SVG_BAD);
    svg_points(page, site, SITES, SVG_STRONG);
    mesh_free(&m);
}

static void
draw_rounded(FILE *file)
{
    svg page;
    svg_begin(
        &page, file, (svg_layout){2, 1, 380, 380, 2},
        "What rounding the lift does",
        "Left, a square of 30 by 30 unit squares. The four corners of each are "
        "cocircular, but most of the signs that rounded lifts give are not 0. "
        "Right, a Delaunay triangulation of 60 sites in a disc far from the "
        "origin, with the edges in red that rounded lifts would call wrong.");
    draw_squares_panel(&page);
    draw_far_sites_panel(&page);
    svg_end(&page);
}

static const figure figures[] = {
    {"fig7_lifting", draw_lifting},
    {"fig8_lower_hull", draw_lower_hull},
    {"step", draw_step},
    {"lower_and_upper", draw_both_sides},
    {"rounded_lift", draw_rounded},
};

int
main(int argc, char **argv)
{
    return draw_figures(argc, argv, figures,
                        sizeof figures / sizeof figures[0]);
}
