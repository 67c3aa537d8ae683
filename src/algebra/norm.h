/* norm.h -- how the weighted errors of all entries become one number: the formulas stand in
 * vector.h. */
#ifndef ALGEBRA_NORM_H
#define ALGEBRA_NORM_H

enum vector_norm { VECTOR_NORM_MAX, VECTOR_NORM_P8, VECTOR_NORM_WRMS };

/* "max" and its like by number, NULL-ended: what scenes and messages call them. */
extern const char *const vector_norm_words[];

/* The norm of that name; the first one, VECTOR_NORM_MAX, for a word that names none. */
enum vector_norm vector_norm_of(const char *word);

#endif
