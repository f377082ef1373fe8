#include "version.h"

/* HS_VERSION is the Makefile's: the number alone in the library, with the commit in the programs.
 */
const char hs_version[] = HS_VERSION;
