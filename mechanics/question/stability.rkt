#lang racket/base
;; Is an equilibrium stable?
;;
;; With the matrices of small oscillations M ẍ + G ẋ + K x = 0 and a kinetic energy that
;; is positive, M > 0:
;;
;;   K > 0            stable: the energy is least there, and motions nearby are enclosed
;;                    (Lagrange, Dirichlet), turning frames or not;
;;   K has a negative direction and G = 0
;;                    unstable: some ω² is negative;
;;   otherwise        G may hold a motion that K does not.  Two coordinates, with
;;                    |M| ω⁴ − b ω² + |K| = 0, oscillate if b, |K| and b² − 4 |M| |K| are
;;                    positive, and leave exponentially if one of these is negative.
;;
;; K is positive if its leading minors are; if one of them is negative it is not.  Of decimals a
;; minor within roundings of 0 tells nothing (decimals-as-symbols.rkt).

(require racket/list
         "decimals-as-symbols.rkt" "equilibria.rkt" "equilibrium.rkt" "normal-modes.rkt"
         "argument-order.rkt" "small-oscillations.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/compare.rkt" "../generic/describe.rkt"
         "../generic/no-truth-value.rkt" "../generic/value-struct.rkt"
         "../generic/wrong-argument.rkt"
         "../hamiltonian/as-Lagrangian.rkt"
         "../lagrangian/Lagrange-equations.rkt"
         "../value/assumptions.rkt" "../value/simplify.rkt"
         "../numeric/linear-algebra/row-matrix.rkt"
         "../value/matrix/row-systems.rkt"
         "../verdict/report.rkt" "../verdict/verdict.rkt")

(provide equilibrium-stability stability?)

;; kind : 'stable 'linearly-stable 'unstable 'undecided
;; conditions : inequalities (> e 0) for it to be stable, unstable if e < 0 in one
(value-struct stability (kind conditions)
  #:text (lambda (s) (report->text (stability-lines s)))
  #:notation (lambda (s see) (report-notation (stability-lines s)))
  #:property prop:no-truth-value
  "how stable it is, is neither true nor false; ask (eq? (stability-kind s) 'stable)")

(provide-parts stability? "what (equilibrium-stability L q) gives"
  stability-kind stability-conditions)

;; q : coordinates of an equilibrium of an L that does not change in time
(define (equilibrium-stability given q)
  (check-order-of-arguments 'equilibrium-stability '(L q) (list given q))
  (check-coordinates 'equilibrium-stability q)
  (define-values (L _none) (as-Lagrangian 'equilibrium-stability given q))
  (check-equilibrium L q)
  (define number (scalar-valued 'equilibrium-stability L))
  (check-autonomous 'equilibrium-stability number q)
  (define-values (named q* decimals) (with-decimals-named number q))
  (define-values (M K G) (forms named q*))
  (define (sign e) (sign-or-rest e (assumptions-in-force) decimals))
  (when (ormap (lambda (minor) (memv (sign minor) '(-1 0))) (leading-minors M))
    (raise-singular-inertia number q))
  (define at-rest (judged 'stable (leading-minors K) sign))
  (if (and (not (all-entries? g:zero? G))
           (not (and (eq? (stability-kind at-rest) 'stable)
                     (null? (stability-conditions at-rest)))))
      (turning-stability L q M K G sign)
      at-rest))

(define (check-equilibrium L q)
  (define v (verify-equilibrium L q))
  (when (and (refuted? v) (> (magnitude (verdict-value v)) 1e-8))
    (complain 'equilibrium-stability
              "these coordinates are not an equilibrium\n  coordinates: ~a\n  residual: ~a"
              (value->text q) (value->text (verdict-residual v)))))

;; M > 0, unless its parameters leave that open.
(define (raise-singular-inertia L q)
  (define-values (M _K _G) (forms L q))
  (raise-not-positive 'equilibrium-stability M))

;; M, K, G : vectors of rows
(define (leading-minors K)
  (for/list ([n (in-range 1 (add1 (vector-length K)))])
    (simplify (rows-determinant (submatrix K (range n) (range n))))))

;; ---------------------------------------------------------------------------
;; Where velocities act

(define (turning-stability L q M K G sign)
  (cond [(= (vector-length M) 2) (judged 'linearly-stable (oscillation-conditions M K G) sign)]
        [else (by-frequencies (map constant-value (small-oscillation-frequencies L q)))]))

;; |K|, b and b² − 4 |M| |K|
(define (oscillation-conditions M K G)
  (define-values (a b c) (frequency-equation M K G))
  (map simplify (list c b (g:- (g:square b) (g:* 4 a c)))))

;; Of numbers: oscillations of different frequencies, or some that grow.
(define (by-frequencies omegas)
  (define scale (apply max (map magnitude omegas)))
  (define (negligible? x) (<= (abs x) (* 1e-7 scale)))
  (define sorted (sort (map real-part omegas) <))
  (define apart?
    (for/and ([a (in-list sorted)] [b (in-list (cdr sorted))]) (not (negligible? (- b a)))))
  (cond [(ormap (lambda (w) (not (negligible? (imag-part w)))) omegas) (stability 'unstable '())]
        [(and apart? (not (ormap negligible? sorted))) (stability 'linearly-stable '())]
        [else (stability 'undecided '())]))

;; ---------------------------------------------------------------------------
;; Signs

;; The verdict if all of these must be positive, and none may be negative.
(define (judged kind quantities sign)
  (define signs (map sign quantities))
  (cond [(memv -1 signs) (stability 'unstable '())]
        [(memv 0 signs) (stability 'undecided '())]
        [else
         (stability kind (for/list ([s (in-list (remove-duplicates signs))] #:unless (eqv? s 1))
                           (list '> s 0)))]))

;; ---------------------------------------------------------------------------

(define (stability-headline s)
  (case (stability-kind s)
    [(stable) "stable"]
    [(linearly-stable) "linearly stable"]
    [(unstable) "unstable"]
    [else "undecided: second derivatives do not tell"]))

;; As those of a verdict (verdict/report.rkt)
(define (stability-lines s)
  (define conditions (map value->datum (stability-conditions s)))
  (define headline (stability-headline s))
  (define (line depth label . content) (list depth label (and (pair? content) content)))
  (cond [(null? conditions) (list (line 0 headline))]
        [(null? (cdr conditions))
         (list (line 0 (string-append headline " if") (car conditions) ","
                     "unstable if that is reversed"))]
        [else
         (cons (line 0 (string-append headline
                                      " if all of these hold, unstable if one is reversed"))
               (for/list ([c (in-list conditions)]) (line 1 "" c)))]))
