#lang racket/base
;; Points of the plane, as maps and pictures take them, and when two are near each other
;; (SICM 4.3, pp. 308 and 309).

(require racket/flonum
         "../../error/complain.rkt"
         "../../generic/arithmetic.rkt" "../../generic/compare.rkt" "../../generic/describe.rkt"
         "../../generic/number-argument.rkt" "../../generic/plane-coordinates.rkt"
         "../../generic/up-down.rkt" "../../generic/wrong-argument.rkt"
         "../../numeric/constants.rkt" "../../numeric/finite-number.rkt"
         "../../value/principal-value.rkt")

(provide make-point abscissa ordinate plane-near? cylinder-near? torus-near?
         ;; for maps and their pictures
         start-coordinates start-point nearness-by-angles check-grid part-middle)

(define (make-point x y) (up x y))

(define (abscissa p)
  (define-values (x y) (coordinates-of 'abscissa p))
  x)

(define (ordinate p)
  (define-values (x y) (coordinates-of 'ordinate p))
  y)

;; -> both coordinates of the start of an orbit, as flonums
(define (start-coordinates who p)
  (define-values (x y) (coordinates-of who p))
  (values (start-number who p x) (start-number who p y)))

(define (start-point who p) (call-with-values (lambda () (start-coordinates who p)) flvector))

(define (start-number who p x)
  (define value (comparand x))
  (unless (finite? value)
    (complain-of-argument who "a point of real numbers, such as (up 0.1 0.2)" p))
  (real->double-flonum value))

;; ---------------------------------------------------------------------------
;; Grids of starts

(define (check-grid who grid)
  (unless (and (list? grid) (= (length grid) 2) (andmap exact-positive-integer? grid))
    (complain who "#:grid is a list of two numbers of starts, across and up; given ~a"
              (describe-with-value grid))))

;; The middle of part k of n equal parts of an interval.
(define (part-middle low high k n) (+ low (* (- high low) (/ (+ k 0.5) n))))

;; ---------------------------------------------------------------------------

(define (coordinates-of who p)
  (plane-coordinates
   p (lambda () (complain-of-argument who "a point of the plane, such as (make-point x y)" p))))

;; ---------------------------------------------------------------------------
;; Nearness, for plot-parametric-fill: are two points closer than eps ...

;; ... in the plane,
(define (plane-near? eps) (nearness 'plane-near? eps values values))

;; ... where the abscissa is an angle,
(define (cylinder-near? eps) (nearness 'cylinder-near? eps half-turn values))

;; ... or both coordinates are?
(define (torus-near? eps) (nearness 'torus-near? eps half-turn half-turn))

(define half-turn (principal-value :pi))

;; angles : list of two booleans: is that coordinate an angle?
(define (nearness-by-angles angles eps)
  (define (part angle?) (if angle? half-turn values))
  (nearness 'near? eps (part (car angles)) (part (cadr angles))))

;; across, up : map a difference of abscissas, or of ordinates, to a distance
(define (nearness who eps across up)
  (define distance (positive-number who eps "a distance, a positive number"))
  (define greatest (* distance distance))
  (procedure-rename
   (lambda (p q)
     (define x (across (g:- (abscissa p) (abscissa q))))
     (define y (up (g:- (ordinate p) (ordinate q))))
     (< (comparand (g:+ (g:* x x) (g:* y y))) greatest))
   who))
