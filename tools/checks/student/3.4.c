/* 3.4.c - exact signs: cases for the student's functions. */
#include "chapters/3.4_primitives/predicates.h"
#include "tools/checks/student/driver.h"

/* The exercises 3.4-a and 3.4-b: a number of questions, each of four points; the sign
 * of each. */
void
solve(char exercise)
{
    for (uint32_t questions = case_number(); questions > 0; questions--) {
        point2 p[4];
        for (int i = 0; i < 4; i++)
            p[i] = case_point();
        answer_sign(exercise == 'a' ? cross_sign_exact(p[0], p[1], p[2], p[3])
                                    : incircle_exact(p[0], p[1], p[2], p[3]));
    }
}
