#lang racket/base
;; Numbers to be drawn, as flonums.
;;
;; A number without a place in the plane, as the logarithm of a negative number, is
;; left out of the picture: it becomes a NaN.  Other values are errors.

(require "../../algebra/expression/expression.rkt"
         "../../algebra/expression/symbols.rkt"
         "../../error/complain.rkt" "../../error/hint.rkt" "../../error/computed-once.rkt"
         "../../error/message-words.rkt"
         "../../generic/describe.rkt" "../../generic/function.rkt"
         "../../generic/multiplied-function.rkt" "../../generic/number-argument.rkt"
         "../../generic/plane-coordinates.rkt" "../../generic/up-down.rkt"
         "../../generic/wrong-argument.rkt"
         "../../numeric/equal-steps.rkt" "../../numeric/finite-number.rkt")

(provide coordinate-of plane-point check-number check-function check-function-of-state parameters)

;; what : a string, such as "y", or a procedure that returns it
(define (coordinate-of who what x)
  (cond [(flonum? x) x]
        [(known-number x) => real->double-flonum]
        [(number? x) +nan.0]
        [else
         (complain who "~a is no number\n  given: ~a~a"
                   (at-last what) (describe-with-value x) (advice x))]))

(define (advice x)
  (cond [(symbolic? x)
         (define symbols (map symbol->string (symbols-in x)))
         (if (null? symbols)
             ""
             (format "\n  without a number: ~a~a" (joined symbols) symbols-hint))]
        [(tuple? x) "\n  draw its components one by one, as with (component 0)"]
        [else (multiplied-hint x)]))

;; -> both coordinates of a point, as flonums
(define (plane-point who what p)
  (define-values (x y)
    (plane-coordinates
     p (lambda ()
         (complain who "~a is no point of the plane, such as (up x y) or (cons x y)\n  given: ~a"
                   (at-last what) (describe-with-value p)))))
  (define ((component which)) (format "~a, its ~a component," (at-last what) which))
  (values (coordinate-of who (component "first") x) (coordinate-of who (component "second") y)))

;; An argument that must be a finite number.
(define (check-number who what x)
  (define number (coordinate-of who what x))
  (unless (finite? number)
    (complain-of-argument who (format "a finite number as ~a" what) x))
  number)

(define (check-function who f count [expected (if (= count 1)
                                                  "a function of one number"
                                                  "a function of two numbers")])
  (unless (and (procedure? f) (accepts? f count)) (raise-other-function who expected f)))

(define (check-function-of-state who f [such-as ""])
  (check-function who f 1 (string-append "a function of the state" such-as)))

;; More parameters come from a slip in the step, and would fill the memory.
(define most-parameters 10000000)

;; -> the numbers from one to another in steps; the last step may be shorter
(define (parameters who from to step)
  (unless (> step 0.0)
    (complain-of-argument who "a positive step" step))
  (define steps (step-count (abs (- to from)) step))
  (unless (<= steps most-parameters)
    (complain-showing who "the step is too short for so long a curve"
                      "step" step
                      "from" from
                      "to" to
                      "steps" steps
                      "at most" most-parameters))
  (if (< steps 1.0) (list from to) (numbers-between from to step)))
