#lang racket/base
;; From a state derivative to a system: compiled, its first value checked.

(require racket/flonum
         "check.rkt" "time-component.rkt" "kept-systems.rkt" "Lagrangian-code.rkt" "manifold.rkt"
         "rates-code.rkt" "system.rkt"
         "../../compile/compile-function.rkt"
         "../../error/complain.rkt" "../../error/computed-once.rkt"
         "../../generic/describe.rkt"
         "../../numeric/flvector.rkt" "../../numeric/ode/stepper.rkt"
         "../../value/shape.rkt")

(provide make-system system-of-code)

;; given : state -> state
(define (make-system who given state)
  (define (good? s) (starts? s (state-vector who state)))
  (define p (prepare-motion who given state))
  (keeping-system given state #:make (lambda () (new-system who p state))
                  #:keep? system-operations #:good? good?
                  #:watched (and (manifold-derivative? given) (preparation-watched p))
                  #:mark (preparation-mark p)))

;; Compiled rates are a function of the state.  Rates that are not compiled may depend on more; then
;; no step is short enough.
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

;; Are the rates finite at y?  If not, the system is made anew, which raises the reason.
(define (starts? s y)
  (flvector-finite? (rates-at ((system-make-slope! s)) y)))

(define (new-system who p state)
  (define derivative (preparation-derivative p))
  (define-values (corrections rates) (complete-motion who p state))
  (define code
    (or rates
        (Lagrangian-code who derivative state)
        (let ([slope (check-derivative who derivative state)])
          (compile-function derivative state #:name who #:value slope))))
  (when (compiled-function-reason code) (check-repeatable who derivative state))
  (define (checked run)
    (if (and (clock-first? code) (compiled-function-reason code)) (on-time who run) run))
  (system-of-code state derivative code checked values (flvector) corrections))

;; slope-of, jacobian-of : compiled procedure -> the procedure that an integration calls;
;; ps : the values of the parameters
(define (system-of-code state derivative code slope-of jacobian-of ps corrections)
  (define n (shape-length state))
  (define jacobian (once (lambda () (jacobian-maker code n))))
  (system state (clock-first? code) derivative
          (lambda () (slope-of (compiled-function-runner code)))
          (lambda () (let ([make (jacobian)]) (and make (jacobian-of (make)))))
          (compiled-function-operations code)
          (once (lambda () (expander-of code n ps)))
          (once (lambda () (machine-rates-of code n)))
          ps corrections (box #f) (box #f) #f))
