#lang racket/base
;; Points of the plane, as maps and pictures take them, and when two are near each other
;; (SICM 4.3, pp. 308 and 309).

(require "../../error/complain.rkt"
         "../../generic/arithmetic.rkt" "../../generic/compare.rkt" "../../generic/describe.rkt"
         "../../generic/up-down.rkt" "../../generic/wrong-argument.rkt"
         "../../numeric/constants.rkt" "../../numeric/finite-number.rkt"
         "../../value/principal-value.rkt")

(provide make-point abscissa ordinate plane-near? cylinder-near? torus-near?
         ;; for what orbits are followed from
         start-abscissa start-ordinate)

(define (make-point x y) (up x y))

(define (abscissa p) (component-of 'abscissa p 0 car))
(define (ordinate p) (component-of 'ordinate p 1 cdr))

;; As flonums.
(define (start-abscissa who p) (start-number who p (component-of who p 0 car)))
(define (start-ordinate who p) (start-number who p (component-of who p 1 cdr)))

(define (start-number who p x)
  (define value (comparand x))
  (unless (finite? value)
    (complain who "expected a point of real numbers, such as (up 0.1 0.2)\n  given: ~a"
              (describe-with-value p)))
  (real->double-flonum value))

;; Of a tuple of two, or of what cons made, as pictures take it.
(define (component-of who p k of-pair)
  (cond [(and (tuple? p) (= (structure-length (adopt p)) 2)) (vector-ref (tuple-elements p) k)]
        [(and (pair? p) (not (list? p))) (of-pair p)]
        [else
         (complain who "expected a point of the plane, such as (make-point x y)\n  given: ~a"
                   (describe-with-value p))]))

;; ---------------------------------------------------------------------------
;; Nearness, for plot-parametric-fill: are two points closer than eps ...

;; ... in the plane,
(define (plane-near? eps) (nearness 'plane-near? eps values values))

;; ... where the abscissa is an angle,
(define (cylinder-near? eps) (nearness 'cylinder-near? eps half-turn values))

;; ... or both coordinates are?
(define (torus-near? eps) (nearness 'torus-near? eps half-turn half-turn))

(define half-turn (principal-value :pi))

;; across, up : what a difference of abscissas, and one of ordinates, amounts to
(define (nearness who eps across up)
  (define distance (comparand eps))
  (unless (and (finite? distance) (positive? distance))
    (complain-of-argument who "a distance, a positive number" eps))
  (define greatest (* distance distance))
  (procedure-rename
   (lambda (p q)
     (define x (across (g:- (abscissa p) (abscissa q))))
     (define y (up (g:- (ordinate p) (ordinate q))))
     (< (comparand (g:+ (g:* x x) (g:* y y))) greatest))
   who))
