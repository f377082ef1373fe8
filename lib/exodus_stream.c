/* A domain whose positions and volumes stay in its file. */
#include "exodus.h"
#include "exodus_mesh.h"
#include "memory.h"

#include <stdlib.h>
#include <string.h>

enum { AT_ONCE = 1 << 16, MOST_PHASES = 16, UNSEEN = 255 };

struct block {
    ex_block sizes;
    int64_t done;      /* elements that have been read */
    int volume, grain; /* places among the attributes; -1: none */
    double *values;    /* [AT_ONCE * attributes] */
};

struct stream {
    struct domain_source source;
    struct exodus_file file;
    int64_t n_nodes;
    int n_blocks;
    struct block blocks[MOST_PHASES];
    double *x[3], *volume, *grain; /* [AT_ONCE] */
};

static void stream_free(struct domain_source *source)
{
    struct stream *stream = (struct stream *)source;
    exodus_close(&stream->file);
    for (int b = 0; b < stream->n_blocks; b++) free(stream->blocks[b].values);
    for (int a = 0; a < 3; a++) free(stream->x[a]);
    free(stream->volume);
    free(stream->grain);
    free(stream);
}

/* Volumes and grains of the nodes that are of a block, whose elements follow each other as they do.
 */
static void read_volumes(struct stream *stream, const struct domain_nodes *nodes, int b)
{
    struct block *block = &stream->blocks[b];
    const int64_t each = block->sizes.num_attribute;
    int64_t count = 0;
    for (int64_t i = 0; i < nodes->count; i++) count += nodes->phase[i] == b;
    if (count == 0) return;
    exodus_read(&stream->file,
                ex_get_partial_attr(stream->file.id, EX_ELEM_BLOCK, block->sizes.id,
                                    block->done + 1, count, block->values),
                "the volumes");
    block->done += count;
    const double *value = block->values;
    for (int64_t i = 0; i < nodes->count; i++) {
        if (nodes->phase[i] != b) continue;
        stream->volume[i] = value[block->volume];
        stream->grain[i] = block->grain < 0 ? 0 : value[block->grain];
        value += each;
    }
}

static void stream_read(struct domain_source *source, struct domain_nodes *nodes)
{
    struct stream *stream = (struct stream *)source;
    if (nodes->count > AT_ONCE) nodes->count = AT_ONCE;
    exodus_read(&stream->file,
                ex_get_partial_coord(stream->file.id, nodes->first + 1, nodes->count, stream->x[0],
                                     stream->x[1], stream->x[2]),
                "the positions");
    for (int b = 0; b < stream->n_blocks; b++) {
        if (nodes->first == 0) stream->blocks[b].done = 0;
        read_volumes(stream, nodes, b);
    }
    for (int a = 0; a < 3; a++) nodes->x[a] = stream->x[a];
    nodes->volume = stream->volume;
    if (source->grains) nodes->grain = stream->grain;
}

/* Phases of a block's nodes; false where they do not ascend, or one is another block's, too. */
static bool take_phases(const struct stream *stream, int b, uint8_t *phase)
{
    const ex_block *block = &stream->blocks[b].sizes;
    int64_t *nodes = memory_new(AT_ONCE, sizeof *nodes), last = 0;
    bool good = true;
    for (int64_t first = 0; good && first < block->num_entry; first += AT_ONCE) {
        const int64_t left = block->num_entry - first, count = left < AT_ONCE ? left : AT_ONCE;
        exodus_read(&stream->file,
                    ex_get_partial_conn(stream->file.id, EX_ELEM_BLOCK, block->id, first + 1, count,
                                        nodes, NULL, NULL),
                    "a block");
        for (int64_t i = 0; good && i < count; last = nodes[i++]) {
            good = nodes[i] > last && nodes[i] <= stream->n_nodes && phase[nodes[i] - 1] == UNSEEN;
            if (good) phase[nodes[i] - 1] = (uint8_t)b;
        }
    }
    free(nodes);
    return good;
}

/* Whether all blocks are of spheres on all nodes. */
static bool take_blocks(struct stream *stream, int64_t elements, struct domain *domain)
{
    int64_t ids[MOST_PHASES], all = 0;
    exodus_read(&stream->file, ex_get_ids(stream->file.id, EX_ELEM_BLOCK, ids), "the blocks");
    for (; stream->n_blocks < domain->n_phases; stream->n_blocks++) {
        struct block *block = &stream->blocks[stream->n_blocks];
        block->sizes = exodus_read_block(&stream->file, ids[stream->n_blocks],
                                         &domain->phase_names[stream->n_blocks]);
        const ex_block *sizes = &block->sizes;
        all += sizes->num_entry;
        if (sizes->num_entry == 0) continue;
        if (strcasecmp(sizes->topology, "SPHERE") != 0 || sizes->num_nodes_per_entry != 1 ||
            sizes->num_attribute < 1 || sizes->num_attribute > MOST_PHASES)
            return false;
        block->volume = exodus_volume_attribute(&stream->file, sizes);
        block->grain = exodus_attribute(&stream->file, sizes, "GRAIN");
        stream->source.grains = stream->source.grains || block->grain >= 0;
        block->values = memory_new((size_t)(AT_ONCE * sizes->num_attribute), sizeof(double));
    }
    return all == elements && all == domain->n_nodes;
}

static bool take_head(struct stream *stream, struct domain *domain)
{
    ex_init_params sizes;
    if (stream->file.packed) return false;
    exodus_read(&stream->file, ex_get_init_ext(stream->file.id, &sizes), "the sizes");
    domain->attributes = exodus_read_attributes(&stream->file);
    if (!(attributes_number(&domain->attributes, "spacing_m", 0) > 0) || sizes.num_dim != 3 ||
        sizes.num_elem_blk < 1 || sizes.num_elem_blk > MOST_PHASES || sizes.num_side_sets > 0)
        return false;
    exodus_bound(&stream->file, sizes.num_nodes, 8 * 3, "nodes");
    stream->n_nodes = domain->n_nodes = sizes.num_nodes;
    domain->n_phases = (int)sizes.num_elem_blk;
    domain->phase_names = memory_new(MOST_PHASES, sizeof *domain->phase_names);
    if (!take_blocks(stream, sizes.num_elem, domain)) return false;
    domain->phase = memory_new((size_t)domain->n_nodes, 1);
    memset(domain->phase, UNSEEN, (size_t)domain->n_nodes);
    bool good = true;
    for (int b = 0; good && b < stream->n_blocks; b++) good = take_phases(stream, b, domain->phase);
    const struct mesh mesh = {.file = &stream->file, .n_nodes = domain->n_nodes, .on_nodes = true};
    if (good) exodus_read_sets(&mesh, &sizes, domain);
    return good;
}

bool exodus_stream_domain(const struct spool *input, struct domain *domain)
{
    struct stream *stream = memory_new(1, sizeof *stream);
    *stream = (struct stream){.source = {.read = stream_read, .free = stream_free},
                              .file = exodus_open(input, true),
                              .volume = memory_new(AT_ONCE, sizeof(double)),
                              .grain = memory_new(AT_ONCE, sizeof(double))};
    for (int a = 0; a < 3; a++) stream->x[a] = memory_new(AT_ONCE, sizeof(double));
    *domain = (struct domain){.source = &stream->source};
    const bool good = take_head(stream, domain);
    if (!good) domain_free(domain);
    return good;
}
