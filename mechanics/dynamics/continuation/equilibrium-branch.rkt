#lang racket/base
;; Equilibria of a family of systems: where all rates vanish, as a parameter changes.

(require racket/flonum
         (only-in racket/list last range)
         "branch-start.rkt" "branch.rkt" "curve-step.rkt" "Hopf-orbit.rkt"
         "../map/map-on-tuples.rkt" "../map/period-check.rkt"
         "../../calculus/derivative.rkt"
         "../../error/failure.rkt"
         "../../generic/define-plain.rkt" "../../generic/up-down.rkt"
         "../../numeric/linear-algebra/general-eigenvalues.rkt"
         "../../numeric/linear-algebra/row-matrix.rkt"
         "../../value/shape.rkt")

(provide continue-equilibrium)

;; family : parameter -> state derivative; state : near an equilibrium where the parameter is `from`
(define-plain (continue-equilibrium family state from to
                                    #:step [step 0.05] #:longest-step [longest 0.5]
                                    #:most-steps [most 500])
  (define who 'continue-equilibrium)
  (define l (make-limits who from to step longest most))
  (check-family who family state from)
  (define timed? (timed-state? (family from) state))
  (define (rates v)
    (define all (scalars ((family (last (scalars v))) (with-unknowns state timed? v))))
    (apply up (if timed? (cdr all) all)))
  (define given (scalars state))
  (define x0
    (numbers-of (apply up (append (if timed? (cdr given) given) (list (limits-from l))))))
  (define e (rest-equations rates x0 l))
  (define (not-found) (raise-no-equilibrium who state from (rates (up-of-numbers x0))))
  (branch-from (family-of e family state timed?) l (first-point who e l x0 not-found)))

(define (family-of e systems state timed?)
  (define (at x) (with-unknowns state timed? (up-of-numbers x)))
  (family e "equilibria" #f at
          (lambda (p l) (onset-of-orbits e systems (at (point-x p)) p l))
          systems))

(define (rest-equations rates x0 l)
  (define n (- (flvector-length x0) 1))
  (define scales
    (for/flvector #:length (+ n 1) ([x (in-flvector x0)] [k (in-naturals)])
      (if (= k n) (parameter-scale l) (fl+ 1.0 (flabs x)))))
  (equations
   (lambda (x reference)
     (define at (up-of-numbers x))
     (define J (derivative-rows rates at n))
     (evaluated (numbers-of (rates at)) J (lambda () (eigenvalues-of J n))))
   scales #f #f))

;; -> rows of the derivatives by all unknowns
(define (derivative-rows rates at n)
  (define columns (numbers-of (derivative-at rates at)))
  (for/vector #:length n ([i (in-range n)])
    (for/vector #:length (+ n 1) ([j (in-range (+ n 1))]) (flvector-ref columns (+ i (* j n))))))

(define (eigenvalues-of J n)
  (or (real-matrix-eigenvalues (rows->flvector (submatrix J (range n) (range n))) n) '()))

(define (raise-no-equilibrium who state from rates)
  (raise-not-convergent who "no equilibrium was found near the state" state #f #:show? #f
                        "parameter" from "state" state "rates there" rates))
