/* ./@NAME@ END [TOLERANCE] < starts > finals

   A line of the input is a start: the variables (@VARIABLES@), then
   the parameters (@PARAMETER_LIST@), with spaces between them.  A line of the
   output is the state at END, or `#` and why the motion cannot be followed so far, and where. */

#include "@NAME@.h"
#include "dop853.h"

#include <stdio.h>
#include <stdlib.h>

enum { batch = 1024, columns = @NAME@_size + @NAME@_parameters };

static double states[batch * @NAME@_size];
static double parameters[batch * (@NAME@_parameters + 1)];
static int status[batch];

/* -> 1, 0 at the end of the input, or -1 */
static int read_row(long k)
{
    int i;
    for (i = 0; i < columns; i++) {
        double x;
        const int found = scanf("%lf", &x);
        if (found != 1) return i == 0 && found == EOF ? 0 : -1;
        if (i < @NAME@_size)
            states[k * @NAME@_size + i] = x;
        else
            parameters[k * @NAME@_parameters + i - @NAME@_size] = x;
    }
    return 1;
}

static void write_row(long k)
{
    int i;
    if (status[k] != DOP853_DONE) printf("# %s:", dop853_reason(status[k]));
    for (i = 0; i < @NAME@_size; i++)
        printf(i == 0 && status[k] == DOP853_DONE ? "%.17g" : " %.17g",
               states[k * @NAME@_size + i]);
    printf("\n");
}

static int read_number(const char *text, double *x)
{
    char *rest;
    *x = strtod(text, &rest);
    return rest != text && *rest == 0;
}

int main(int argc, char **argv)
{
    double end, tolerance = 1e-10;
    long count, failed = 0, row = 0, k;
    int more = 1;

    if (argc < 2 || argc > 3) {
        fprintf(stderr, "%s END [TOLERANCE] < starts > finals\n", argv[0]);
        return 2;
    }
    if (!read_number(argv[1], &end) || (argc == 3 && !read_number(argv[2], &tolerance))) {
        fprintf(stderr, "%s: END and TOLERANCE are numbers\n", argv[0]);
        return 2;
    }
    while (more == 1) {
        for (count = 0; count < batch && (more = read_row(count)) == 1; count++) row++;
        if (more == -1) {
            fprintf(stderr, "row %ld: expected %d numbers\n", row + 1, (int) columns);
            return 1;
        }
        failed += @NAME@_ensemble(count, states, parameters, 0, end, tolerance, status);
        for (k = 0; k < count; k++) write_row(k);
    }
    return failed == 0 ? 0 : 1;
}
