int
incircle_exact(point2 a, point2 b, point2 c, point2 d)
{
    wide w;
    wide_clear(&w);
    add_lift(&w, +1, a, b, c, d);
    add_lift(&w, -1, b, a, c, d);
    add_lift(&w, +1, c, a, b, d);
    add_lift(&w, -1, d, a, b, c);
    wide turn;
    wide_clear(&turn);
    add_orient2d(&turn, +1, 1, 1, a, b, c);
    return wide_sign(&w) * wide_sign(&turn);
}
