#include "small_body.h"

#include "bond_search.h"
#include "corners.h"
#include "hexahedron.h"
#include "mesh.h"
#include "yield.h"

#include "check.h"
#include "cracks.h"

#include "material_read.h"
#include "memory.h"
#include "random.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define ELASTICITY "density: 8900, youngs_modulus: 210 GPa, poissons_ratio: 0.31"
#define NICKEL                                                                                     \
    "A: {model: correspondence, " ELASTICITY ", "                                                  \
    "hardening: {law: voce, yield: 182.1 MPa, saturation: 513.0 MPa, rate: 5.320}}"
const char small_elastic[] = "{A: {model: correspondence_elastic, " ELASTICITY "}}";
const char small_nickel[] = "{" NICKEL "}";
const char small_two_phases[] =
    "{" NICKEL ", B: {model: correspondence, " ELASTICITY ", "
    "hardening: {law: voce, yield: 1259.8 MPa, saturation: 564.5 MPa, rate: 238.5}}}";
const char small_mix[] = "{law: mix, share: 0.1}";
const char small_capped[] = "{law: capped}";

static struct lattice lattice_of(const struct small_case *wanted)
{
    struct lattice lattice = {.dimensions = wanted->plane ? 2 : 3,
                              .spacing = SMALL_SPACING,
                              .thickness = SMALL_SPACING,
                              .node_volume = SMALL_SPACING * SMALL_SPACING * SMALL_SPACING,
                              .n_sites = 1};
    for (int a = 0; a < 3; a++) {
        lattice.size[a] = wanted->size[a];
        lattice.n_sites *= wanted->size[a];
    }
    for (int a = 0; a < 3; a++) {
        const double edge = wanted->edge[a] > 0 ? wanted->edge[a] : 1;
        lattice.edge[a] = SMALL_SPACING * edge;
        lattice.node_volume *= edge;
    }
    lattice.phase = memory_new((size_t)lattice.n_sites, 1);
    uint8_t *phase = lattice.phase;
    for (int z = 0; z < wanted->size[2]; z++)
        for (int y = 0; y < wanted->size[1]; y++)
            for (int x = 0; x < wanted->size[0]; x++, phase++) {
                *phase = wanted->phase ? wanted->phase(wanted->size, (int[]){x, y, z}) : 0;
                lattice.n_nodes += *phase != ABSENT;
            }
    lattice.n_particles = lattice.n_nodes;
    return lattice;
}

static void move_about(double *const x[3], int dimensions, int64_t count, double jitter)
{
    struct random_stream *stream = random_new(1, "jitter");
    for (int64_t i = 0; i < count; i++)
        for (int a = 0; a < dimensions; a++)
            x[a][i] += jitter * SMALL_SPACING * (2 * random_uniform(stream) - 1);
    random_free(stream);
}

struct domain small_body_domain(const struct lattice *lattice)
{
    struct domain domain = domain_new(lattice->n_nodes, 1, (const char *const[]){"A"});
    int64_t node = 0;
    for (int64_t site = 0; site < lattice->n_sites; site++) {
        int at[3];
        double x[3];
        if (lattice->phase[site] == ABSENT) continue;
        lattice_position(lattice, site, at);
        lattice_coordinates(lattice, at, x);
        domain.x[node] = x[0];
        domain.y[node] = x[1];
        domain.z[node] = x[2];
        domain.volume[node] = lattice->node_volume;
        domain.phase[node++] = lattice->phase[site];
    }
    return domain;
}

/* The same particles as scattered ones. */
static struct lattice scattered(struct lattice *lattice, double jitter)
{
    struct domain domain = small_body_domain(lattice);
    double *const x[3] = {domain.x, domain.y, domain.z};
    move_about(x, lattice->dimensions, domain.n_nodes, jitter);
    attributes_set_number(&domain.attributes, "mean_spacing_m", lattice->spacing);
    struct lattice result =
        lattice_scattered(&domain, lattice->dimensions == 2 ? lattice->thickness : 0);
    domain_free(&domain);
    lattice_free(lattice);
    return result;
}

/* The cells of particles on a lattice as a mesh; takes the lattice over. */
static struct lattice mesh_of(const struct lattice *particles, double jitter)
{
    static const int of_exodus[8] = {0, 1, 3, 2, 4, 5, 7, 6};
    struct lattice cells = corners_lattice(particles);
    const int64_t n = cells.n_particles;
    struct domain nodes = corners_domain(&cells);
    domain_hold(&nodes);
    struct domain domain = domain_new(n, 0, NULL);
    domain.hexahedra = memory_new(8 * (size_t)n, sizeof(int64_t));
    domain.corners = memory_new(1, sizeof(struct domain));
    double *const x[3] = {nodes.x, nodes.y, nodes.z};
    int64_t *number = memory_new((size_t)cells.n_sites, sizeof *number), next = 0;
    for (int64_t site = 0; site < cells.n_sites; site++) {
        number[site] = next;
        next += lattice_has_node(&cells, site);
    }
    move_about(x, 3, nodes.n_nodes, jitter);
    next = n;
    for (int64_t site = 0; site < cells.n_sites; site++) {
        struct hexahedron hexahedron;
        double centroid[3];
        if (cells.phase[site] == ABSENT) continue;
        domain.phase[--next] = cells.phase[site];
        for (int k = 0; k < 8; k++) {
            const int64_t node = number[lattice_corner_site(&cells, site, of_exodus[k])];
            domain.hexahedra[8 * next + k] = node;
            for (int a = 0; a < 3; a++) hexahedron.corner[k][a] = x[a][node];
        }
        domain.volume[next] = hexahedron_volume(&hexahedron, centroid);
    }
    free(number);
    *domain.corners = nodes;
    attributes_set_number(&domain.attributes, "mean_spacing_m", particles->spacing);
    struct domain corners;
    const struct lattice mesh = mesh_lattice(&domain, &corners);
    domain_free(&domain);
    domain_free(&corners);
    lattice_free(&cells);
    return mesh;
}

void small_body_new(struct small_body *small, const struct small_case *wanted)
{
    char *names[] = {"A", "B"};
    char *text = memory_print(
        "{materials: %s%s%s%s%s%s%s%s%s}", wanted->materials,
        wanted->residual ? ", residual: " : "", wanted->residual ? wanted->residual : "",
        wanted->stabilisation ? ", stabilisation: " : "",
        wanted->stabilisation ? wanted->stabilisation : "",
        wanted->surface_correction ? ", surface_correction: " : "",
        wanted->surface_correction ? wanted->surface_correction : "", wanted->breaking ? ", " : "",
        wanted->breaking ? wanted->breaking : "");
    small->deck = deck_parse(text, strlen(text), "test");
    free(text);
    struct deck_node root = deck_root(small->deck);
    small->lattice = lattice_of(wanted);
    if (wanted->scattered) small->lattice = scattered(&small->lattice, wanted->jitter);
    if (wanted->points) {
        lattice_free(&small->lattice);
        small->lattice = lattice_scattered(wanted->points, 0);
    }
    small->family = family_new(wanted->horizon, wanted->influence, wanted->partial);
    small->materials = materials_read(
        deck_get(root, "materials"), wanted->n_phases ? wanted->n_phases : 1, names, wanted->plane);
    if (small->materials.formulation->corners) {
        struct lattice particles = small->lattice;
        small->lattice =
            wanted->mesh ? mesh_of(&particles, wanted->jitter) : corners_lattice(&particles);
        lattice_free(&particles);
        family_free(&small->family);
        small->family = family_new(small->materials.formulation->horizon, 0, false);
    }
    small->model = model_new(root, &small->family, &small->materials);
    const struct offset *near;
    int n_near = model_near(small->model, &small->family, &near);
    small->body = body_new(&small->lattice, &small->family, near, n_near, (struct ranks){0, 1});
    if (small->lattice.corner) {
        double density[2];
        for (int p = 0; p < small->materials.count; p++)
            density[p] = small->materials.items[p].density;
        corners_fill(&small->body, density);
    }
    yield_start(&small->body, &small->materials);
    small->bonds = bonds_new(&small->body);
    small->damage = damage_new(root, small->model, &small->materials, &small->body, small->bonds);
    struct cracks cracks =
        cracks_read(deck_find(root, "cracks"), SMALL_SPACING, small->lattice.dimensions);
    small->cut = cracks_cut(&cracks, &small->body, small->bonds);
    cracks_free(&cracks);
    model_start(small->model, &small->body, small->bonds);
}

void small_body_free(struct small_body *small)
{
    model_free(small->model);
    damage_free(small->damage);
    bonds_free(small->bonds);
    body_free(&small->body);
    materials_free(&small->materials);
    family_free(&small->family);
    lattice_free(&small->lattice);
    deck_free(small->deck);
}

bool small_body_has(const struct small_body *small, int64_t site)
{
    return small->body.grid.flags[site] & SITE_OWNED;
}

void small_body_position(const struct small_body *small, int64_t site, int at[3])
{
    grid_position(&small->body.grid, site, at);
}

void small_body_deform(struct small_body *small, const double H[9])
{
    for (int64_t site = 0; site < small->body.grid.n_sites; site++) {
        double x[3];
        if (!small_body_has(small, site)) continue;
        body_position(&small->body, site, x);
        for (int a = 0; a < 3; a++)
            small->body.u[a][site] = H[3 * a] * x[0] + H[3 * a + 1] * x[1] + H[3 * a + 2] * x[2];
    }
}

void small_body_shake(struct small_body *small, double amplitude, long seed)
{
    struct random_stream *stream = random_new(seed, "shake");
    for (int64_t site = 0; site < small->body.grid.n_sites; site++)
        for (int a = 0; a < 3 && small_body_has(small, site); a++)
            small->body.u[a][site] += amplitude * SMALL_SPACING * (2 * random_uniform(stream) - 1);
    random_free(stream);
}

void small_body_strike(struct small_body *small, double speed)
{
    for (int64_t site = 0; site < small->body.grid.n_sites; site++) {
        int at[3];
        if (!small_body_has(small, site)) continue;
        small_body_position(small, site, at);
        small->body.v[0][site] = speed * (0.1 * at[0] + 0.05 * at[1]);
        small->body.v[1][site] = speed * sin(0.5 * at[0]) + 0.05 * speed * at[0];
        small->body.v[2][site] = speed * cos(0.4 * at[1] + at[0]);
    }
}

void small_body_force(struct small_body *small, bool commit, bool frozen)
{
    model_force(small->model, &small->body, (struct force_mode){.commit = commit, .frozen = frozen},
                NULL);
}

int small_body_observe(struct small_body *small, int64_t site, struct node_state *node)
{
    const struct strip *strip = model_strips(small->model, &small->body)->items;
    while (site < strip->site || site >= strip->site + strip->count) strip++;
    body_need_gradient(&small->body); /* observed, though not prepared */
    model_observe(small->model, &small->body, strip, node);
    return (int)(site - strip->site);
}

void small_body_plastic_range(struct small_body *small, double range[2])
{
    const struct strips *strips = model_strips(small->model, &small->body);
    struct node_state node;
    body_need_gradient(&small->body); /* observed, though not prepared */
    range[0] = INFINITY;
    range[1] = 0;
    for (int64_t s = 0; s < strips->count; s++) {
        model_observe(small->model, &small->body, &strips->items[s], &node);
        for (int i = 0; i < node.count; i++) {
            range[0] = fmin(range[0], node.plastic[i]);
            range[1] = fmax(range[1], node.plastic[i]);
        }
    }
}

static double energy_of(struct small_body *small, bool frozen)
{
    /* No tested state holds more than a hundredth of E per volume. */
    const struct exact_sum zero =
        exact_sum_new(0.01 * materials_stiffest(&small->materials) *
                      (double)small->lattice.n_nodes * small->body.volume);
    struct force_energy energy = {zero, zero, zero};
    model_force(small->model, &small->body, (struct force_mode){.frozen = frozen, .energy = true},
                &energy);
    double values[3];
    exact_sum_finish(
        (const struct exact_sum[]){energy.stored, energy.stabilisation, energy.plastic}, 3, values);
    return values[0] + values[1] + (frozen ? 0 : values[2]);
}

double small_body_elastic_energy(struct small_body *small)
{
    return energy_of(small, true);
}

double small_body_potential(struct small_body *small)
{
    return energy_of(small, false);
}

int64_t small_body_middle(const struct small_body *small)
{
    const int *size = small->lattice.size;
    return grid_site(&small->body.grid, (const int[]){size[0] / 2, size[1] / 2, size[2] / 2});
}

void small_body_stress(struct small_body *small, int64_t site, double P[9])
{
    model_prepare(small->model, &small->body, 3);
    for (int k = 0; k < 9; k++) P[k] = small->body.S[k][site];
}

double small_body_product(const struct small_body *small, double *const a[3], double *const b[3])
{
    double sum = 0;
    for (int64_t site = 0; site < small->body.grid.n_sites; site++)
        for (int c = 0; c < 3 && small_body_has(small, site); c++) sum += a[c][site] * b[c][site];
    return sum;
}

double small_body_largest(const struct small_body *small, double *const a[3])
{
    double most = 0;
    for (int64_t site = 0; site < small->body.grid.n_sites; site++)
        for (int c = 0; c < 3 && small_body_has(small, site); c++)
            most = fmax(most, fabs(a[c][site]));
    return most;
}

struct boundary small_free_boundary(void)
{
    struct boundary boundary = {
        .count = 2, .sets = memory_new(2, sizeof(struct boundary_set)), .left = -1, .right = -1};
    for (int i = 0; i < 2; i++) boundary.sets[i].zero = exact_sum_new(1);
    return boundary;
}

struct small_point small_point_new(const struct materials *materials)
{
    struct small_point point = {.stress = 0};
    const struct law_in_use *use = &materials->laws[materials->law_of[0]];
    struct points strip = {.count = 1};
    assert_true(law_components(use->law) <= SMALL_STATE);
    law_start(use->law, use->pairs, &strip, point.state, 1);
    return point;
}

double small_point_plastic(const struct small_point *point)
{
    return point->state[law_component(&law_j2, "equivalent_plastic_strain")];
}

/* P_yy at the lateral strain; P_xx goes to the point. */
static double lateral_stress(struct small_point *point, const struct materials *materials,
                             double lateral, bool commit)
{
    const struct law_in_use *use = &materials->laws[materials->law_of[0]];
    struct points strip = {.count = 1};
    point->H[4] = point->H[8] = lateral;
    for (int k = 0; k < TENSOR; k++) strip.H[k][0] = point->H[k];
    strip.mu[0] = materials->shear[0];
    strip.bulk[0] = materials->bulk[0];
    strip.pair[0] = 0;
    use->law->update(use->pairs, &strip, point->state, 1, (struct step){.commit = commit});
    point->stress = strip.P[0][0];
    return strip.P[4][0];
}

void small_point_stretch(struct small_point *point, const struct materials *materials,
                         double strain)
{
    double low = point->H[4] - 0.6 * fabs(strain - point->H[0]),
           high = point->H[4] + 0.6 * fabs(strain - point->H[0]), middle = 0;
    point->H[0] = strain;
    assert_true(lateral_stress(point, materials, low, false) <= 0);
    assert_true(lateral_stress(point, materials, high, false) >= 0);
    for (int step = 0; step < 100; step++) {
        middle = 0.5 * (low + high);
        *(lateral_stress(point, materials, middle, false) < 0 ? &low : &high) = middle;
    }
    assert_near(lateral_stress(point, materials, middle, true), 0, 1e-13 * materials->shear[0]);
}
