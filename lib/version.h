/* version.h - the version of the programs: "0.1.0+12.g8e158c7", the number and, from a repository,
 * the commits since and the last of them; "0.1.0" where there is none. */
#ifndef HS_VERSION_H
#define HS_VERSION_H

extern const char hs_version[];

#endif
