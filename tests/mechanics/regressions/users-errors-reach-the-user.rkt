#lang racket/base
;; Errors of functions that the user gives were caught on the way: a root was sought by
;; differences instead of derivatives, a motion went on where its force had failed, a map
;; was done by a program that knew of no failure.

(require racket/flonum
         (prefix-in racket: racket/base)
         mechanics
         mechanics/scmutils
         "../support/checks.rkt")

;; ---------------------------------------------------------------------------
;; Ways to fail

(struct way (name fail own?))

(define (says text) (lambda (x) (and (exn:fail? x) (equal? (exn-message x) text))))

(define by-error
  (way "error" (lambda () (error 'my-force "spring broke")) (says "my-force: spring broke")))
(define by-raise
  (way "raise" (lambda () (raise 'my-thing)) (lambda (x) (eq? x 'my-thing))))
(define by-slip
  (way "a slip"
       (lambda () (racket:car '()))
       (says "car: contract violation\n  expected: pair?\n  given: '()")))

(define ways (list by-error by-raise by-slip))

(define (raised-by thunk)
  (with-handlers ([(lambda (x) (not (exn:break? x))) values])
    (thunk)
    'nothing))

;; Each question calls `fail`, and so ends as the user's function does, each way.
(define-syntax-rule (reported who (fail from) question ...)
  (for ([w (in-list from)])
    (test-case (format "~a: ~a" who (way-name w))
      (let ([fail (way-fail w)])
        (check-pred (way-own? w) (raised-by (lambda () question)) (format "~s" 'question)) ...))))

;; ---------------------------------------------------------------------------
;; Functions of numbers

(reported "a function of a number that always fails" (fail ways)
  (find-root (lambda (x) (fail)) 1.0)
  (find-root (lambda (x) (fail)) 0.0 2.0)
  (newton-search (lambda (x) (fail)) 1.0)
  (bisect (lambda (x) (fail)) 0.0 2.0)
  (zbrent (lambda (x) (fail)) 0.0 2.0)
  (minimize (lambda (x) (fail)) 0.0 2.0)
  (golden-section-min (lambda (x) (fail)) 0.0 2.0)
  (multidimensional-minimize (lambda (x) (fail)) (up 0.0 2.0))
  (nelder-mead (lambda (x) (fail)) (up 0.0 2.0))
  ((D-numeric (lambda (x) (fail))) 1.0)
  (definite-integral (lambda (x) (fail)) 0 1)
  ((compile-function (lambda (x) (fail)) 1.0) (flvector 1.0)))

;; Racket's own tests take a placeholder, or a dual number, for what it is.
(define ((failing-at bad? fail) x)
  (when (bad? x) (fail))
  (- (* x x) 2))

(reported "one that fails at some numbers" (fail ways)
  (find-root (failing-at (lambda (x) (and (flonum? x) (< x 1.45))) fail) 3.0)
  (minimize (failing-at (lambda (x) (and (flonum? x) (< x 0.1))) fail) -1.0 2.0)
  (definite-integral (failing-at (lambda (x) (and (flonum? x) (< x 0.1))) fail) 0 1)
  ((compile-function (failing-at flonum? fail) 1.0) (flvector 1.0)))

;; A slip there may be the refusal of a dual number.
(define (no-number? x) (not (racket:number? x)))
(reported "one that fails where it is differentiated" (fail (list by-error by-raise))
  (find-root (failing-at no-number? fail) 1.0)
  (newton-search (failing-at no-number? fail) 1.0)
  (multidimensional-minimize
   (lambda (p) ((failing-at no-number? fail) (ref p 0)))
   (up 1.0 2.0)))

(test-case "a function that refuses dual numbers has its root found by differences"
  (define (f x) (racket:- (racket:* x x) 2))
  (check-= (find-root f 1.0) (sqrt 2.0) 1e-9)
  (check-= (ref (multidimensional-minimize (lambda (p) (expt (f (ref p 0)) 2)) (up 1.0)) 0)
           (sqrt 2.0) 1e-4))

(test-case "what a function is tried at beside the point in question is no error"
  (define f (compile-function (lambda (x) (atan 1 (sqrt (- 1 (* x x))))) 0.99))
  (check-false (compiled-function-reason f))
  (check-= (flvector-ref (f (flvector 0.6)) 0) (atan 1 0.8) 1e-15))

(test-case "a search that the function itself makes may fail, too"
  (define (f x) (* x (definite-integral (lambda (y) (/ 1 y)) 0 1)))
  (check-pred exn:fail:mechanics:not-convergent? (raised-by (lambda () (f 1.0))))
  (check-pred exn:fail:mechanics:not-convergent? (raised-by (lambda () (zbrent f -1.0 2.0))))
  (define found (zbrent (lambda (x) (- (* x x x) 2)) 0.0 2.0 1e-15 3))
  (check-equal? (list (car found) (caddr found)) '(#f 3)))

;; ---------------------------------------------------------------------------
;; Maps

(reported "a map" (fail ways)
  ((iterated-map (lambda (x y return none) (fail)) 20000) 0.1 0.2 list void)
  ((iterated-map (lambda (x y return none) (fail)) 2) 0.1 0.2 list void)
  ((iterated-map (lambda (x y return none)
                   (when (> x 0.5) (fail))
                   (return (+ x 1e-4) y))
                 20000)
   0.1 0.2 list void)
  ((iterated-map (lambda (x y return none)
                   (when (and (flonum? x) (< x 0)) (fail))
                   (return (- x 1e-4) y))
                 20000)
   0.1 0.2 list void))

(test-case "a map without an image for some numbers is not compiled"
  (define (shift x y return none)
    (if (and (flonum? x) (< x 0)) (none) (return (- x 1e-4) y)))
  (check-equal? ((iterated-map shift 20000) 0.1 0.2 list (lambda () 'none)) 'none))

(test-case "a map with symbols is done by calls"
  (check-equal?
   ((iterated-map (lambda (x y return none) (return x 'k)) 10001) 0.5 1.5 list void)
   '(0.5 k)))

;; ---------------------------------------------------------------------------
;; Motions

(define ((falling-until bad? fail) s)
  (define x (ref s 1))
  (when (bad? x) (fail))
  (up 1 (ref s 2) -1))

(define start (up 0.0 1.0 0.0))
(define (always x) #t)
(define (below x) (and (not (racket:symbol? x)) (< x 0.5)))

(reported "a state derivative" (fail ways)
  ((state-advancer (falling-until always fail)) start 2.0)
  ((state-advancer (falling-until below fail)) start 2.0)
  ((evolve (falling-until below fail)) start void 0.5 2.0)
  (evolve-trajectory (falling-until below fail) start 2.0)
  (evolve-trajectory (falling-until below fail) start 2.0 #:method 'Radau-IIA-5)
  (evolve-trajectory (falling-until below fail) start 2.0 #:precision 100)
  ((state-advancer (lambda (g) (falling-until below fail)) 1.0) start 2.0))

(define falling (falling-until (lambda (x) #f) void))

(reported "what watches a motion" (fail ways)
  ((evolve falling) start (lambda (s) (fail)) 0.5 2.0)
  (evolve-trajectory falling start 2.0 #:events (event (lambda (s) (fail))))
  (evolve-trajectory
   falling start 2.0
   #:events (event (lambda (s) (when (below (ref s 1)) (fail)) (- (ref s 1) 10)))))

;; ---------------------------------------------------------------------------
;; Lagrangians

(define ((L-failing fail) local) (fail))
(define (L-free local) (* 1/2 (square (velocity local))))

(reported "a Lagrangian, a path or a force" (fail ways)
  (verify-solution (L-failing fail) (literal-function 'x))
  (verify-solution L-free (lambda (t) (fail)))
  (verify-solution L-free (literal-function 'x) #:force (lambda (local) (fail)))
  (find-path (L-failing fail) 0.0 1.0 1.0 2.0 2)
  ((state-advancer (Lagrangian->state-derivative (L-failing fail))) start 1.0)
  (find-equilibrium (L-failing fail) 1.0))
