/* assemble.h - from the structure to the domain that is written. */
#ifndef HS_ASSEMBLE_H
#define HS_ASSEMBLE_H

#include "domain.h"
#include "findings.h"

/* Positions, volumes, phases, node sets and the attributes of docs/formats.md but those that name
 * the deck and the command.  fault: what the topology check found and the user overrode, or NULL.
 */
struct domain assemble_domain(const struct recipe *recipe, const struct structure *structure,
                              const struct findings *findings, const char *fault);

#endif
