#lang racket/base
;; A compiled program's operations, one after the other, in other languages.
;;
;; So that the same right-hand side can be integrated there.

(require racket/string
         mechanics/compile/program)

(provide program->C solve-in-C      ; statements that store in dy the value at y
         program->Python)

;; declare : what makes a name, before it; end : of a statement; system : k, entries,
;; n -> statement that solves it
(struct language (indent declare end power absolute system))

(define C
  (language "    " "double " ";" "pow" "fabs"
            (lambda (k entries n)
              (format "double A~a[] = {~a}, v~a[] = {~a}; solve(A~a, ~a, v~a);"
                      k (string-join (apply append (rows entries n)) ", ")
                      k (string-join (right-sides entries n) ", ")
                      k n k))))

(define Python
  (language "    " "" "" "pow" "abs"
            (lambda (k entries n)
              (format "v~a = solve([~a], [~a])" k
                      (string-join (for/list ([r (in-list (rows entries n))])
                                     (format "[~a]" (string-join r ", ")))
                                   ", ")
                      (string-join (right-sides entries n) ", ")))))

(define (program->C p) (program->text p C))
(define (program->Python p) (program->text p Python))

(define (program->text p l)
  (define inputs (program-inputs p))
  (define statements
    (for/list ([i (in-vector (program-instructions p))] [k (in-naturals inputs)])
      (statement i k inputs l)))
  (define outputs
    (for/list ([o (in-vector (program-outputs p))] [k (in-naturals)])
      (format "dy[~a] = ~a~a" k (operand o inputs) (language-end l))))
  (string-append*
   (for/list ([s (in-list (append statements outputs))])
     (string-append (language-indent l) s "\n"))))

(define (statement i k inputs l)
  (define operation (instruction-operation i))
  (define operands (for/list ([o (in-list (instruction-operands i))]) (operand o inputs)))
  (define (let-be text) (format "~av~a = ~a~a" (language-declare l) k text (language-end l)))
  (case operation
    [(solve) ((language-system l) k operands (integer-sqrt (length operands)))]
    [(component) (let-be (format "~a[~a]" (car operands) (caddr i)))]
    [else (let-be (value operation operands l))]))

(define (operand o inputs)
  (cond [(not (place? o)) (number->string (real->double-flonum o))]
        [(< (place-index o) inputs) (format "y[~a]" (place-index o))]
        [else (format "v~a" (place-index o))]))

(define (value operation operands l)
  (define (between sign) (string-join operands sign))
  (define (call name) (format "~a(~a)" name (string-join operands ", ")))
  (case operation
    [(add) (between " + ")]
    [(subtract) (between " - ")]
    [(multiply) (between "*")]
    [(divide) (between "/")]
    [(negate) (string-append "-" (car operands))]
    [(expt) (call (language-power l))]
    [(abs) (call (language-absolute l))]
    [(atan) (call (if (null? (cdr operands)) "atan" "atan2"))]
    [else (call operation)]))

;; Of rows of [A b], one after the other, n of n + 1 entries.
(define (rows entries n)
  (for/list ([i (in-range n)])
    (for/list ([j (in-range n)]) (list-ref entries (+ (* i (+ n 1)) j)))))
(define (right-sides entries n)
  (for/list ([i (in-range n)]) (list-ref entries (+ (* i (+ n 1)) n))))

;; As mechanics/numeric/linear-algebra/factored-system.rkt does it.
(define solve-in-C #<<C
static void solve(double *A, int n, double *b)
{
    for (int k = 0; k < n; k++) {
        int p = k;
        for (int i = k + 1; i < n; i++)
            if (fabs(A[i*n + k]) > fabs(A[p*n + k])) p = i;
        if (p != k) {
            for (int j = 0; j < n; j++) {
                double x = A[k*n + j]; A[k*n + j] = A[p*n + j]; A[p*n + j] = x;
            }
            double x = b[k]; b[k] = b[p]; b[p] = x;
        }
        for (int i = k + 1; i < n; i++) {
            double f = A[i*n + k]/A[k*n + k];
            for (int j = k + 1; j < n; j++) A[i*n + j] -= f*A[k*n + j];
            b[i] -= f*b[k];
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int j = i + 1; j < n; j++) b[i] -= A[i*n + j]*b[j];
        b[i] /= A[i*n + i];
    }
}

C
  )
