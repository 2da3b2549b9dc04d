int
below_plane_rounded(point2 a, point2 b, point2 c, point2 d)
{
    const point2 p[3] = {a, b, c};
    __int128 x[3], y[3], z[3];
    for (int i = 0; i < 3; i++) {
        x[i] = (int64_t)p[i].x - (int64_t)d.x;
        y[i] = (int64_t)p[i].y - (int64_t)d.y;
        z[i] = x[i] * x[i] + y[i] * y[i];
    }
    __int128 det = z[0] * (x[1] * y[2] - y[1] * x[2]) + z[1] * (x[2] * y[0] - y[2] * x[0]) +
                   z[2] * (x[0] * y[1] - y[0] * x[1]);
    __int128 turn = (x[0] - x[2]) * (y[1] - y[2]) - (y[0] - y[2]) * (x[1] - x[2]);
    if (turn < 0)
        det = -det;
    return (det > 0) - (det < 0);
}
