#lang racket/base
;; From a state derivative to a system: compiled, its first value checked.

(require racket/flonum
         "check.rkt" "clock.rkt" "kept-systems.rkt" "Lagrangian-code.rkt" "manifold.rkt"
         "rates-code.rkt" "system.rkt"
         "../../compile/compile-function.rkt"
         "../../error/once.rkt"
         "../../numeric/flvector.rkt"
         "../../value/shape.rkt")

(provide make-system)

;; given : state -> state
(define (make-system who given state)
  (define (good? s) (starts? s (state-vector who state)))
  (cond [(manifold-derivative? given)
         (define p (prepare-motion who given state))
         (keeping-system given state #:make (lambda () (new-system who p state))
                         #:keep? system-operations #:good? good?
                         #:watched (preparation-watched p) #:mark (preparation-mark p))]
        [else
         (keeping-system given state
                         #:make (lambda () (new-system who (prepare-motion who given state) state))
                         #:keep? system-operations #:good? good?)]))

;; Are the rates numbers at y?  If not, it is to be said why.
(define (starts? s y)
  (define slope (make-flvector (flvector-length y)))
  (((system-make-slope! s)) y slope)
  (flvector-finite? slope))

(define (new-system who p state)
  (define derivative (preparation-derivative p))
  (define-values (corrections rates) (complete-motion who p state))
  (define code
    (or rates
        (Lagrangian-code who derivative state)
        (let ([slope (check-derivative who derivative state)])
          (compile-function derivative state #:name who #:value slope))))
  (define clock? (clock-first? code))
  (define (slope!)
    (define run (compiled-function-runner code))
    (if (and clock? (compiled-function-reason code)) (on-time who run) run))
  (define n (shape-length state))
  (define jacobian (once (lambda () (jacobian-maker code n))))
  (system state clock? derivative
          slope!
          (lambda () (let ([make (jacobian)]) (and make (make))))
          (compiled-function-operations code)
          (once (lambda () (expander-of code n (flvector))))
          (once (lambda () (machine-rates-of code n)))
          (flvector)
          corrections (box '()) (box #f) #f))
