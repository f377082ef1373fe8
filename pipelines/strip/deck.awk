# The deck of a strip: awk -v model=bond_based -v law=critical_stretch -v horizon=3.015 -v influence=constant -v angle=0
#   -v how=slow|running|whole [-v level=1.2] -f deck.awk
#
# A strip of 8 horizons of height between clamped edges, 20 long, cracked along 8 of these, at an angle to the lattice; all that
# lies beyond the edges is clamped.  Lengths in mm, which are spacings.  Moved apart by 2 u, a strip in plane stress without a crack
# holds G = E (2 u)^2/(2 (1 - nu^2) H) for each unit of area that a crack makes of it (Rivlin, Thomas): level is that over the deck's.
# whole: without the crack, for what the lattice makes of G.

BEGIN {
    reach = int(horizon)
    H = 8 * reach
    L = 20 * reach
    a = angle * atan2(0, -1) / 180
    c = cos(a)
    s = sin(a)
    E = 70e9
    nu = 1 / 3
    energy = 100
    u = sqrt(2 * energy * (1 - nu ^ 2) * H * 1e-3 / E) / 2
    printf "title: Strip, %s, %s, horizon %s, %s, %d degrees, %s\n\n", model, law, horizon, influence, angle, how
    printf "domain: {specimen: plate, dimensions: 2, size: [%d mm, %d mm, 1 mm], spacing: 1 mm, topology: homogeneous, phase: M}\n\n", 2 * int(L * c / 2 + 0.5), 2 * int((L * s + (H + 2 * reach + 4) / c) / 2 + 0.5)
    printf "materials:\n  M: {model: %s, density: 2500 kg/m3, youngs_modulus: 70 GPa%s}\n\n", model, model == "bond_based" ? "" : ", poissons_ratio: 0.3333333333"
    if (how != "whole") {
        tip = H - L / 2
        printf "cracks:\n  - {rectangle: [[%.6f mm, %.6f mm, -1 mm], [%.6f mm, %.6f mm, 0], [0, 0, 2 mm]]}\n\n", -L * c, -L * s, (tip + L) * c, (tip + L) * s
        printf "damage:\n  - {pair: [M, M], law: %s, fracture_energy: %g J/m2}\n\n", law, energy
    }
    # Slow: the level grows by 2 per cent of G a step; running: to its level in ten steps.
    ramp = how == "slow" ? "sqrt(0.4+0.02*t)*min(t,1)" : sprintf("min(5e4*t,1)*%.9g", sqrt(how == "whole" ? 1 : level))
    across = sprintf("(%.9g*y-%.9g*x)", c, s)
    printf "boundary:\n"
    for (k = 0; k < 4; k++)
        printf "  - {where: \"%s %s %.7f\", direction: %s, displacement: \"%.9g*%s\"}\n", across, k % 2 ? "<" : ">", (k % 2 ? -1 : 1) * (H * 0.5e-3 + 1e-7),
               k < 2 ? "y" : "x", (k % 2 ? -u : u) * (k < 2 ? c : -s), ramp
    printf "\nsolver:\n  type: %s\n  plane: stress\n  horizon: %s\n  influence: %s\n", how == "running" ? "hybrid" : "quasi_static", horizon, influence
    if (how == "slow") printf "  end_time: 120 s\n  step: 1 s\n  first_step: 1 s\n  tolerance: 1e-5\n  accuracy: 1 # steps as they are\n"
    if (how == "whole") printf "  end_time: 20 us\n  step: 20 us\n  first_step: 20 us\n  tolerance: 1e-6\n"
    if (how == "running")
        printf "  end_time: %d us\n  step: 2 us\n  first_step: 2 us\n  tolerance: 1e-5\n  accuracy: 1 # steps as they are\n  most_evaluations: 4000\n  explicit_when: [damage]\n  energy_tolerance: 0.05\n", 20 + 3 * H
    printf "\noutput:\n  history: 300\n  quantities:\n"
    for (k = 1; k <= 3; k++) {
        name = substr("xxxyyy", 2 * k - 1, 2)
        printf "    - {name: stress_%s, quantity: stress_%s, reduce: mean, where: \"abs(%s) < 1.6e-3 && abs(%.9g*x+%.9g*y) < 3.1e-3\"}\n", name, name, across, c, s
    }
}
