#lang racket/base
;; Roots of functions made by the generic arithmetic: between two points where the
;; signs differ, or near a point, in any number of variables.
;;
;; Newton's method takes its derivatives from one run of the function on dual
;; numbers; those of a function that refuses them, one that integrates a motion, say,
;; from differences, f(x + h) − f(x − h) over 2h with h the cube root of the rounding
;; error, where the errors of the formula and of rounding balance.

(require racket/flonum
         racket/list
         "implicit-root.rkt"
         "../calculus/derivative.rkt"
         "../error/complain.rkt" "../error/refusal.rkt"
         "../generic/define-plain.rkt" "../generic/function.rkt" "../generic/number-argument.rkt"
         "../numeric/finite-number.rkt" "../numeric/flvector.rkt"
         (only-in "../numeric/linear-algebra/row-matrix.rkt" all-entries? rows-times)
         "../numeric/linear-algebra/singular-values.rkt"
         "../numeric/optimization/brent-root.rkt" "../numeric/optimization/newton.rkt"
         "../value/shape.rkt")

(provide find-root newton-search bisect zbrent)

;; report : receives the root, how far off it may be, and the evaluations of f
(define (the-root x error count) x)

;; (find-root f low high), or (find-root f start) for a start of any shape.
(define-plain (find-root f start [high #f]
                         #:tolerance [tolerance 1e-12]
                         #:observe [observe void] #:report [report the-root])
  (check-function-of-one-variable 'find-root f)
  (if high
      (root-between 'find-root bracketed-root f start high tolerance observe report)
      (root-near 'find-root f start tolerance observe report)))

;; Where f changes its sign, by halving the interval (SICM p. 321).
(define-plain (bisect f low high [eps 1e-15] #:tolerance [tolerance eps]
                      #:observe [observe void] #:report [report the-root])
  (check-function-of-one-variable 'bisect f)
  (root-between 'bisect bisected-root f low high tolerance observe report))

;; f may also give its value and its derivative to a procedure, (f x receive), as in scmutils;
;; the derivative is not asked for.
(define-plain (newton-search f start [tolerance 1e-12]
                             #:observe [observe void] #:report [report the-root])
  (define value (if (receives? f) (value-given f) f))
  (check-function-of-one-variable 'newton-search value)
  (root-near 'newton-search value start tolerance observe report))

(define (receives? f) (and (procedure? f) (accepts? f 2) (not (accepts? f 1))))
(define ((value-given f) x) (f x (lambda (y slope) y)))

;; (list found? root evaluations)
(define (zbrent f low high [tolerance 1e-15] [limit 100])
  (check-function-of-one-variable 'zbrent f)
  (let/ec return
    (define (give-up x error count) (return (list #f x limit)))
    (define (method f low high #:tolerance tolerance #:observe observe #:name who)
      (bracketed-root f low high
                      #:tolerance tolerance #:limit limit #:give-up give-up #:name who))
    (root-between 'zbrent method f low high tolerance void
                  (lambda (x error count) (list #t x count)))))

;; ---------------------------------------------------------------------------

(define (root-between who method f low high tolerance observe report)
  (define (end x) (number-beneath who x))
  (define (value x) (number-beneath who (f x)))
  (define-values (x error count)
    (method value (end low) (end high) #:tolerance tolerance #:observe observe #:name who))
  (define (values-at v) (flvector (value (flvector-ref v 0))))
  (define (slopes v) (jacobian-at f values-at (flvector-ref v 0) v))
  (report (varying who f x slopes (flvector x) values-at) error count))

(define (root-near who f start tolerance observe report)
  (define (check-number x) (number who x))
  (define from (plain start))
  (define x (structure->flvector from check-number))
  (define (argument x) (flvector->structure from x))
  (define evaluations 0)
  (define (value x)
    (set! evaluations (+ evaluations 1))
    (define y (structure->flvector (plain (f (argument x))) check-number))
    (check-count who from y)
    y)
  (define (jacobian x) (jacobian-at f value (argument x) x))
  (value x)                             ; a mistake of the function's own is seen here
  (define-values (root error)
    (newton value jacobian x
            #:tolerance tolerance #:observe observe #:argument argument #:name who))
  (report (varying who f (argument root) jacobian root value) error evaluations))

;; The root x, at the flvector v, as it varies with the values that f depends on
(define (varying who f x jacobian v value)
  (define (slopes)
    (define J (jacobian v))
    (unless (well-conditioned? jacobian J v (value v)) (raise-no-derivative who x))
    J)
  (varying-root who f x slopes))

(define (check-count who start y)
  (define n (shape-length start))
  (unless (= (flvector-length y) n)
    (complain-showing who "the function must give as many numbers as it takes"
                      "given" (flvector-length y) "expected" n "start" start)))

;; ---------------------------------------------------------------------------
;; Matrices of derivatives

;; The derivatives of f at an argument; x and value : the argument and f as an flvector and as a
;; function between flvectors.  If f refuses dual numbers, differences of values take their place;
;; if it refuses numbers as well, it refuses there.
(define (jacobian-at f value argument x)
  (with-handlers ([refusal? (lambda (e) (difference-rows value x 6e-6))])
    (define slopes (plain (derivative-at f argument)))
    (columns->rows (flvector-length x) (structure->flvector slopes raise-not-a-number))))

(define (raise-not-a-number x) (number 'derivative x))

;; ---------------------------------------------------------------------------
;; Has the matrix of derivatives at a root an inverse, as far as the root is known?
;;
;; At a double root, where x² = 0, Newton's method stops at some x = 10⁻¹², or rounding stops it
;; at 10⁻⁸ of where it should be: the slope 2x there is not zero, and its inverse says nothing.
;; So derivatives are looked at, too, where the root may as well be: in the direction v in which
;; they are least, as far as Newton's next steps reach, and rounding.  A slope along v that
;; loses half of itself on the way is no slope.

;; jacobian : flvector -> vector of rows, which are J at the root x; y : the values there
(define (well-conditioned? jacobian J x y)
  (and (all-entries? finite? J)
       (let-values ([(u least v) (least-singular J)])
         (define step (/ (- (dot y u)) least))
         (define rounding (* 1.5e-8 (greatest x)))
         (define (holds? s)
           (or (= s 0.0) (> (dot u (rows-times (jacobian (along x s v)) v)) (* 0.5 least))))
         (and (> least 0.0)
              (andmap holds? (list step (* 2.0 step) (* 3.0 step) rounding (- rounding)))))))

;; J v = least u
(define (least-singular J)
  (define-values (us sizes vs) (singular-values (columns-of J)))
  (values (last us) (last sizes) (last vs)))
