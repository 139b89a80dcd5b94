/* x brought into [low, cut) by whole periods. */
static double wrapped(double x, double low, double cut, double period)
{
    double y;
    if (low <= x && x < cut) return x;
    y = x - period * floor((x - low) / period);
    return y < low || y >= cut ? low : y;
}
