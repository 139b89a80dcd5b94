#lang racket/base
;; The start of a branch: a family that makes state derivatives, unknowns made of a state, and
;; the first point of the curve.

(require racket/flonum
         "branch.rkt" "curve-step.rkt"
         "../../error/complain.rkt" "../../error/failure.rkt"
         "../../generic/compare.rkt" "../../generic/describe.rkt"
         "../../generic/function.rkt" "../../generic/up-down.rkt" "../../generic/wrong-argument.rkt"
         "../../motion/system/check.rkt"
         "../../value/shape.rkt")

(provide check-family parameter-scale numbers-of with-unknowns first-point)

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
