/* words.c -- words of a list on the command line: "a,b,c". */
#include "study/words.h"

#include "base/status.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* Length of the first word of text. */
static size_t length(const char *text)
{
    bool quoted = false;
    int depth = 0;
    size_t n;

    for (n = 0; text[n]; n++) {
        quoted ^= text[n] == '"';
        if (!quoted && strchr("[({", text[n]))
            depth++;
        else if (!quoted && strchr("])}", text[n]))
            depth--;
        else if (!quoted && depth == 0 && text[n] == ',')
            break;
    }
    return n;
}

static int add(struct words *l, const char *text, size_t n, const char *what)
{
    if (n == 0)
        return status_fail(STATUS_BAD_SCENE, "%s: there is an empty word between its commas; "
                           "words are given as a,b,c", what);
    l->word[l->n] = status_alloc(n + 1, 1);
    if (!l->word[l->n])
        return STATUS_FAILED;
    memcpy(l->word[l->n++], text, n);
    return STATUS_DONE;
}

int words_split(struct words *l, const char *text, const char *what)
{
    l->n = 0;
    l->word = status_alloc(strlen(text) / 2 + 2, sizeof *l->word);
    if (!l->word)
        return STATUS_FAILED;
    for (;;) {
        const size_t n = length(text);
        TRY(add(l, text, n, what));
        if (!text[n])
            return STATUS_DONE;
        text += n + 1;
    }
}

void words_free(struct words *l)
{
    while (l->n > 0)
        free(l->word[--l->n]);
    free(l->word);
    l->word = NULL;
}
