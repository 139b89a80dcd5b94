#lang racket/base
;; Frequencies ω and shapes v with (K − ω²M + iωG) v = 0.
;;
;; Coordinates that do not act on one another are parted first.  One coordinate has
;; ω² = K/M; for two the determinant is a quadratic equation in ω²,
;;
;;   |M| ω⁴ − (M₁₁K₂₂ + M₂₂K₁₁ − 2M₁₂K₁₂ + g²) ω² + |K| = 0,     g = G₁₂.
;;
;; More coordinates are left to numbers: where M and K are numbers but for a factor
;; each, as in a chain of equal pendulums, the factors come out of the square root.

(require racket/list
         (prefix-in algebra: "../algebra/expression/constant-value.rkt")
         "../algebra/expression/symbols.rkt" "../algebra/zero/constant-bounds.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/compare.rkt" "../generic/describe.rkt"
         "../generic/elementary.rkt" "../generic/on-demand.rkt"
         "../numeric/linear-algebra/row-matrix.rkt"
         "../value/exact-root.rkt" "../value/simplify.rkt"
         "../value/matrix/row-products.rkt" "../value/matrix/row-systems.rkt")

(provide modes-of constant-value frequency-equation raise-not-positive)

(require-on-demand ["../numeric/linear-algebra/numeric-modes.rkt" gyroscopic-modes]
                   ["refined-modes.rkt" refined-modes])

;; M, K, G : vectors of rows of simplified scalars
;; -> a list of (frequency component ...)
(define (modes-of who M K G)
  (define n (vector-length M))
  (define found
    (append*
     (for/list ([block (in-list (components n (list M K G)))])
       (define (part rows) (submatrix rows block block))
       (for/list ([mode (in-list (block-modes who (part M) (part K) (part G)))])
         (cons (car mode) (spread (cdr mode) block n))))))
  (define (size mode) (constant-value (car mode)))
  (if (andmap real? (map size found)) (sort found < #:key size #:cache-keys? #t) found))

;; The number, real or imaginary, that an expression without symbols is, or #f.
(define (constant-value e)
  (define (value e) (or (constant-bounds e close-number) (algebra:constant-value e)))
  (cond [(number? e) e]
        [(pair? (symbols-in e)) #f]
        [(value e)]
        [(value (simplify (g:* -i e))) => (lambda (x) (* +i x))]
        [else #f]))

(define (close-number low high)
  (and (<= (- high low) (* 1e-15 (abs low))) (exact->inexact low)))

;; Zeros where the block has no coordinate.
(define (spread shape block n)
  (for/list ([i (in-range n)])
    (cond [(index-of block i) => (lambda (j) (list-ref shape j))] [else 0])))

;; Lists of the indices that are joined by entries other than zero.
(define (components n matrices)
  (define (joined? i j)
    (for/or ([rows (in-list matrices)])
      (not (and (g:zero? (entry rows i j)) (g:zero? (entry rows j i))))))
  (joined-groups n joined?))

(define (block-modes who M K G)
  (define all (append-map leaves (list M K G)))
  (cond [(and (andmap real? all) (or (> (vector-length M) 2) (ormap flonum? all)))
         (numeric-modes who M K G)]
        [(> (vector-length M) 2) (scaled-modes who M K G)]
        [(g:zero? (simplify (rows-determinant M))) (raise-not-positive who M)]
        [(= (vector-length M) 2) (two-modes M K G)]
        [else (one-mode (entry M 0 0) (entry K 0 0))]))

;; ---------------------------------------------------------------------------
;; One coordinate and two

(define (one-mode m k) (list (list (exact-root (g:/ k m)) 1)))

;; -> |M|, the coefficient b of −ω², and |K|
(define (frequency-equation M K G)
  (define (times i j k l) (g:* (entry M i j) (entry K k l)))
  (values (rows-determinant M)
          (g:+ (times 0 0 1 1) (times 1 1 0 0) (g:* -2 (times 0 1 0 1)) (g:square (entry G 0 1)))
          (rows-determinant K)))

(define (two-modes M K G)
  (define-values (a b c) (frequency-equation M K G))
  (define root (exact-root (simplify (g:- (g:square b) (g:* 4 a c)))))
  (define (frequency sign) (exact-root (simplify (g:/ (g:+ b (g:* sign root)) (g:* 2 a)))))
  (if (g:zero? root)
      (equal-frequencies (frequency 1) M K G)
      (for/list ([sign '(-1 1)])
        (define omega (frequency sign))
        (cons omega (null-vector M K G omega)))))

;; Of two that coincide each displacement is a mode, unless G keeps one from moving alone.
(define (equal-frequencies omega M K G)
  (if (g:zero? (entry G 0 1))
      (list (list omega 1 0) (list omega 0 1))
      (let ([shape (null-vector M K G omega)])
        (list (cons omega shape) (cons omega shape)))))

;; At right angles to a row of K − ω²M + iωG that is not zero; its first component 1
;; where it has one.
(define (null-vector M K G omega)
  (define (A i j)
    (simplify (g:+ (entry K i j) (g:* -1 (g:square omega) (entry M i j))
                   (g:* +i omega (entry G i j)))))
  (define-values (x y)
    (if (and (g:zero? (A 0 0)) (g:zero? (A 0 1)))
        (values (A 1 1) (g:negate (A 1 0)))
        (values (g:negate (A 0 1)) (A 0 0))))
  (if (g:zero? x) '(0 1) (list 1 (simplify (g:/ y x)))))

;; ---------------------------------------------------------------------------
;; Numbers

(define (numeric-modes who M K G)
  (define modes
    (if (all-entries? g:zero? G) (refined-modes who M K) (gyroscopic-modes M K G)))
  (or modes (raise-not-positive who M)))

;; M = μ M₀, K = κ K₀: ω² is κ/μ times that of the numbers M₀ and K₀.
(define (scaled-modes who M K G)
  (define-values (mu M0) (numbers-with-factor M))
  (define-values (kappa K0) (numbers-with-factor K))
  (unless (and M0 K0 (all-entries? g:zero? G)) (raise-no-formula who M))
  (for/list ([mode (in-list (or (refined-modes who M0 K0) (raise-not-positive who M)))])
    (cons (simplify (g:* (car mode) (g:sqrt (g:/ kappa mu)))) (cdr mode))))

;; The first entry that is not zero, unless it is a number, and the quotients by it;
;; #f in their place if some are not numbers.
(define (numbers-with-factor rows)
  (define first-entry (for/first ([x (in-list (leaves rows))] #:unless (g:zero? x)) x))
  (define factor (if (or (not first-entry) (number? first-entry)) 1 first-entry))
  (define quotients (rows-map (lambda (x) (simplify (g:/ x factor))) rows))
  (values factor (and (all-entries? real? quotients) quotients)))

(define (raise-no-formula who M)
  (complain who
            (string-append "~a coordinates act on one another, and formulas are for 1 and 2"
                           "\n  give the parameters numbers for numbers in return")
            (vector-length M)))

(define (raise-not-positive who M)
  (complain who
            (string-append "the kinetic energy is not positive for all "
                           "velocities at this equilibrium"
                           "\n  mass matrix: ~a")
            (value->text (cons 'matrix-by-rows (map vector->list (vector->list M))))))
