/* xml.h - the tags of an XML text one after the other, as much of it as VTK's files need: no
 * entities in names, and bytes that are no XML may follow the last tag that is asked for. */
#ifndef HS_XML_H
#define HS_XML_H

#include <stdbool.h>
#include <stddef.h>

struct xml {
    const char *at, *end;
};

struct xml_tag {
    const char *name;  /* behind its '<', so that of the end of an element begins with '/' */
    const char *end;   /* behind its '>' */
    const char *limit; /* of the text */
};

struct xml xml_of(const char *text, size_t length);

/* The next tag; false where there is none.  Comments and declarations are passed over. */
bool xml_next(struct xml *xml, struct xml_tag *tag);

bool xml_is(const struct xml_tag *tag, const char *name);

/* The value of an attribute, NULL where there is none; the caller frees it. */
char *xml_attribute(const struct xml_tag *tag, const char *name);

/* What stands between the tag and the next one. */
const char *xml_content(const struct xml_tag *tag, size_t *length);

#endif
