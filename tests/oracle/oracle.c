/* oracle.c - signs of determinants of integers. */
#include "tests/oracle/oracle.h"

#include "tests/oracle/big.h"

#include <math.h>

/* ---- Doubles become integers. ---- */

/* The unit, or a smaller one if x is not a multiple of it. */
static int
unit_for(double x, int unit)
{
    return x != 0 && big_unit(x) < unit ? big_unit(x) : unit;
}

/* Points as integers, in their common unit. */
static void
scale(const point2 *points, int n, big x[], big y[])
{
    int unit = 1024;
    for (int i = 0; i < n; i++)
        unit = unit_for(points[i].x, unit_for(points[i].y, unit));
    for (int i = 0; i < n; i++) {
        x[i] = big_from_double(points[i].x, unit);
        y[i] = big_from_double(points[i].y, unit);
    }
}

static big
square_sum(const big *x, const big *y)
{
    big xx = big_multiply(x, x), yy = big_multiply(y, y);
    return big_add(&xx, &yy);
}

/* ---- Determinants. ---- */

/* The determinant of the rows that are not in `without` (a bit set) and the
 * columns from `column` on, by the cofactors of that column. */
static big
determinant(big matrix[4][4], int size, int column, unsigned without)
{
    if (column == size)
        return big_from_double(1, 0);
    big sum = {0};
    int sign = +1;
    for (int row = 0; row < size; row++) {
        if (without >> row & 1)
            continue;
        if (matrix[row][column].sign != 0) {
            big minor =
                determinant(matrix, size, column + 1, without | 1u << row);
            big term = big_multiply(&matrix[row][column], &minor);
            sum = sign > 0 ? big_add(&sum, &term) : big_subtract(&sum, &term);
        }
        sign = -sign;
    }
    return sum;
}

int
oracle_orient2d(point2 a, point2 b, point2 c)
{
    const point2 points[3] = {a, b, c};
    big x[3], y[3], matrix[4][4];
    scale(points, 3, x, y);
    for (int i = 0; i < 3; i++) {
        matrix[i][0] = x[i];
        matrix[i][1] = y[i];
        matrix[i][2] = big_from_double(1, 0);
    }
    return determinant(matrix, 3, 0, 0).sign;
}

int
oracle_incircle(point2 a, point2 b, point2 c, point2 d)
{
    const point2 points[4] = {a, b, c, d};
    big x[4], y[4], matrix[4][4];
    scale(points, 4, x, y);
    for (int i = 0; i < 4; i++) {
        matrix[i][0] = x[i];
        matrix[i][1] = y[i];
        matrix[i][2] = square_sum(&x[i], &y[i]);
        matrix[i][3] = big_from_double(1, 0);
    }
    return determinant(matrix, 4, 0, 0).sign;
}

int
oracle_orient3d(point3 a, point3 b, point3 c, point3 d)
{
    const point3 points[4] = {a, b, c, d};
    big matrix[4][4];
    int unit = 1024;
    for (int i = 0; i < 4; i++)
        unit = unit_for(points[i].x,
                        unit_for(points[i].y, unit_for(points[i].z, unit)));
    for (int i = 0; i < 4; i++) {
        matrix[i][0] = big_from_double(points[i].x, unit);
        matrix[i][1] = big_from_double(points[i].y, unit);
        matrix[i][2] = big_from_double(points[i].z, unit);
        matrix[i][3] = big_from_double(1, 0);
    }
    return determinant(matrix, 4, 0, 0).sign;
}

/* ---- Differences. ---- */

int
oracle_cross(point2 p, point2 q, point2 r, point2 s)
{
    const point2 points[4] = {p, q, r, s};
    big x[4], y[4];
    scale(points, 4, x, y);
    big qp_x = big_subtract(&x[0], &x[1]), qp_y = big_subtract(&y[0], &y[1]);
    big sr_x = big_subtract(&x[2], &x[3]), sr_y = big_subtract(&y[2], &y[3]);
    big left = big_multiply(&qp_x, &sr_y), right = big_multiply(&qp_y, &sr_x);
    return big_subtract(&left, &right).sign;
}

int
oracle_compare_distance(point2 p, point2 q, point2 r, point2 s)
{
    const point2 points[4] = {p, q, r, s};
    big x[4], y[4];
    scale(points, 4, x, y);
    big qp_x = big_subtract(&x[0], &x[1]), qp_y = big_subtract(&y[0], &y[1]);
    big sr_x = big_subtract(&x[2], &x[3]), sr_y = big_subtract(&y[2], &y[3]);
    big pq = square_sum(&qp_x, &qp_y), rs = square_sum(&sr_x, &sr_y);
    return big_subtract(&pq, &rs).sign;
}

/* ---- Sums. ---- */

static big
sum_in(int unit, const double *x, int n)
{
    big sum = {0};
    for (int i = 0; i < n; i++) {
        big next = big_from_double(x[i], unit);
        sum = big_add(&sum, &next);
    }
    return sum;
}

int
oracle_sum(const double *x, int n)
{
    return -oracle_product_minus_sum(0, 0, x, n);
}

/* With all factors in a unit u, products and sums are in the unit u^2. */
int
oracle_product_minus_sum(double a, double b, const double *x, int n)
{
    int unit = unit_for(a, unit_for(b, 1024));
    for (int i = 0; i < n; i++)
        while (unit_for(x[i], 2 * unit) < 2 * unit)
            unit--;
    big factor_a = big_from_double(a, unit),
        factor_b = big_from_double(b, unit);
    big product = big_multiply(&factor_a, &factor_b),
        sum = sum_in(2 * unit, x, n);
    return big_subtract(&product, &sum).sign;
}
