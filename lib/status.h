/* status.h - what can go wrong, as a number for programs and a sentence for people.
 *
 * Needs: nothing.
 *
 * Bad data is a status. Misuse of an interface is an assert. A predicate
 * cannot fail. Nothing in lib/ or chapters/ prints or exits.
 */
#ifndef LIB_STATUS_H
#define LIB_STATUS_H

/* The numbers are stable: a program may store them. */
typedef enum tri_status {
    TRI_OK = 0,
    TRI_OUT_OF_MEMORY = 1,
    TRI_TOO_MANY_POINTS = 2,
    TRI_NOT_FINITE = 3,
    TRI_BAD_OPTION = 4,
    TRI_BAD_FP_ENVIRONMENT = 5,
    TRI_CANCELLED = 6,
    TRI_BAD_FILE = 7,
    TRI_CANNOT_READ = 8,
    TRI_CANNOT_WRITE = 9,
    TRI_OUT_OF_RANGE = 10
} tri_status;

/* One sentence for people, without a full stop: what is wrong and what to do. */
const char *tri_status_text(tri_status status);

#endif
