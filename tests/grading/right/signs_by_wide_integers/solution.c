int
cross_sign_exact(point2 p, point2 q, point2 r, point2 s)
{
    wide w;
    wide_clear(&w);
    add_det2(&w, +1, 1, 1, p, r);
    add_det2(&w, -1, 1, 1, p, s);
    add_det2(&w, -1, 1, 1, q, r);
    add_det2(&w, +1, 1, 1, q, s);
    return wide_sign(&w);
}
