/* Motions of one system, one by one and many at once: see @NAME@.h. */

#include "@NAME@.h"
#include "dop853.h"

#include <limits.h>

static int follow(dop853 *m, double *y, const double *p, double end, double tolerance,
                  long count, const double *times, double *rows)
{
    const double start = @NAME@_clock >= 0 ? y[0] : 0.0;
    return dop853_evolve(m, p, y, start, end, tolerance, LONG_MAX, count, times, rows, 0);
}

int @NAME@_evolve(double *y, const double *p, double end, double tolerance,
                  long count, const double *times, double *rows)
{
    dop853 *m = dop853_new(@NAME@_size, @NAME@_clock, @NAME@_derivative);
    int status = DOP853_NO_MEMORY;
    if (m != 0) status = follow(m, y, p, end, tolerance, count, times, rows);
    dop853_free(m);
    return status;
}

long @NAME@_ensemble(long count, double *starts, const double *p, int common, double end,
                     double tolerance, int *status)
{
    long failed = 0;
#ifdef _OPENMP
#pragma omp parallel reduction(+ : failed)
#endif
    {
        dop853 *m = dop853_new(@NAME@_size, @NAME@_clock, @NAME@_derivative);
        long k;
#ifdef _OPENMP
#pragma omp for schedule(dynamic, 16)
#endif
        for (k = 0; k < count; k++) {
            const double *own = common ? p : p + k * @NAME@_parameters;
            status[k] = m == 0 ? (int) DOP853_NO_MEMORY
                               : follow(m, starts + k * @NAME@_size, own, end, tolerance, 0, 0, 0);
            if (status[k] != DOP853_DONE) failed++;
        }
        dop853_free(m);
    }
    return failed;
}
