/* foreign.h - files of other programs that are no domain of particles, told by their first bytes.
 */
#ifndef HS_FOREIGN_H
#define HS_FOREIGN_H

#include <stddef.h>

/* What a file is, in words, by how it begins; NULL where that is not known. */
const char *foreign_format(const unsigned char *bytes, size_t count);

#endif
