static double sgn(double x)
{
    return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : x;
}
