/* nearest.c -- the known word that a misspelt one was probably meant to be. */
#include "scene/scene.h"

#include <ctype.h>
#include <string.h>
#include <strings.h>

enum { LONGEST = 63 };

static int least(int a, int b)
{
    return a < b ? a : b;
}

static int same(char a, char b)
{
    return tolower((unsigned char)a) == tolower((unsigned char)b);
}

/* Letters to insert, delete, replace or swap with their neighbour until a is b.
 * Damerau, Comm. ACM 7 (1964) 171-176, as the usual table over prefixes, where
 * no piece is edited twice.  Capitals count as small letters. */
static int distance(const char *a, const char *b)
{
    const int n = (int)strlen(a), m = (int)strlen(b);
    int d[LONGEST + 1][LONGEST + 1];

    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= m; j++) {
            if (i == 0 || j == 0) {
                d[i][j] = i + j;
                continue;
            }
            d[i][j] = least(d[i - 1][j - 1] + !same(a[i - 1], b[j - 1]),
                            least(d[i - 1][j], d[i][j - 1]) + 1);
            if (i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1]))
                d[i][j] = least(d[i][j], d[i - 2][j - 2] + 1);
        }
    return d[n][m];
}

/* One is how the other starts: "visc", "densities". */
static int starts(const char *a, const char *b)
{
    const size_t n = strlen(a) < strlen(b) ? strlen(a) : strlen(b);

    return n >= 3 && strncasecmp(a, b, n) == 0;
}

const char *scene_nearest(const char *word, const char *const *names)
{
    const int n = (int)strlen(word);
    const char *nearest = NULL;
    int least_far = least(n, 2 + n / 4); /* one must be nearer than this */

    if (n > LONGEST)
        return NULL;
    for (; *names; names++) {
        int far;

        if (strlen(*names) > LONGEST)
            continue;
        far = distance(word, *names);
        if (far > 1 && starts(word, *names))
            far = 1;
        if (far < least_far) {
            least_far = far;
            nearest = *names;
        }
    }
    return nearest;
}
