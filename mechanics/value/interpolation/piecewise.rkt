#lang racket/base
;; Functions of one variable through data, by pieces between neighbouring points.
;;
;; Each piece is the cubic with the values y₀, y₁ and slopes m₀, m₁ at its ends,
;; with s = (x − x₀)/h and δ = (y₁ − y₀)/h:
;;
;;     y₀ + h s (m₀ + s (3δ − 2m₀ − m₁ + s (m₀ + m₁ − 2δ))).
;;
;; The methods differ in their slopes.  Those of a spline are such
;; that the second derivative has no jumps (de Boor, A Practical Guide to Splines,
;; ch. IV): for neighbouring pieces,
;;
;;     h₁ m₀ + 2 (h₀ + h₁) m₁ + h₀ m₂ = 3 (h₁ δ₀ + h₀ δ₁),
;;
;; and two more equations, for the ends.  A monotone function has slopes that are
;; harmonic means of the δ beside them, or 0 where these are of different signs
;; (Fritsch and Butland 1984).

(require "interpolation-data.rkt" "tridiagonal-system.rkt"
         "../../error/complain.rkt"
         "../../generic/arithmetic.rkt" "../../generic/compare.rkt"
         "../../generic/define-plain.rkt" "../../generic/describe.rkt"
         "../../generic/elementary.rkt" "../../generic/function.rkt"
         "../../generic/wrong-argument.rkt"
         "../../numeric/record-fields.rkt")

(provide cubic-spline Hermite-spline monotone-spline linear-interpolation)

;; ---------------------------------------------------------------------------
;; The functions

(define-plain (linear-interpolation points values #:extrapolate? [extrapolate? #f])
  (define who 'linear-interpolation)
  (define-values (xs ys) (checked who points values))
  (define slopes (differences xs ys))
  (piecewise who xs extrapolate?
             (lambda (i x)
               (g:+ (vector-ref ys i)
                    (g:* (g:- x (vector-ref xs i)) (vector-ref slopes i))))))

(define-plain (Hermite-spline points values slopes #:extrapolate? [extrapolate? #f])
  (define who 'Hermite-spline)
  (define-values (xs ys) (checked who points values))
  (cubics who xs ys (values-at who "slopes" slopes xs) extrapolate?))

;; ends : 'not-a-knot, 'natural, 'periodic, or a list of the slopes at the two ends
(define-plain (cubic-spline points values #:ends [ends 'not-a-knot]
                            #:extrapolate? [extrapolate? #f])
  (define who 'cubic-spline)
  (define-values (xs ys) (checked who points values))
  (check-ends ends ys)
  (cubics who xs ys (spline-slopes xs ys ends) extrapolate?))

(define-plain (monotone-spline points values #:extrapolate? [extrapolate? #f])
  (define who 'monotone-spline)
  (define-values (xs ys) (checked who points values))
  (for ([y (in-vector ys)])
    (unless (real? (comparand y))
      (complain-of-argument who "values that are real numbers" y)))
  (cubics who xs ys (monotone-slopes xs ys) extrapolate?))

(define (checked who points-given values-given)
  (define xs (points who points-given))
  (check-increasing who xs)
  (values xs (values-at who "values" values-given xs)))

(define (check-ends ends ys)
  (unless (or (memq ends '(not-a-knot natural periodic)) (and (list? ends) (= (length ends) 2)))
    (complain-of-argument
     'cubic-spline "'not-a-knot, 'natural, 'periodic or a list of the slopes at the two ends" ends))
  (when (eq? ends 'periodic)
    (define first (vector-ref ys 0))
    (define last (vector-ref ys (- (vector-length ys) 1)))
    (unless (or (g:= first last) (rounding? (comparand first) (comparand last)))
      (complain 'cubic-spline "~a\n  first: ~a\n  last: ~a"
                "a periodic function has the same value at both ends"
                (value->text first) (value->text last)))))

;; Values of a periodic function computed at both ends need not be quite the same.
(define (rounding? a b)
  (and (real? a) (real? b) (<= (abs (- a b)) 1e-14)))

;; ---------------------------------------------------------------------------
;; Pieces

;; (at i x) is the value at x by piece i.
(define (piecewise who xs extrapolate? at)
  (define low (vector-ref xs 0))
  (define high (vector-ref xs (- (vector-length xs) 1)))
  (unary-function
   (lambda () `(,who from ,(value->datum low) to ,(value->datum high)))
   (x)
   (let ([place (location who x)])
     (unless (or extrapolate? (within? (comparand low) place (comparand high)))
       (raise-outside who x low high))
     (at (piece-of xs place) x))))

;; Is x inside, but for the rounding of an integrator at an end?
(define (within? low x high)
  (or (<= low x high)
      (let ([rounding (* 1e-12 (- high low))])
        (<= (- low rounding) x (+ high rounding)))))

(define (raise-outside who x low high)
  (complain who "there are no data for the argument\n  argument: ~a\n  from: ~a\n  to: ~a\n  ~a"
            (value->text x) (value->text low) (value->text high)
            "with #:extrapolate? #t the pieces at the ends are continued"))

;; Bisection: the piece that holds x, at a point the one that begins there.
(define (piece-of xs x)
  (let search ([low 0] [high (- (vector-length xs) 2)])
    (define middle (quotient (+ low high 1) 2))
    (cond [(= low high) low]
          [(g:<= (vector-ref xs middle) x) (search middle high)]
          [else (search low (- middle 1))])))

(define (cubics who xs ys slopes extrapolate?)
  (define deltas (differences xs ys))
  (piecewise who xs extrapolate?
             (lambda (i x)
               (define m0 (vector-ref slopes i))
               (define m1 (vector-ref slopes (+ i 1)))
               (define delta (vector-ref deltas i))
               (define u (g:- x (vector-ref xs i)))
               (define s (g:/ u (g:- (vector-ref xs (+ i 1)) (vector-ref xs i))))
               (define cubic (g:- (g:+ m0 m1) (g:* 2 delta)))
               (define square (g:- (g:* 3 delta) (g:+ (g:* 2 m0) m1)))
               (g:+ (vector-ref ys i)
                    (g:* u (g:+ m0 (g:* s (g:+ square (g:* s cubic)))))))))

;; δ of each piece.
(define (differences xs ys)
  (for/vector #:length (- (vector-length xs) 1)
              ([x (in-vector xs)] [next-x (in-vector xs 1)]
               [y (in-vector ys)] [next-y (in-vector ys 1)])
    (g:/ (g:- next-y y) (g:- next-x x))))

(define (lengths xs)
  (for/vector #:length (- (vector-length xs) 1) ([x (in-vector xs)] [next (in-vector xs 1)])
    (g:- next x)))

;; ---------------------------------------------------------------------------
;; Slopes of a spline

(define (spline-slopes xs ys ends)
  (define h (lengths xs))
  (define d (differences xs ys))
  (define rows (for/list ([i (in-range 1 (vector-length h))]) (inner-row h d i)))
  (cond [(eq? ends 'periodic) (periodic-slopes h d rows)]
        [(eq? ends 'natural)
         (solve-tridiagonal `(,(natural-row d 0 'first) ,@rows
                              ,(natural-row d (- (vector-length d) 1) 'last)))]
        [(pair? ends)
         (solve-tridiagonal `(,(equation 0 1 0 (car ends)) ,@rows ,(equation 0 1 0 (cadr ends))))]
        [(< (vector-length d) 3) (few-slopes h d)]
        [else
         (define n (vector-length d))
         (solve-tridiagonal
          `(,(not-a-knot-row h d 0 1) ,@rows
            ,(opposite (not-a-knot-row h d (- n 1) (- n 2)))))]))

;; At the point between pieces i - 1 and i.
(define (inner-row h d i)
  (define h0 (vector-ref h (- i 1)))
  (define h1 (vector-ref h i))
  (equation h1 (g:* 2 (g:+ h0 h1)) h0
       (g:* 3 (g:+ (g:* h1 (vector-ref d (- i 1))) (g:* h0 (vector-ref d i))))))

;; The second derivative vanishes.
(define (natural-row d i end)
  (define right (g:* 3 (vector-ref d i)))
  (if (eq? end 'first) (equation 0 2 1 right) (equation 1 2 0 right)))

;; The pieces i, at an end, and j are one cubic.
(define (not-a-knot-row h d i j)
  (define a (vector-ref h i))
  (define b (vector-ref h j))
  (define c (g:+ a b))
  (equation 0 b c
       (g:/ (g:+ (g:* (g:* (g:+ a (g:* 2 c)) b) (vector-ref d i))
                 (g:* (g:square a) (vector-ref d j)))
            c)))

;; Of one or two pieces: the slopes of a line or a parabola.
(define (few-slopes h d)
  (define d0 (vector-ref d 0))
  (cond [(= (vector-length d) 1) (vector d0 d0)]
        [else
         (define d1 (vector-ref d 1))
         (define bend (g:/ (g:- d1 d0) (g:+ (vector-ref h 0) (vector-ref h 1))))
         (vector (g:- d0 (g:* (vector-ref h 0) bend))
                 (g:+ d0 (g:* (vector-ref h 0) bend))
                 (g:+ d1 (g:* (vector-ref h 1) bend)))]))

;; The slope s at both ends is one unknown more: the others are p + s q, where the
;; equation of the point at which the ends meet gives s.
(define (periodic-slopes h d rows)
  (define n (vector-length d))
  (define (with-ends rows s) (solve-tridiagonal `(,(equation 0 1 0 s) ,@rows ,(equation 0 1 0 s))))
  (define p (with-ends rows 0))
  (define q (with-ends (map homogeneous rows) 1))
  (define (last-and-first v) (vector (vector-ref v (- n 1)) (vector-ref v 0)))
  (define closing-row (inner-row (last-and-first h) (last-and-first d) 1))
  (define-fields equation closing-row a b c right)
  (define (closing v) (g:+ (g:* a (vector-ref v (- n 1))) (g:* c (vector-ref v 1))))
  (define s
    (if (= n 1)
        0
        (g:/ (g:- right (closing p)) (g:+ b (closing q)))))
  (for/vector #:length (+ n 1) ([x (in-vector p)] [y (in-vector q)]) (g:+ x (g:* y s))))

;; ---------------------------------------------------------------------------
;; Monotone slopes

(define (monotone-slopes xs ys)
  (define h (lengths xs))
  (define d (differences xs ys))
  (define n (vector-length d))
  (for/vector #:length (+ n 1) ([i (in-range (+ n 1))])
    (cond [(= n 1) (vector-ref d 0)]
          [(= i 0) (end-slope h d 0 1)]
          [(= i n) (end-slope h d (- n 1) (- n 2))]
          [else (mean-slope (vector-ref h (- i 1)) (vector-ref h i)
                            (vector-ref d (- i 1)) (vector-ref d i))])))

(define (same-sign? a b) (g:positive? (g:* a b)))

(define (mean-slope h0 h1 d0 d1)
  (cond [(same-sign? d0 d1)
         (define w0 (g:+ h0 (g:* 2 h1)))
         (define w1 (g:+ (g:* 2 h0) h1))
         (g:/ (g:+ w0 w1) (g:+ (g:/ w1 d0) (g:/ w0 d1)))]
        [else 0]))

;; Of the parabola through three points, unless that would not be monotone.
(define (end-slope h d i j)
  (define hi (vector-ref h i))
  (define di (vector-ref d i))
  (define dj (vector-ref d j))
  (define m
    (g:/ (g:- (g:* (g:+ (g:* 2 hi) (vector-ref h j)) di) (g:* hi dj))
         (g:+ hi (vector-ref h j))))
  (cond [(not (same-sign? m di)) 0]
        [(and (not (same-sign? di dj)) (g:< (g:* 3 (g:abs di)) (g:abs m))) (g:* 3 di)]
        [else m]))
