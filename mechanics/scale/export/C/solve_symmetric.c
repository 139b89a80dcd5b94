/* b becomes the solution of A x = b, A symmetric.  A positive definite one, as mass matrices are, is
   L D L^T, without pivots: half the work of elimination, to which others are left. */
static void solve_symmetric(int n, double *A, double *b)
{
    double M[n * n], x[n], inverse[n];
    int i, j, k;
    for (i = 0; i < n; i++) {
        x[i] = b[i];
        for (j = i; j < n; j++) M[i * n + j] = A[i * n + j];
    }
    for (k = 0; k < n; k++) {
        const double *row = M + k * n;
        if (!(row[k] > 1e-13 * A[k * n + k] && row[k] < HUGE_VAL)) {
            solve(n, A, b);
            return;
        }
        inverse[k] = 1.0 / row[k];
        for (i = k + 1; i < n; i++) {
            const double factor = row[i] * inverse[k];
            for (j = i; j < n; j++) M[i * n + j] -= factor * row[j];
            x[i] -= factor * x[k];
        }
    }
    for (k = n - 1; k >= 0; k--) {
        for (j = k + 1; j < n; j++) x[k] -= M[k * n + j] * x[j];
        x[k] *= inverse[k];
    }
    for (k = 0; k < n; k++) b[k] = x[k];
}
