#lang racket/base
;; From a state derivative to a system: compiled, its first value checked.

(require racket/flonum
         "check.rkt" "clock.rkt" "kept-systems.rkt" "Lagrangian-code.rkt" "manifold.rkt"
         "rates-code.rkt" "system.rkt"
         "../../compile/compile-function.rkt"
         "../../error/complain.rkt" "../../error/computed-once.rkt"
         "../../generic/describe.rkt"
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

;; What is compiled is a function.  What is not may depend on more than the state; then no step is
;; short enough.
(define (check-repeatable who derivative state)
  (define s (flvector->structure state (state-vector who state)))
  (define (rates) (structure->flvector (derivative s) (lambda (x) +nan.0)))
  (unless (equal? (rates) (rates))
    (complain who
              (string-append
               "the state derivative gives other values each time it is given the same state"
               "\n  derivative: ~a\n  state: ~a\n  its rates must follow from the state, and the "
               "time in it; random numbers are drawn before")
              (describe-with-value derivative) (value->text state))))

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
  (when (compiled-function-reason code) (check-repeatable who derivative state))
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
