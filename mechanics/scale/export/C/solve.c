/* b becomes the solution of A x = b, by elimination with partial pivoting; where A is singular
   nothing in it is a number. */
static void solve(int n, double *A, double *b)
{
    int i, j, k;
    for (k = 0; k < n; k++) {
        double *row = A + k * n;
        double x, inverse;
        int pivot = k;
        for (i = k + 1; i < n; i++)
            if (fabs(A[i * n + k]) > fabs(A[pivot * n + k])) pivot = i;
        if (pivot != k) {
            for (j = 0; j < n; j++) {
                x = row[j];
                row[j] = A[pivot * n + j];
                A[pivot * n + j] = x;
            }
            x = b[k];
            b[k] = b[pivot];
            b[pivot] = x;
        }
        if (!(fabs(row[k]) > 0.0 && fabs(row[k]) < HUGE_VAL)) {
            for (i = 0; i < n; i++) b[i] = NAN;
            return;
        }
        inverse = 1.0 / row[k];
        for (i = k + 1; i < n; i++) {
            double *below = A + i * n;
            const double factor = below[k] * inverse;
            below[k] = factor;
            if (factor != 0.0)
                for (j = k + 1; j < n; j++) below[j] -= factor * row[j];
        }
    }
    for (i = 1; i < n; i++)
        for (j = 0; j < i; j++) b[i] -= A[i * n + j] * b[j];
    for (i = n - 1; i >= 0; i--) {
        for (j = i + 1; j < n; j++) b[i] -= A[i * n + j] * b[j];
        b[i] /= A[i * n + i];
    }
}
