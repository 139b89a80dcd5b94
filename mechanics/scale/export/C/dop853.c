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

    for (i = 0; i < n; i++)
        w[i] = y[i] + h * (0.0526001519587677318785587544488 * k0[i]);
    slope(w, p, k1);
    for (i = 0; i < n; i++)
        w[i] = y[i] + h * (0.0197250569845378994544595329183 * k0[i]
                           + 0.0591751709536136983633785987549 * k1[i]);
    slope(w, p, k2);
    for (i = 0; i < n; i++)
        w[i] = y[i] + h * (0.0295875854768068491816892993775 * k0[i]
                           + 0.0887627564304205475450678981324 * k2[i]);
    slope(w, p, k3);
    for (i = 0; i < n; i++)
        w[i] = y[i] + h * (0.241365134159266685502369798665 * k0[i]
                           - 0.884549479328286085344864962717 * k2[i]
                           + 0.924834003261792003115737966543 * k3[i]);
    slope(w, p, k4);
    for (i = 0; i < n; i++)
        w[i] = y[i] + h * (0.037037037037037037037037037037 * k0[i]
                           + 0.170828608729473871279604482173 * k3[i]
                           + 0.125467687566822425016691814123 * k4[i]);
    slope(w, p, k5);
    for (i = 0; i < n; i++)
        w[i] = y[i] + h * (0.037109375 * k0[i] + 0.170252211019544039314978060272 * k3[i]
                           + 0.0602165389804559606850219397283 * k4[i] - 0.017578125 * k5[i]);
    slope(w, p, k6);
    for (i = 0; i < n; i++)
        w[i] = y[i] + h * (0.0370920001185047927108779319836 * k0[i]
                           + 0.170383925712239993810214054705 * k3[i]
                           + 0.107262030446373284651809199168 * k4[i]
                           - 0.0153194377486244017527936158236 * k5[i]
                           + 0.00827378916381402288758473766002 * k6[i]);
    slope(w, p, k7);
    for (i = 0; i < n; i++)
        w[i] = y[i] + h * (0.624110958716075717114429577812 * k0[i]
                           - 3.36089262944694129406857109825 * k3[i]
                           - 0.868219346841726006818189891453 * k4[i]
                           + 27.5920996994467083049415600797 * k5[i]
                           + 20.1540675504778934086186788979 * k6[i]
                           - 43.4898841810699588477366255144 * k7[i]);
    slope(w, p, k8);
    for (i = 0; i < n; i++)
        w[i] = y[i] + h * (0.477662536438264365890433908527 * k0[i]
                           - 2.48811461997166764192642586468 * k3[i]
                           - 0.590290826836842996371446475743 * k4[i]
                           + 21.2300514481811942347288949897 * k5[i]
                           + 15.2792336328824235832596922938 * k6[i]
                           - 33.2882109689848629194453265587 * k7[i]
                           - 0.0203312017085086261358222928593 * k8[i]);
    slope(w, p, k9);
    for (i = 0; i < n; i++)
        w[i] = y[i] + h * (-0.93714243008598732571704021658 * k0[i]
                           + 5.18637242884406370830023853209 * k3[i]
                           + 1.09143734899672957818500254654 * k4[i]
                           - 8.14978701074692612513997267357 * k5[i]
                           - 18.5200656599969598641566180701 * k6[i]
                           + 22.7394870993505042818970056734 * k7[i]
                           + 2.49360555267965238987089396762 * k8[i]
                           - 3.0467644718982195003823669022 * k9[i]);
    slope(w, p, k10);
    for (i = 0; i < n; i++)
        w[i] = y[i] + h * (2.27331014751653820792359768449 * k0[i]
                           - 10.5344954667372501984066689879 * k3[i]
                           - 2.00087205822486249909675718444 * k4[i]
                           - 17.9589318631187989172765950534 * k5[i]
                           + 27.9488845294199600508499808837 * k6[i]
                           - 2.85899827713502369474065508674 * k7[i]
                           - 8.87285693353062954433549289258 * k8[i]
                           + 12.3605671757943030647266201528 * k9[i]
                           + 0.643392746015763530355970484046 * k10[i]);
    slope(w, p, k11);
    for (i = 0; i < n; i++)
        z[i] = y[i] + h * (0.0542937341165687622380535766363 * k0[i]
                           + 4.45031289275240888144113950566 * k5[i]
                           + 1.89151789931450038304281599044 * k6[i]
                           - 5.8012039600105847814672114227 * k7[i]
                           + 0.31116436695781989440891606237 * k8[i]
                           - 0.152160949662516078556178806805 * k9[i]
                           + 0.201365400804030348374776537501 * k10[i]
                           + 0.0447106157277725905176885569043 * k11[i]);
}

/* How wrong the new state may be, in roots of means over the components, each relative to
   1 + |y|: from two methods of lower order on the same slopes. */
static double error_of(const dop853 *m, double h)
{
    const int n = m->n;
    const double *y = STATE(m), *z = NEW(m);
    const double *k0 = SLOPE(m, 0), *k5 = SLOPE(m, 5), *k6 = SLOPE(m, 6), *k7 = SLOPE(m, 7),
                 *k8 = SLOPE(m, 8), *k9 = SLOPE(m, 9), *k10 = SLOPE(m, 10), *k11 = SLOPE(m, 11);
    double sum5 = 0.0, sum3 = 0.0, e5, e3, root;
    int i;

    for (i = 0; i < n; i++) {
        const double scale = 1.0 + greater(fabs(y[i]), fabs(z[i]));
        const double q5 = (0.01312004499419488073250102996 * k0[i]
                            - 1.225156446376204440720569753 * k5[i]
                            - 0.4957589496572501915214079952 * k6[i]
                            + 1.664377182454986536961530415 * k7[i]
                            - 0.350328848749973681688648729 * k8[i]
                            + 0.3341791187130174790297318841 * k9[i]
                            + 0.08192320648511571246570742613 * k10[i]
                            - 0.02235530786388629525884427845 * k11[i]) / scale;
        const double q3 = (-0.1898007540724076157147023289 * k0[i]
                            + 4.45031289275240888144113950566 * k5[i]
                            + 1.89151789931450038304281599044 * k6[i]
                            - 5.8012039600105847814672114227 * k7[i]
                            - 0.4226823213237919629324456792 * k8[i]
                            - 0.152160949662516078556178806805 * k9[i]
                            + 0.201365400804030348374776537501 * k10[i]
                            + 0.02265179219836082581180620396 * k11[i]) / scale;
        sum5 += q5 * q5;
        sum3 += q3 * q3;
    }
    e5 = fabs(h) * sqrt(sum5 / n);
    e3 = fabs(h) * sqrt(sum3 / n);
    root = sqrt(e5 * e5 + 0.01 * (e3 * e3));
    return root == 0.0 ? 0.0 : e5 * e5 / root;
}

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

    for (i = 0; i < n; i++)
        w[i] = old[i] + h * (0.0561675022830479523392909219681 * k0[i]
                           + 0.253500210216624811088794765333 * k6[i]
                           - 0.246239037470802489917441475441 * k7[i]
                           - 0.124191423263816360469010140626 * k8[i]
                           + 0.15329179827876569731206322685 * k9[i]
                           + 0.00820105229563468988491666602057 * k10[i]
                           + 0.00756789766054569976138603589584 * k11[i] - 0.008298 * k12[i]);
    slope(w, p, k13);
    for (i = 0; i < n; i++)
        w[i] = old[i] + h * (0.0318346481635021405060768473261 * k0[i]
                           + 0.0283009096723667755288322961402 * k5[i]
                           + 0.0535419883074385676223797384372 * k6[i]
                           - 0.0549237485713909884646569340306 * k7[i]
                           - 0.000108347328697249322858509316994 * k10[i]
                           + 0.000382571090835658412954920192323 * k11[i]
                           - 0.000340465008687404560802977114492 * k12[i]
                           + 0.141312443674632500278074618366 * k13[i]);
    slope(w, p, k14);
    for (i = 0; i < n; i++)
        w[i] = old[i] + h * (-0.428896301583791923408573538692 * k0[i]
                           - 4.69762141536116384314449447206 * k5[i]
                           + 7.68342119606259904184240953878 * k6[i]
                           + 4.06898981839711007970213554331 * k7[i]
                           + 0.356727187455281109270669543021 * k8[i]
                           - 0.00139902416515901462129418009734 * k12[i]
                           + 2.9475147891527723389556272149 * k13[i]
                           - 9.15095847217987001081870187138 * k14[i]);
    slope(w, p, k15);
}

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

    for (i = 0; i < n; i++) {
        const double x = old[i];
        const double c0 = y[i] - x;
        const double c1 = h * k0[i] - c0;
        const double c2 = 2.0 * c0 - h * k0[i] - h * k12[i];
        const double c3 =
            h * (-8.4289382761090128651353491142 * k0[i]
                   + 0.5667149535193777696253178359 * k5[i]
                   - 3.0689499459498916912797304727 * k6[i]
                   + 2.384667656512069828772814968 * k7[i]
                   + 2.1170345824450282767155149946 * k8[i]
                   - 0.8713915837779729920678990749 * k9[i]
                   + 2.240437430260788275854177165 * k10[i]
                   + 0.6315787787694688181557024929 * k11[i]
                   - 0.0889903364513333108206981174 * k12[i]
                   + 18.148505520854727256656404962 * k13[i]
                   - 9.1946323924783554000451984436 * k14[i]
                   - 4.4360363875948939664310572 * k15[i]);
        const double c4 =
            h * (10.427508642579134603413151009 * k0[i]
                   + 242.28349177525818288430175319 * k5[i]
                   + 165.20045171727028198505394887 * k6[i]
                   - 374.54675472269020279518312152 * k7[i]
                   - 22.113666853125306036270938578 * k8[i]
                   + 7.7334326684722638389603898808 * k9[i]
                   - 30.674084731089398182061213626 * k10[i]
                   - 9.3321305264302278729567221706 * k11[i]
                   + 15.697238121770843886131091075 * k12[i]
                   - 31.139403219565177677282850411 * k13[i]
                   - 9.3529243588444783865713862664 * k14[i]
                   + 35.81684148639408375246589854 * k15[i]);
        const double c5 =
            h * (19.985053242002433820987653617 * k0[i]
                   - 387.03730874935176555105901742 * k5[i]
                   - 189.17813819516756882830838328 * k6[i]
                   + 527.80815920542364900561016686 * k7[i]
                   - 11.573902539959630126141871134 * k8[i]
                   + 6.8812326946963000169666922661 * k9[i]
                   - 1.000605096691083840318386098 * k10[i]
                   + 0.7777137798053443209286926574 * k11[i]
                   - 2.7782057523535084065932004339 * k12[i]
                   - 60.196695231264120758267380846 * k13[i]
                   + 84.320405506677161018159903784 * k14[i]
                   + 11.99229113618278932803513003 * k15[i]);
        const double c6 =
            h * (-25.693933462703749003312586129 * k0[i]
                   - 154.18974869023643374053993627 * k5[i]
                   - 231.52937917604549567536039109 * k6[i]
                   + 357.6391179106141237828534991 * k7[i]
                   + 93.405324183624310003907691704 * k8[i]
                   - 37.458323136451633156875139351 * k9[i]
                   + 104.09964950896230045147246184 * k10[i]
                   + 29.840293426660503123344363579 * k11[i]
                   - 43.533456590011143754432175058 * k12[i]
                   + 96.3245539591882829483949506 * k13[i]
                   - 39.177261675615439165231486172 * k14[i]
                   - 149.72683625798562581422125276 * k15[i]);
        out[i] = x + a * (c0 + b * (c1 + a * (c2 + b * (c3 + a * (c4 + b * (c5 + a * c6))))));
    }
}

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
