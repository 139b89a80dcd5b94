#lang racket/base
;; Drawing: points, lines and curves, and values that cannot be drawn.

(require (prefix-in m: mechanics)
         mechanics/plot
         "../../support/checks.rkt" "../../support/messages.rkt")

(define (unit) (frame 0 1 0 1))

;; The curves that `draw` leaves in a frame.
(define (curves-of draw)
  (define f (unit))
  (draw f)
  (frame-curves f))

(define (xs curve) (map (lambda (p) (vector-ref p 0)) curve))
(define (ys curve) (map (lambda (p) (vector-ref p 1)) curve))

(test-case "a function is sampled from end to end in the steps that are asked for"
  (define c (curves-of (lambda (f) (plot-function f (lambda (x) (* x x)) 0 1 0.25))))
  (check-equal? c '((#(0.0 0.0) #(0.25 0.0625) #(0.5 0.25) #(0.75 0.5625) #(1.0 1.0))))
  (check-equal? (map xs (curves-of (lambda (f) (plot-function f sin 0 1 0.3))))
                '((0.0 0.3 0.6 0.8999999999999999 1.0)))
  (check-equal? (map xs (curves-of (lambda (f) (plot-function f sin 1 0 1/2)))) '((1.0 0.5 0.0)))
  (check-equal? (length (car (curves-of (lambda (f) (plot-function f sin 0 1))))) 501)
  ;; the book's step: rounding adds no point
  (check-equal? (length (car (curves-of (lambda (f)
                                          (plot-function f cos 0. m::pi/2 (/ m::pi/2 100))))))
                101))

(test-case "a curve is interrupted where the function has no real value"
  (define pole (curves-of (lambda (f) (plot-function f (lambda (x) (/ 1 (- x 0.5))) 0 1 0.25))))
  (check-equal? (map xs pole) '((0.0 0.25) (0.75 1.0)))
  (define root (curves-of (lambda (f) (plot-function f (lambda (x) (sqrt (- x 0.5))) 0 1 0.25))))
  (check-equal? (map xs root) '((0.5 0.75 1.0)))
  (check-equal? (curves-of (lambda (f) (plot-function f (lambda (x) +nan.0) 0 1))) '()))

(test-case "paths of the library are functions, and so are tuples of them by component"
  (define path (m:make-path 0. 1. 1. 0. '(0.6)))
  (define c (curves-of (lambda (f) (plot-function f path 0 1 0.5))))
  (check-equal? (map (lambda (p) (vector-ref p 0)) (car c)) '(0.0 0.5 1.0))
  (check-= (vector-ref (cadr (car c)) 1) 0.6 1e-12))

(test-case "parametric curves, of tuples, vectors and pairs"
  (define expected '((#(0.0 1.0) #(0.5 0.5) #(1.0 0.0))))
  (for ([point (list m:up m:down vector cons)])
    (define (curve t) (point t (- 1 t)))
    (check-equal? (curves-of (lambda (f) (plot-parametric f curve 0 1 0.5))) expected)))

(test-case "lines"
  (check-equal? (curves-of (lambda (f) (plot-line f 0 0 1 1/2) (plot-line f 0 2 2 0)))
                '((#(0.0 0.0) #(1.0 0.5)) (#(0.0 2.0) #(2.0 0.0)))))

;; ---------------------------------------------------------------------------

(define (filled curve . near)
  (define f (frame -2 2 -2 2))
  (apply plot-parametric-fill f curve 0 1 near)
  (frame-points f))

(define (distance p q)
  (sqrt (+ (expt (- (vector-ref p 0) (vector-ref q 0)) 2)
           (expt (- (vector-ref p 1) (vector-ref q 1)) 2))))

(define (circle t) (cons (cos (* 6 t)) (sin (* 6 t))))

;; Of points in no order: the greatest distance from one to its nearest neighbour on
;; the next angle.
(define (greatest-gap points)
  (define angles (sort (map (lambda (p) (atan (vector-ref p 1) (vector-ref p 0))) points) <))
  (for/fold ([gap 0]) ([a (in-list angles)] [b (in-list (cdr angles))])
    (max gap (- b a))))

(test-case "a curve is filled until its points are near"
  (for ([eps (in-list '(0.5 0.1 0.02))])
    (define points
      (filled circle
              (lambda (p q) (< (distance (vector (car p) (cdr p)) (vector (car q) (cdr q))) eps))))
    ;; the curve ends 0.283 before it closes
    (check-true (< (greatest-gap (filter (lambda (p) (> (vector-ref p 0) -0.9)) points))
                   (max 0.3 (* 1.1 eps)))))
  (check-true (> (length (filled circle)) 400)))

(test-case "a curve that jumps is filled up to the jump, and no further"
  (define points (filled (lambda (t) (cons t (if (< t 1/3) 0 1)))))
  (check-true (< (length points) 2000))
  (check-not-false (member #(1.0 1.0) points)))

(test-case "a constant curve is three points"
  (check-equal? (filled (lambda (t) (cons 1 1))) '(#(1.0 1.0) #(1.0 1.0) #(1.0 1.0))))

;; ---------------------------------------------------------------------------

(define ((harmonic k m) s)
  (m:up 1 (m:velocity s) (m:- (m:* (/ k m) (m:coordinate s)))))

(test-case "trajectories: against the time, and in phase space"
  (define tr (m:evolve-trajectory (harmonic 1 1) (m:up 0 1 0) 6 #:tolerance 1e-12))
  (define f (frame 0 6 -1 1))
  (plot-trajectory f tr m:coordinate)
  (plot-trajectory f tr m:coordinate m:velocity #:color 'red)
  (define orbit (car (frame-curves f)))
  (define swing (cadr (frame-curves f)))
  (define-values (against-time in-phase-space)
    (if (= (vector-ref (car orbit) 0) 0.0) (values orbit swing) (values swing orbit)))
  (for ([p (in-list against-time)])
    (check-= (vector-ref p 1) (cos (vector-ref p 0)) 1e-10))
  (for ([p (in-list in-phase-space)])
    (check-= (distance p #(0 0)) 1 1e-10))
  (check-equal? (list (vector-ref (car against-time) 0) (vector-ref (car (reverse against-time)) 0))
                '(0.0 6.0)))

(test-case "a trajectory without a clock is drawn against the time all the same"
  (define tr (m:evolve-trajectory (lambda (s) (m:up (m:ref s 1) (m:- (m:ref s 0)))) (m:up 1 0) 2))
  (define f (frame 0 6 -1 1))
  (plot-trajectory f tr (m:component 0))
  (for ([p (in-list (car (frame-curves f)))])
    (check-= (vector-ref p 1) (cos (vector-ref p 0)) 1e-8)))

(test-case "a monitor that draws sees each state, and drawing is quick"
  (define f (frame 0 100 -2 2))
  ((m:evolve (lambda () (harmonic 1 1))) (m:up 0. 1. 0.)
   (lambda (s) (plot-point f (m:time s) (m:coordinate s))) 0.01 100. 1e-10)
  (check-equal? (length (frame-points f)) 10001))

(test-case "the observer of find-path draws the paths it tries, the last one best"
  (define f (frame 0 m::pi/2 0 1.2))
  (define (L s)
    (m:- (m:* 1/2 (m:square (m:velocity s))) (m:* 1/2 (m:square (m:coordinate s)))))
  (m:find-path L 0. 1. m::pi/2 0. 3
               #:observe (lambda (path action) (plot-function f path 0 m::pi/2 (/ m::pi/2 20))))
  (define (worst curve)
    (apply max (for/list ([p (in-list curve)])
                 (abs (- (vector-ref p 1) (cos (vector-ref p 0)))))))
  (define errors (map worst (frame-curves f)))
  (check-true (> (length errors) 1))
  (check-true (< (apply min errors) 2e-4)))

;; ---------------------------------------------------------------------------

(define f (unit))

;; Symbols that have no number are named.
(says
 [(plot-point f 'x 0)
  "plot-point: x is no number\n"
  "  given: the symbol x\n"
  "  without a number: x\n"
  "  give its symbols values first"]
 [(plot-function f (lambda (t) (m:* 'm 'k)) 0 1)
  "plot-function: the value at 0.0 is no number\n"
  "  given: (* m k), a number-like expression\n"
  "  without a number: k, m\n"
  "  give its symbols values first"]
 [(plot-function f (m:literal-function 'f) 0 1)
  "plot-function: the value at 0.0 is no number\n"
  "  given: (f 0.0), a number-like expression"]
 [(plot-function f sin 0 'T)
  "plot-function: the end is no number\n"
  "  given: the symbol T\n"
  "  without a number: T\n"
  "  give its symbols values first"]
 [(plot-line f 0 0 1 "a")
  "plot-line: y2 is no number\n"
  "  given: \"a\", a string"]
 [(plot-parametric f (lambda (t) (m:up t 'y)) 0 1)
  "plot-parametric: the value at 0.0, its second component, is no number\n"
  "  given: the symbol y\n"
  "  without a number: y\n"
  "  give its symbols values first"]
 [(plot-contours f (lambda (x y) 'V) 0)
  "plot-contours: the value at 0.0, 0.0 is no number\n"
  "  given: the symbol V\n"
  "  without a number: V\n"
  "  give its symbols values first"])

;; A path of several coordinates is drawn by component, or as a curve in the plane.
(says
 [(plot-function f (lambda (t) (m:up t 1)) 0 1)
  "plot-function: the value at 0.0 is no number\n"
  "  given: (up 0.0 1), an up tuple of 2\n"
  "  draw its components one by one, as with (component 0)"]
 [(plot-parametric f sin 0 1)
  "plot-parametric: the value at 0.0 is no point of the plane, such as (up x y) or (cons x y)\n"
  "  given: the number 0.0"]
 [(plot-parametric f (lambda (t) (m:up t t t)) 0 1)
  "plot-parametric: the value at 0.0 is no point of the plane, such as (up x y) or (cons x y)\n"
  "  given: (up 0.0 0.0 0.0), an up tuple of 3"])

;; A step too short was an endless computation, and then no memory.
(says
 [(plot-function f sin 0 1 1e-9)
  "plot-function: the step is too short for so long a curve\n"
  "  step: 1e-9\n  from: 0.0\n  to: 1.0\n  steps: 1000000000.0\n  at most: 10000000"]
 [(plot-parametric f (lambda (t) (m:up t t)) 1e300 0 1)
  "plot-parametric: the step is too short for so long a curve\n"
  "  step: 1.0\n  from: 1e+300\n  to: 0.0\n  steps: 1e+300\n  at most: 10000000"]
 [(plot-function f sin -1e300 1e300 1e-300)
  "plot-function: the step is too short for so long a curve\n"
  "  step: 1e-300\n  from: -1e+300\n  to: 1e+300\n  steps: +inf.0\n  at most: 10000000"])

;; Arguments of another kind.
(define-syntax-rule (expects [expression who expected given] ...)
  (says [expression who ": expected " expected "\n  given: " given] ...))

(expects
 [(plot-point 0 1 2) "plot-point" "a frame, such as (frame 0 1 -1 1)" "the number 0"]
 [(plot-function f 3 0 1) "plot-function" "a function of one number" "the number 3"]
 [(plot-function f cons 0 1) "plot-function" "a function of one number"
  "the procedure `cons`, which takes 2 arguments"]
 [(plot-contours f sin 0) "plot-contours" "a function of two numbers"
  "the procedure `sin`, which takes 1 argument"]
 [(plot-function f sin 0 1 0) "plot-function" "a positive step" "the number 0.0"]
 [(plot-function f sin 0 +inf.0) "plot-function" "a finite number as the end" "the number +inf.0"]
 [(plot-contours f * +nan.0) "plot-contours" "a finite number as a level" "the number +nan.0"]
 [(plot-contours f * 0 #:samples 1) "plot-contours" "a number of samples from 2 to 2000"
  "the number 1"]
 [(plot-trajectory f sin cos) "plot-trajectory" "a trajectory, such as evolve-trajectory gives"
  "the procedure `sin`"]
 [(plot-trajectory f (m:evolve-trajectory (harmonic 1 1) (m:up 0 1 0) 1) 0) "plot-trajectory"
  "a function of the state, such as coordinate" "the number 0"]
 [(plot-point f 0 0 #:size -1) "plot-point" "a size in pixels, from 0 to 1000" "the number -1"]
 [(plot-line f 0 0 1 1 #:style 'wavy) "plot-line"
  "a line style, one of (solid dot long-dash short-dash dot-dash)" "the symbol wavy"]
 [(plot-point f 0 0 #:label 3) "plot-point"
  "a string or a formula, such as 'theta, as label, or #f" "the number 3"]
 [(plot-point f 0 0 #:color -1000) "plot-point"
  "a color: a name such as 'red, a small integer, or a list of three bytes" "the number -1000"]
 [(plot-point f 0 0 #:color '(1 2)) "plot-point"
  "a color: a name such as 'red, a small integer, or a list of three bytes" "(1 2), a list"])

(test-case "what failed has drawn nothing"
  (check-equal? (append (frame-points f) (frame-curves f)) '()))

(test-case "an error of the function's own is what the reader sees"
  (define (own . arguments) (raise-user-error 'own "no luck with ~a" arguments))
  (define (check-own draw)
    (define f (unit))
    (check-exn (lambda (e) (regexp-match? #rx"^own: no luck with " (exn-message e)))
               (lambda () (draw f)))
    (check-equal? (frame-curves f) '()))
  (check-own (lambda (f) (plot-function f own 0 1)))
  (check-own (lambda (f) (plot-parametric f own 0 1)))
  (check-own (lambda (f) (plot-parametric-fill f own 0 1)))
  (check-own (lambda (f) (plot-contours f own '(0)))))
