/* @DEFINITION@

   variables:  @VARIABLES@
   parameters: @PARAMETER_LIST@

   In any units that are consistent.  Written by mechanics, for Racket. */

#ifndef @GUARD@_H
#define @GUARD@_H

enum { @NAME@_size = @SIZE@, @NAME@_parameters = @PARAMETERS@, @NAME@_clock = @CLOCK@ };

/* Stores in dy how fast each variable changes. */
void @NAME@_derivative(const double *y, const double *p, double *dy);
@JACOBIAN@
/* One motion: y becomes the state at the end; the states at `count` times on the way are stored
   in rows.  The time where it begins is the first variable, where that is the time; otherwise 0.
   -> 0, or why it could not be followed (dop853.h) */
int @NAME@_evolve(double *y, const double *p, double end, double tolerance,
                  long count, const double *times, double *rows);

/* Many motions, on all cores where the compiler knows OpenMP.  starts: `count` states, one after
   the other, which become those at the end; p: as many sets of parameters, or one for all if
   `common` is not 0.  status: for each 0, or why it could not be followed.
   -> how many could not be followed to the end */
long @NAME@_ensemble(long count, double *starts, const double *p, int common, double end,
                     double tolerance, int *status);

#endif
