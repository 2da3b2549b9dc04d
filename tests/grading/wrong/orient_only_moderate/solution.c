int
cross_sign_exact(point2 p, point2 q, point2 r, point2 s)
{
    expansion_room room;
    room.used = 0;
    row qp = vector(&room, p, q), sr = vector(&room, r, s);
    return answer(expansion_sign(det2(&room, qp, sr)));
}
