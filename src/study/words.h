/* words.h -- words of a list on the command line: "a,b,c". */
#ifndef STUDY_WORDS_H
#define STUDY_WORDS_H

struct words {
    int n;
    char **word; /* [n] */
};

/* Splits text at its commas, those in brackets and quotes excepted: gravity=[0,-9.81] is
 * one word.  An empty word is refused; what names the list in that message. */
int words_split(struct words *l, const char *text, const char *what);
void words_free(struct words *l);

#endif
