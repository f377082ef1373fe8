/* findings.h - what the finished structure is: the facts by which its topology is judged. */
#ifndef HS_FINDINGS_H
#define HS_FINDINGS_H

#include "clusters.h"

struct findings {
    int64_t counted;       /* nodes outside the grips */
    double ufg_fraction;   /* of them, by volume */
    struct clusters cg;    /* faces */
    struct clusters ufg;   /* faces */
    struct clusters cg_26; /* faces, edges and corners */
    struct contact contact;
    double reach;     /* m, structure_reach */
    double core_film; /* m, geometric film between neighbouring cores; negative: they overlap */
};

struct findings findings_of(const struct recipe *recipe, const struct structure *structure,
                            const struct cores *cores);

#endif
