/* The integrator of mechanics/numeric/ode in C, to compare with: the method of Dormand
   and Prince of order 8 with its interpolation, the same estimate of the error, the same
   control of the length of steps (see dormand-prince-853.rkt, step-size.rkt and
   integrate.rkt, where it is explained).

       dop853 TOLERANCE END OUTPUT-STEP REPETITIONS

   integrates the system it is linked with from time 0 to END and interpolates the state
   every OUTPUT-STEP, or never if that is 0.  Prints steps, evaluations, the milliseconds
   of CPU of the fastest repetition and the state at the end. */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* The system. */
extern const int size;
extern const double initial[];
void slope(const double *y, double *dy);

enum { LARGEST = 256 };
#define EACH for (int i = 0; i < n; i++)

static int n;
static long steps, evaluations;
static double y[LARGEST], z[LARGEST], w[LARGEST], old[LARGEST], e5[LARGEST], e3[LARGEST];
static double k0[LARGEST], k1[LARGEST], k2[LARGEST], k3[LARGEST], k4[LARGEST], k5[LARGEST],
    k6[LARGEST], k7[LARGEST], k8[LARGEST], k9[LARGEST], k10[LARGEST], k11[LARGEST],
    k12[LARGEST], k13[LARGEST], k14[LARGEST], k15[LARGEST];
static double c0[LARGEST], c1[LARGEST], c2[LARGEST], c3[LARGEST], c4[LARGEST], c5[LARGEST],
    c6[LARGEST];

static void evaluate(const double *at, double *k)
{
    evaluations++;
    slope(at, k);
}

static void copy(double *to, const double *from) { memcpy(to, from, n*sizeof(double)); }

/* ------------------------------------------------------------------------- */

static double root_mean_square(const double *x, const double *a, const double *b)
{
    double total = 0;
    EACH {
        double p = fabs(a[i]), q = fabs(b[i]);
        double r = x[i]/(1 + (p > q ? p : q));
        total += r*r;
    }
    return sqrt(total/n);
}

/* From y over a time h to z; -> the error */
static double try_step(double h)
{
    EACH w[i] = y[i] + h*(0.0526001519587677318785587544488*k0[i]);
    evaluate(w, k1);
    EACH w[i] = y[i] + h*(0.0197250569845378994544595329183*k0[i]
            + 0.0591751709536136983633785987549*k1[i]);
    evaluate(w, k2);
    EACH w[i] = y[i] + h*(0.0295875854768068491816892993775*k0[i]
            + 0.0887627564304205475450678981324*k2[i]);
    evaluate(w, k3);
    EACH w[i] = y[i] + h*(0.241365134159266685502369798665*k0[i]
            - 0.884549479328286085344864962717*k2[i]
            + 0.924834003261792003115737966543*k3[i]);
    evaluate(w, k4);
    EACH w[i] = y[i] + h*(0.037037037037037037037037037037*k0[i]
            + 0.170828608729473871279604482173*k3[i]
            + 0.125467687566822425016691814123*k4[i]);
    evaluate(w, k5);
    EACH w[i] = y[i] + h*(0.037109375*k0[i] + 0.170252211019544039314978060272*k3[i]
            + 0.0602165389804559606850219397283*k4[i] - 0.017578125*k5[i]);
    evaluate(w, k6);
    EACH w[i] = y[i] + h*(0.0370920001185047927108779319836*k0[i]
            + 0.170383925712239993810214054705*k3[i]
            + 0.107262030446373284651809199168*k4[i]
            - 0.0153194377486244017527936158236*k5[i]
            + 0.00827378916381402288758473766002*k6[i]);
    evaluate(w, k7);
    EACH w[i] = y[i] + h*(0.624110958716075717114429577812*k0[i]
            - 3.36089262944694129406857109825*k3[i] - 0.868219346841726006818189891453*k4[i]
            + 27.5920996994467083049415600797*k5[i] + 20.1540675504778934086186788979*k6[i]
            - 43.4898841810699588477366255144*k7[i]);
    evaluate(w, k8);
    EACH w[i] = y[i] + h*(0.477662536438264365890433908527*k0[i]
            - 2.48811461997166764192642586468*k3[i] - 0.590290826836842996371446475743*k4[i]
            + 21.2300514481811942347288949897*k5[i] + 15.2792336328824235832596922938*k6[i]
            - 33.2882109689848629194453265587*k7[i]
            - 0.0203312017085086261358222928593*k8[i]);
    evaluate(w, k9);
    EACH w[i] = y[i] + h*(-0.93714243008598732571704021658*k0[i]
            + 5.18637242884406370830023853209*k3[i] + 1.09143734899672957818500254654*k4[i]
            - 8.14978701074692612513997267357*k5[i] - 18.5200656599969598641566180701*k6[i]
            + 22.7394870993505042818970056734*k7[i] + 2.49360555267965238987089396762*k8[i]
            - 3.0467644718982195003823669022*k9[i]);
    evaluate(w, k10);
    EACH w[i] = y[i] + h*(2.27331014751653820792359768449*k0[i]
            - 10.5344954667372501984066689879*k3[i] - 2.00087205822486249909675718444*k4[i]
            - 17.9589318631187989172765950534*k5[i] + 27.9488845294199600508499808837*k6[i]
            - 2.85899827713502369474065508674*k7[i] - 8.87285693353062954433549289258*k8[i]
            + 12.3605671757943030647266201528*k9[i]
            + 0.643392746015763530355970484046*k10[i]);
    evaluate(w, k11);
    EACH z[i] = y[i] + h*(0.0542937341165687622380535766363*k0[i]
            + 4.45031289275240888144113950566*k5[i] + 1.89151789931450038304281599044*k6[i]
            - 5.8012039600105847814672114227*k7[i] + 0.31116436695781989440891606237*k8[i]
            - 0.152160949662516078556178806805*k9[i]
            + 0.201365400804030348374776537501*k10[i]
            + 0.0447106157277725905176885569043*k11[i]);
    EACH e5[i] = 0.01312004499419488073250102996*k0[i] - 1.225156446376204440720569753*k5[i]
            - 0.4957589496572501915214079952*k6[i] + 1.664377182454986536961530415*k7[i]
            - 0.350328848749973681688648729*k8[i] + 0.3341791187130174790297318841*k9[i]
            + 0.08192320648511571246570742613*k10[i]
            - 0.02235530786388629525884427845*k11[i];
    EACH e3[i] = -0.1898007540724076157147023289*k0[i]
            + 4.45031289275240888144113950566*k5[i] + 1.89151789931450038304281599044*k6[i]
            - 5.8012039600105847814672114227*k7[i] - 0.4226823213237919629324456792*k8[i]
            - 0.152160949662516078556178806805*k9[i]
            + 0.201365400804030348374776537501*k10[i]
            + 0.02265179219836082581180620396*k11[i];
    double a = fabs(h)*root_mean_square(e5, y, z);
    double b = fabs(h)*root_mean_square(e3, y, z);
    double root = sqrt(a*a + 0.01*(b*b));
    return root == 0 ? 0 : a*a/root;
}

static void accept(void)
{
    copy(old, y);
    copy(y, z);
    evaluate(y, k12);
}

/* The polynomial within the step accepted last. */
static void interpolant(double h)
{
    EACH w[i] = old[i] + h*(0.0561675022830479523392909219681*k0[i]
            + 0.253500210216624811088794765333*k6[i]
            - 0.246239037470802489917441475441*k7[i]
            - 0.124191423263816360469010140626*k8[i] + 0.15329179827876569731206322685*k9[i]
            + 0.00820105229563468988491666602057*k10[i]
            + 0.00756789766054569976138603589584*k11[i] - 0.008298*k12[i]);
    evaluate(w, k13);
    EACH w[i] = old[i] + h*(0.0318346481635021405060768473261*k0[i]
            + 0.0283009096723667755288322961402*k5[i]
            + 0.0535419883074385676223797384372*k6[i]
            - 0.0549237485713909884646569340306*k7[i]
            - 0.000108347328697249322858509316994*k10[i]
            + 0.000382571090835658412954920192323*k11[i]
            - 0.000340465008687404560802977114492*k12[i]
            + 0.141312443674632500278074618366*k13[i]);
    evaluate(w, k14);
    EACH w[i] = old[i] + h*(-0.428896301583791923408573538692*k0[i]
            - 4.69762141536116384314449447206*k5[i] + 7.68342119606259904184240953878*k6[i]
            + 4.06898981839711007970213554331*k7[i] + 0.356727187455281109270669543021*k8[i]
            - 0.00139902416515901462129418009734*k12[i]
            + 2.9475147891527723389556272149*k13[i] - 9.15095847217987001081870187138*k14[i]);
    evaluate(w, k15);
    EACH c0[i] = y[i] - old[i];
    EACH c1[i] = h*k0[i] - c0[i];
    EACH c2[i] = 2*c0[i] - h*k0[i] - h*k12[i];
    EACH c3[i] = h*(-8.4289382761090128651353491142*k0[i]
            + 0.5667149535193777696253178359*k5[i] - 3.0689499459498916912797304727*k6[i]
            + 2.384667656512069828772814968*k7[i] + 2.1170345824450282767155149946*k8[i]
            - 0.8713915837779729920678990749*k9[i] + 2.240437430260788275854177165*k10[i]
            + 0.6315787787694688181557024929*k11[i] - 0.0889903364513333108206981174*k12[i]
            + 18.148505520854727256656404962*k13[i] - 9.1946323924783554000451984436*k14[i]
            - 4.4360363875948939664310572*k15[i]);
    EACH c4[i] = h*(10.427508642579134603413151009*k0[i]
            + 242.28349177525818288430175319*k5[i] + 165.20045171727028198505394887*k6[i]
            - 374.54675472269020279518312152*k7[i] - 22.113666853125306036270938578*k8[i]
            + 7.7334326684722638389603898808*k9[i] - 30.674084731089398182061213626*k10[i]
            - 9.3321305264302278729567221706*k11[i] + 15.697238121770843886131091075*k12[i]
            - 31.139403219565177677282850411*k13[i] - 9.3529243588444783865713862664*k14[i]
            + 35.81684148639408375246589854*k15[i]);
    EACH c5[i] = h*(19.985053242002433820987653617*k0[i]
            - 387.03730874935176555105901742*k5[i] - 189.17813819516756882830838328*k6[i]
            + 527.80815920542364900561016686*k7[i] - 11.573902539959630126141871134*k8[i]
            + 6.8812326946963000169666922661*k9[i] - 1.000605096691083840318386098*k10[i]
            + 0.7777137798053443209286926574*k11[i] - 2.7782057523535084065932004339*k12[i]
            - 60.196695231264120758267380846*k13[i] + 84.320405506677161018159903784*k14[i]
            + 11.99229113618278932803513003*k15[i]);
    EACH c6[i] = h*(-25.693933462703749003312586129*k0[i]
            - 154.18974869023643374053993627*k5[i] - 231.52937917604549567536039109*k6[i]
            + 357.6391179106141237828534991*k7[i] + 93.405324183624310003907691704*k8[i]
            - 37.458323136451633156875139351*k9[i] + 104.09964950896230045147246184*k10[i]
            + 29.840293426660503123344363579*k11[i] - 43.533456590011143754432175058*k12[i]
            + 96.3245539591882829483949506*k13[i] - 39.177261675615439165231486172*k14[i]
            - 149.72683625798562581422125276*k15[i]);
}

static void state_within(double theta, double *out)
{
    double r = 1 - theta;
    EACH out[i] = old[i] + theta*(c0[i] + r*(c1[i] + theta*(c2[i] + r*(c3[i]
        + theta*(c4[i] + r*(c5[i] + theta*c6[i]))))));
}

/* ------------------------------------------------------------------------- */

static double least(double a, double b) { return a < b ? a : b; }
static double greatest(double a, double b) { return a > b ? a : b; }

static double next_length(double h, double error)
{
    double growth = error == 0 ? 6 : error < INFINITY ? 0.9*pow(error, -1.0/8) : 0.2;
    return h*greatest(0.2, least(6, growth));
}

static double first_length(double tolerance, double span)
{
    double d0 = root_mean_square(y, y, y)/tolerance, d1 = root_mean_square(k0, y, y)/tolerance;
    double h0 = d0 < 1e-5 || d1 < 1e-5 ? 1e-6 : 0.01*(d0/d1);
    double h = least(h0, span);
    EACH w[i] = y[i] + h*k0[i];
    evaluate(w, k1);
    EACH k1[i] -= k0[i];
    double steepest = greatest(d1, root_mean_square(k1, y, y)/tolerance/h);
    double h1 = steepest <= 1e-15 ? greatest(1e-6, 1e-3*h0) : pow(0.01/steepest, 1.0/8);
    return least(span, least(100*h0, h1));
}

/* -> a sum over the states that were asked for, so that they are not left out */
static double integrate(double tolerance, double end, double output_step)
{
    static double out[LARGEST];
    double t = 0, sum = 0;
    long shown = 1;
    tolerance = greatest(4e-16, 0.1*tolerance);
    steps = evaluations = 0;
    copy(y, initial);
    evaluate(y, k0);
    double h = first_length(tolerance, end);
    while (t < end) {
        double remaining = end - t;
        double now = h >= (1 - 1e-7)*remaining ? end : t + h;
        double length = now - t;
        double error = try_step(length)/tolerance;
        h = next_length(length, error);
        if (!(error <= 1)) continue;
        accept();
        y[0] = now;
        if (output_step > 0 && shown*output_step <= now) {
            interpolant(length);
            for (; shown*output_step <= now; shown++) {
                state_within((shown*output_step - t)/(now - t), out);
                sum += out[1];
            }
        }
        copy(k0, k12);
        t = now;
        steps++;
    }
    return sum;
}

static double milliseconds(void)
{
    struct timespec s;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &s);
    return 1e3*s.tv_sec + 1e-6*s.tv_nsec;
}

int main(int count, char **arguments)
{
    if (count != 5) return 1;
    double tolerance = atof(arguments[1]), end = atof(arguments[2]);
    double output_step = atof(arguments[3]), best = INFINITY;
    volatile double sum;
    n = size;
    for (int k = atoi(arguments[4]); k > 0; k--) {
        double start = milliseconds();
        sum = integrate(tolerance, end, output_step);
        best = least(best, milliseconds() - start);
    }
    (void)sum;
    printf("(%ld %ld %.6f", steps, evaluations, best);
    EACH printf(" %.17g", y[i]);
    printf(")\n");
    return 0;
}
