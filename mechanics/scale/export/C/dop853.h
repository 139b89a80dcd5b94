/* Motion by the method of Dormand and Prince of order 8, with a step as long as the tolerance
   allows and the states in between by interpolation of order 7 (E. Hairer, S. P. Norsett and
   G. Wanner, Solving Ordinary Differential Equations I, II.5, II.6 and II.10).

   Written by mechanics, for Racket, whose 'Dormand-Prince-853 takes the same steps. */

#ifndef DOP853_H
#define DOP853_H

/* Stores in dy how fast the state y changes; p: the parameters. */
typedef void dop853_slope(const double *y, const double *p, double *dy);

enum dop853_status {
    DOP853_DONE,
    DOP853_NO_SLOPE,       /* the slope is not finite at the last state */
    DOP853_BOUNDARY,       /* it is not finite beyond */
    DOP853_TOO_SHORT,      /* steps became too short to change the time */
    DOP853_TOO_MANY_STEPS,
    DOP853_NO_MEMORY
};

/* The same in words. */
const char *dop853_reason(int status);

/* Room for motions of one system, one after the other. */
typedef struct dop853 dop853;

/* n: how many scalars a state has; clock: which of them is the time, or -1.
   NULL if there is no memory. */
dop853 *dop853_new(int n, int clock, dop853_slope *slope);
void dop853_free(dop853 *m);

/* Follows y, which becomes the last state reached, from one time to another.
   tolerance: of the whole motion, relative to 1 + |y|; most: of steps.
   times: `count` of them on the way, in the order of the motion; the states there are stored
   in rows, one after the other.  reached: if not NULL, the time of the last state.
   -> a dop853_status */
int dop853_evolve(dop853 *m, const double *p, double *y, double start, double end,
                  double tolerance, long most,
                  long count, const double *times, double *rows, double *reached);

#endif
