/* See dop853.h.  The order of all operations is that of the library's own method: on one
   machine both take the same steps, to the last bit. */

#include "dop853.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define VECTORS 20

struct dop853 {
    int n, clock;
    dop853_slope *slope;
    double *room;                    /* VECTORS vectors of n */
};

/* The vectors.  After a step that was accepted k[0] is the slope at its end, which is the
   first of the next step, and `first` the one where it began. */
#define STATE(m)   ((m)->room)
#define NEW(m)     ((m)->room + (m)->n)
#define WORK(m)    ((m)->room + 2 * (m)->n)
#define OLD(m)     ((m)->room + 3 * (m)->n)
#define FIRST(m)   ((m)->room + 4 * (m)->n)
#define SLOPE(m,k) ((m)->room + (5 + (k)) * (m)->n)

dop853 *dop853_new(int n, int clock, dop853_slope *slope)
{
    dop853 *m = malloc(sizeof *m);
    if (m == NULL) return NULL;
    m->n = n;
    m->clock = clock;
    m->slope = slope;
    m->room = calloc((size_t) VECTORS * (size_t) n, sizeof(double));
    if (m->room == NULL) {
        free(m);
        return NULL;
    }
    return m;
}

void dop853_free(dop853 *m)
{
    if (m != NULL) free(m->room);
    free(m);
}

const char *dop853_reason(int status)
{
    switch (status) {
    case DOP853_DONE: return "done";
    case DOP853_NO_SLOPE: return "the state derivative is not finite at the last state";
    case DOP853_BOUNDARY: return "the state derivative is not finite beyond the last state";
    case DOP853_TOO_SHORT: return "steps became too short to change the time";
    case DOP853_TOO_MANY_STEPS: return "the motion takes more steps than allowed";
    case DOP853_NO_MEMORY: return "there is no memory left";
    default: return "unknown";
    }
}

/* ------------------------------------------------------------------------- */
/* A step */

static double greater(double x, double y) { return x > y ? x : y; }
static double lesser(double x, double y) { return x < y ? x : y; }

static void take_slopes(dop853 *m, const double *p, double h)
{
    const int n = m->n;
    dop853_slope *const slope = m->slope;
    const double *y = STATE(m);
    double *z = NEW(m), *w = WORK(m);
    double *k0 = SLOPE(m, 0), *k1 = SLOPE(m, 1), *k2 = SLOPE(m, 2), *k3 = SLOPE(m, 3),
           *k4 = SLOPE(m, 4), *k5 = SLOPE(m, 5), *k6 = SLOPE(m, 6), *k7 = SLOPE(m, 7),
           *k8 = SLOPE(m, 8), *k9 = SLOPE(m, 9), *k10 = SLOPE(m, 10), *k11 = SLOPE(m, 11);
    int i;

@STAGES@}

/* How wrong the new state may be, in roots of means over the components, each relative to
   1 + |y|: from two methods of lower order on the same slopes. */
static double error_of(const dop853 *m, double h)
{
    const int n = m->n;
    const double *y = STATE(m), *z = NEW(m);
    const double *k0 = SLOPE(m, 0), *k5 = SLOPE(m, 5), *k6 = SLOPE(m, 6), *k7 = SLOPE(m, 7),
                 *k8 = SLOPE(m, 8), *k9 = SLOPE(m, 9), *k10 = SLOPE(m, 10), *k11 = SLOPE(m, 11);
    double e5 = 0.0, e3 = 0.0;
    int i;

@ERROR@}

static double try_step(dop853 *m, const double *p, double h)
{
    take_slopes(m, p, h);
    return error_of(m, h);
}

static void accept_step(dop853 *m, const double *p)
{
    const size_t size = (size_t) m->n * sizeof(double);
    memcpy(OLD(m), STATE(m), size);
    memcpy(STATE(m), NEW(m), size);
    memcpy(FIRST(m), SLOPE(m, 0), size);
    m->slope(STATE(m), p, SLOPE(m, 0));
}

/* ------------------------------------------------------------------------- */
/* Within a step */

/* Three more slopes, once for a step in which states are asked for. */
static void take_further_slopes(dop853 *m, const double *p, double h)
{
    const int n = m->n;
    dop853_slope *const slope = m->slope;
    const double *old = OLD(m);
    double *w = WORK(m);
    const double *k0 = FIRST(m), *k12 = SLOPE(m, 0), *k5 = SLOPE(m, 5), *k6 = SLOPE(m, 6),
                 *k7 = SLOPE(m, 7), *k8 = SLOPE(m, 8), *k9 = SLOPE(m, 9), *k10 = SLOPE(m, 10),
                 *k11 = SLOPE(m, 11);
    double *k13 = SLOPE(m, 12), *k14 = SLOPE(m, 13), *k15 = SLOPE(m, 14);
    int i;

@FURTHER_STAGES@}

/* The state at the fraction a of the step of length h that was accepted last. */
static void state_within(const dop853 *m, double h, double a, double *out)
{
    const int n = m->n;
    const double b = 1.0 - a;
    const double *old = OLD(m), *y = STATE(m);
    const double *k0 = FIRST(m), *k12 = SLOPE(m, 0), *k5 = SLOPE(m, 5), *k6 = SLOPE(m, 6),
                 *k7 = SLOPE(m, 7), *k8 = SLOPE(m, 8), *k9 = SLOPE(m, 9), *k10 = SLOPE(m, 10),
                 *k11 = SLOPE(m, 11), *k13 = SLOPE(m, 12), *k14 = SLOPE(m, 13),
                 *k15 = SLOPE(m, 14);
    int i;

@WITHIN@}

/* ------------------------------------------------------------------------- */
/* The length of steps: nine tenths of what would have been just right, and never more than six
   times or less than a fifth of the last one. */

static double next_length(double h, double error)
{
    double growth = 0.2;
    if (error == 0.0)
        growth = 6.0;
    else if (error < HUGE_VAL)
        growth = 0.9 * pow(error, -1.0 / 8.0);
    return h * greater(0.2, lesser(6.0, growth));
}

static double size_of(const double *x, const double *y, int n, double tolerance)
{
    double sum = 0.0;
    int i;
    for (i = 0; i < n; i++) {
        const double q = x[i] / (1.0 + fabs(y[i]));
        sum += q * q;
    }
    return sqrt(sum / n) / tolerance;
}

/* Of the first step, from the sizes of the state, of its slope and of the change of that. */
static double first_length(dop853 *m, const double *p, double tolerance, double sign, double span)
{
    const int n = m->n;
    const double *y = STATE(m), *slope = SLOPE(m, 0);
    double *w = WORK(m), *change = NEW(m);
    const double d0 = size_of(y, y, n, tolerance), d1 = size_of(slope, y, n, tolerance);
    const double h0 = d0 < 1e-5 || d1 < 1e-5 ? 1e-6 : 0.01 * (d0 / d1);
    const double h = sign * lesser(h0, span);
    double steepest, h1, proposed;
    int i;

    for (i = 0; i < n; i++) w[i] = y[i] + h * slope[i];
    m->slope(w, p, change);
    for (i = 0; i < n; i++) change[i] -= slope[i];
    steepest = greater(d1, size_of(change, y, n, tolerance) / fabs(h));
    h1 = steepest <= 1e-15 ? greater(1e-6, 1e-3 * h0) : pow(0.01 / steepest, 1.0 / 8.0);
    proposed = lesser(100.0 * h0, h1);
    return lesser(span, 0.0 < proposed && proposed < HUGE_VAL ? proposed : 1e-6);
}

/* ------------------------------------------------------------------------- */
/* The motion */

static int finite_slope(dop853 *m, const double *p)
{
    int i;
    m->slope(STATE(m), p, WORK(m));
    for (i = 0; i < m->n; i++)
        if (!(fabs(WORK(m)[i]) < HUGE_VAL)) return 0;
    return 1;
}

/* The errors of many steps add up: each may have a tenth of the tolerance. */
static double step_tolerance(double tolerance) { return greater(1e-15, 0.1 * tolerance); }

static const int most_failures = 100;

/* t + h, or what is next to t if that is t. */
static double later(double t, double h)
{
    const double now = t + h, least = 2.220446049250313e-16 * fabs(t);
    return now == t ? t + (h < 0.0 ? -least : least) : now;
}

/* One step that is accepted.  t, h: the time and the length tried first, which become the time
   after the step and the length of the next one; finite: were all errors finite?
   The time after it is rounded, and the step is as long as that says.
   -> a status */
static int take_step(dop853 *m, const double *p, double tolerance, double sign, double end,
                     double *t, double *h, double *taken, int *finite)
{
    const double remaining = fabs(end - *t);
    *finite = 1;
    for (;;) {
        const double now = *h >= (1.0 - 1e-7) * remaining ? end : later(*t, sign * *h);
        const double length = fabs(now - *t);
        const double error = try_step(m, p, sign * length) / tolerance;
        const double next = next_length(length, error);
        if (error <= 1.0) {
            if (*t + *h == *t && next <= length) return DOP853_TOO_SHORT;
            accept_step(m, p);
            *t = now;
            *h = next;
            *taken = sign * length;
            return DOP853_DONE;
        }
        if (*t + 0.125 * length == *t) return DOP853_TOO_SHORT;
        if (!(error < HUGE_VAL)) *finite = 0;
        *h = now == later(*t, sign * next) ? 0.75 * length : next;  /* as rounding has it */
    }
}

/* The states at those of the times that the step from one to another covers. */
static long store_rows(dop853 *m, const double *p, double sign, double from, double to,
                       double taken, long k, long count, const double *times, double *rows)
{
    int ready = 0;
    for (; k < count && sign * (to - times[k]) >= 0.0; k++) {
        double *row = rows + k * m->n;
        if (times[k] == to)
            memcpy(row, STATE(m), (size_t) m->n * sizeof(double));
        else {
            if (!ready) take_further_slopes(m, p, taken);
            ready = 1;
            state_within(m, taken, (times[k] - from) / (to - from), row);
        }
        if (m->clock >= 0) row[m->clock] = times[k];
    }
    return k;
}

int dop853_evolve(dop853 *m, const double *p, double *y, double start, double end,
                  double tolerance, long most,
                  long count, const double *times, double *rows, double *reached)
{
    const size_t size = (size_t) m->n * sizeof(double);
    const double sign = end < start ? -1.0 : 1.0;
    const double tolerated = step_tolerance(tolerance);
    double t = start, h, taken;
    long steps = 0, k = 0;
    int failures = 0, finite, status = DOP853_DONE;

    memcpy(STATE(m), y, size);
    for (; k < count && times[k] == start; k++) memcpy(rows + k * m->n, y, size);
    m->slope(STATE(m), p, SLOPE(m, 0));
    h = first_length(m, p, tolerated, sign, fabs(end - start));
    while (t != end && status == DOP853_DONE) {
        const double from = t;
        if (steps >= most)
            status = DOP853_TOO_MANY_STEPS;
        else if (failures == most_failures)
            status = DOP853_BOUNDARY;
        else
            status = take_step(m, p, tolerated, sign, end, &t, &h, &taken, &finite);
        if (status != DOP853_DONE) break;
        if (m->clock >= 0) STATE(m)[m->clock] = t;
        k = store_rows(m, p, sign, from, t, taken, k, count, times, rows);
        steps++;
        failures = finite ? 0 : failures + 1;
    }
    if (status != DOP853_DONE && status != DOP853_TOO_MANY_STEPS && !finite_slope(m, p))
        status = DOP853_NO_SLOPE;
    memcpy(y, STATE(m), size);
    if (reached != NULL) *reached = t;
    return status;
}
