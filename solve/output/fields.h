/* fields.h - nodal fields in Exodus frames, for ParaView. */
#ifndef HS_FIELDS_H
#define HS_FIELDS_H

#include "damage.h"
#include "domain.h"
#include "model.h"
#include "scene.h"
#include "spool.h"

struct fields;

/* domain: rank 0's, whose attributes come to say the units; elsewhere NULL.  Rank 0 makes the file,
 * and each writes the numbers of its own particles into it.  Collective. */
struct fields *fields_open(const struct spool *output, struct domain *domain,
                           const struct scene_fields *wanted, const struct body *body,
                           const struct damage *damage);
void fields_write(struct fields *fields, double time, struct model *model, struct body *body);
/* Frames so far; 0 but on rank 0. */
int64_t fields_count(const struct fields *fields);
/* On rank 0 the first frames become those of an earlier file; false where it has not got them. */
bool fields_take(struct fields *fields, const char *name, int64_t frames);
void fields_close(struct fields *fields);

#endif
