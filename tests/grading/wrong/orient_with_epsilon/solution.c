int
cross_sign_exact(point2 p, point2 q, point2 r, point2 s)
{
    long double det = ((long double)p.x - q.x) * ((long double)r.y - s.y) -
                      ((long double)p.y - q.y) * ((long double)r.x - s.x);
    return fabsl(det) < 1e-12 ? 0 : (det > 0) - (det < 0);
}
