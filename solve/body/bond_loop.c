/* bond_loop.c - a kernel over bonds between scattered particles (bond_loop.h).
 *
 * Ends of listed bonds lie anywhere in memory.  They are gathered into buffers first and what they
 * get is scattered last, lower ends before upper ones: between the two the kernel runs over arrays,
 * as it does on a lattice, and a material has one form for both.  Out of line, since gathering
 * costs more than a call. */
#include "bond_loop.h"

void bond_move_apart(const struct bond_view *view, const struct body *body, struct bond_pass *pass,
                     double *const moved[3])
{
    for (int a = 0; a < 3; a++) {
        const double *H = body->lattice_gradient + 3 * a, *u = pass->u[1][a];
        double apart = H[0] * *view->xi[0] + H[1] * *view->xi[1] + H[2] * *view->xi[2];
        for (int k = 0; k < view->count; k++) {
            if (view->geometry_step)
                apart = H[0] * view->xi[0][k] + H[1] * view->xi[1][k] + H[2] * view->xi[2][k];
            moved[a][k] = u[k] + apart;
        }
        pass->u[1][a] = moved[a];
    }
}

void bond_run_scattered(bond_kernel *kernel, const struct bonds *bonds,
                        const struct bond_strip *strip, struct bond_fields fields,
                        struct bond_pass *pass)
{
    const struct bond_view view = bonds_view(bonds, strip);
    double u[2][3][LANES], node[2][BOND_NODE_FIELDS][LANES], sum[2][BOND_SUMS][LANES];
    pass->count = view.count;
    pass->length = view.length;
    pass->weight = view.weight;
    pass->volume[0] = view.volume_i;
    pass->volume[1] = view.volume_j;
    for (int a = 0; a < 3; a++) pass->xi[a] = view.xi[a];
    for (int end = 0; end < 2; end++) {
        for (int a = 0; a < 3; a++)
            pass->u[end][a] = bond_gather(&view, end, bonds->body->u[a], u[end][a]);
        for (int a = 0; a < fields.nodes; a++)
            pass->node[end][a] = bond_gather(&view, end, fields.node[a], node[end][a]);
        for (int a = 0; a < fields.sums; a++)
            pass->sum[end][a] = bond_target(&view, end, fields.sum[a], sum[end][a]);
    }
    if (lattice_is_periodic(bonds->body->lattice))
        bond_move_apart(&view, bonds->body, pass, (double *const[]){u[1][0], u[1][1], u[1][2]});
    kernel(pass);
    for (int a = 0; a < fields.sums; a++)
        for (int end = 0; end < 2; end++) bond_scatter(&view, end, fields.sum[a], sum[end][a]);
}
