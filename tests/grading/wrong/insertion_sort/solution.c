static void
merge_sort(site *a, site *b, size_t lo, size_t hi, point2 d)
{
    (void)b;
    for (size_t i = lo; i < hi; i++)
        for (size_t k = i; k > lo && compare_along(d, a[k - 1].at, a[k].at) > 0; k--) {
            site other = a[k];
            a[k] = a[k - 1];
            a[k - 1] = other;
        }
}
