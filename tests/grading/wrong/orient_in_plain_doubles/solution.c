int
cross_sign_exact(point2 p, point2 q, point2 r, point2 s)
{
    double det = (p.x - q.x) * (r.y - s.y) - (p.y - q.y) * (r.x - s.x);
    return (det > 0) - (det < 0);
}
