#lang racket/base
;; Equilibria of a family of systems: where all rates vanish, as a parameter changes.

(require racket/flonum
         (only-in racket/list last range)
         "branch.rkt" "curve-step.rkt"
         "../map/map-on-tuples.rkt" "../map/period-check.rkt"
         "../../calculus/derivative.rkt"
         "../../error/complain.rkt" "../../error/failure.rkt"
         "../../generic/compare.rkt" "../../generic/define-plain.rkt" "../../generic/describe.rkt"
         "../../generic/function.rkt" "../../generic/up-down.rkt" "../../generic/wrong-argument.rkt"
         "../../motion/system/check.rkt"
         "../../numeric/linear-algebra/general-eigenvalues.rkt"
         "../../numeric/linear-algebra/row-matrix.rkt"
         "../../value/shape.rkt")

(provide continue-equilibrium
         ;; for other branches
         check-family parameter-scale numbers-of with-unknowns first-point)

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
  (branch-from (family-of e state timed?) l (first-point who e l x0 not-found)))

(define (family-of e state timed?)
  (family e "equilibria" #f
          (lambda (x) (with-unknowns state timed? (up-of-numbers x)))))

;; The point of the curve that is near x0, where the parameter begins; (fail) where there is none
(define (first-point who e l x0 fail)
  (define x (with-handlers ([exn:fail:mechanics? (lambda (_) (fail))]) (solution-near who e x0)))
  (or (start-on-curve e x (if (< (limits-from l) (limits-to l)) 1 -1)) (fail)))

;; Complains unless the family makes a state derivative of the parameter.
(define (check-family who family state from)
  (check-comes-first who (and (tuple? family) (procedure? state)) "family of systems" "state")
  (unless (and (pointwise? family) (accepts? family 1))
    (complain-of-argument who "a family, a function from a parameter to a state derivative" family))
  (define f (family from))
  (unless (pointwise? f)
    (complain who
              (string-append "the family makes no state derivative of the parameter\n  given: ~a\n"
                             "  of ~a: ~a\n  (lambda (p) (Lagrangian->state-derivative (L p))) is one")
              (describe-function family) (value->text from) (describe-with-value f)))
  (check-derivative who f state))

;; A tenth of the range counts as much as 1 + |x| of another unknown.
(define (parameter-scale l) (fl* 0.1 (flabs (fl- (limits-to l) (limits-from l)))))

;; The scalars of v in place of those of the state but the time; those beyond are left.
(define (with-unknowns state timed? v)
  (define all (scalars v))
  (list->structure state (for/list ([x (in-list (if timed? (cons (car (scalars state)) all) all))]
                                    [_ (in-range (shape-length state))])
                           x)))

;; The scalars of a value, which may be those of derivatives
(define (numbers-of v)
  (define (number x)
    (define n (comparand x))
    (if (real? n) n (complain-of-argument 'branch "rates and states of real numbers" n)))
  (structure->flvector v number))

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
