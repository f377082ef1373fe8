/* encoding.h - text of whatever character set as UTF-8. */
#ifndef HS_ENCODING_H
#define HS_ENCODING_H

/* UTF-16 by its byte order mark or its zero bytes, UTF-8 with or without a mark, else
 * WINDOWS-1252, of which Latin-1 is a part (iconv).  *set is the name found.  NULL: not text
 * (zero bytes that are not UTF-16).  The caller frees it. */
char *encoding_to_utf8(const char *bytes, long length, const char **set);

#endif
