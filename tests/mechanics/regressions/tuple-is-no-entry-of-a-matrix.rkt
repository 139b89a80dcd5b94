#lang racket/base
;; A matrix plus or over a tuple blamed an entry of the matrix, a tuple over a
;; matrix showed the inverse, and powers multiplied n times.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/value/matrix/linear-algebra
         mechanics/value/matrix/matrix
         mechanics/value/structure
         "../support/checks.rkt" "../support/messages.rkt")

(define M (matrix-by-rows '(1 2) '(3 4)))

(test-case "sums and quotients name the matrix and the tuple"
  (check-exn #rx"^[+]: cannot add a 2 by 2 matrix and an up tuple of 2\n"
             (lambda () (g:+ M (up 1 2))))
  (check-exn #rx"^-: cannot subtract a 2 by 2 matrix from a down tuple of 2\n"
             (lambda () (g:- (down 1 2) M)))
  (check-exn #rx"^/: cannot divide a 2 by 2 matrix by an up tuple of 2\n"
             (lambda () (g:/ M (up 1 2))))
  (check-exn
   #rx"^/: cannot divide an up tuple of 2 by a 2 by 2 matrix\n.*\n.*[(]matrix-by-rows [(]list 1 2[)]"
   (lambda () (g:/ (up 1 2) M)))
  (check-equal? (g:* (g:/ (down 1 2) M) M) (down 1 2))
  (check-equal? (g:+ M 'a) (matrix-by-rows (list (g:+ 1 'a) 2) (list 3 (g:+ 4 'a)))))

(test-case "a matrix less an outer product: how that becomes a matrix"
  (define T (outer-product (up 1 2) (down 3 4)))
  (check-message
   (string-append
    "-: cannot subtract a down tuple of 2 from a 2 by 2 matrix\n"
    "  argument 1: (matrix-by-rows (list 1 2) (list 3 4)), a 2 by 2 matrix\n"
    "  argument 2: (down (up 3 6) (up 4 8)), a down tuple of 2\n"
    "  the matrix of a tuple T of tuples is (s->m (down 0 0) T (up 0 0))")
   (g:- M T))
  (check-equal? (g:- M (s->m (down 0 0) T (up 0 0))) (matrix-by-rows '(-2 -2) '(-3 -4)))
  (check-exn #rx"[(]s->m [(]down 0 0[)] T [(]down 0 0[)][)]$"
             (lambda () (g:+ (outer-product (up 1 2) (up 3 4)) M))))

(test-case "powers are repeated products"
  (define (slow n) (for/fold ([p (identity-matrix 2)]) ([_ n]) (g:* p M)))
  (for ([n 9]) (check-equal? (g:expt M n) (slow n)))
  (check-equal? (g:* (g:expt M -3) (g:expt M 3)) (identity-matrix 2)))
