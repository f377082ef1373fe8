/* xml_deck.h - Teuchos' parameter lists in XML as a deck. */
#ifndef HS_XML_DECK_H
#define HS_XML_DECK_H

#include <stddef.h>

/* YAML with the same lists and parameters on the same lines, so that messages name the lines of the
 * XML; the list around all has no name.  Dies (exit 2), with the line, at what is no such XML.  The
 * caller frees it. */
char *xml_deck_yaml(const char *text, size_t length, const char *name);

#endif
