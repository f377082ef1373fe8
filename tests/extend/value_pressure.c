static void pressure(const struct node_state *state, int component, double *values)
{
    const double(*s)[LANES] = state->cauchy;
    (void)component;
    for (int i = 0; i < state->count; i++) values[i] = -(s[0][i] + s[1][i] + s[2][i]) / 3;
}
