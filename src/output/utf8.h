/* utf8.h -- texts that may hold any bytes, as names of files do. */
#ifndef OUTPUT_UTF8_H
#define OUTPUT_UTF8_H

/* Length of the UTF-8 sequence at s (RFC 3629), 0 when there is none. */
int utf8_sequence(const unsigned char *s);

#endif
