int
incircle_exact(point2 a, point2 b, point2 c, point2 d)
{
    long double adx = (long double)a.x - d.x, ady = (long double)a.y - d.y;
    long double bdx = (long double)b.x - d.x, bdy = (long double)b.y - d.y;
    long double cdx = (long double)c.x - d.x, cdy = (long double)c.y - d.y;
    long double det = (adx * adx + ady * ady) * (bdx * cdy - bdy * cdx) +
                      (bdx * bdx + bdy * bdy) * (cdx * ady - cdy * adx) +
                      (cdx * cdx + cdy * cdy) * (adx * bdy - ady * bdx);
    return (det > 0) - (det < 0);
}
