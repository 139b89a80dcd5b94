#lang racket/base
;; Why a motion cannot be followed any further, in words, and what may help.

(require racket/flonum
         "check.rkt" "system.rkt"
         "../error/failure.rkt"
         "../generic/describe.rkt"
         "../numeric/ode/stepper.rkt"
         "../value/shape.rkt")

(provide raise-stuck)

;; s : system; m : method; t, y : the last time and the state there; why : as
;; integrate.rkt says; kept : what the failure is to carry
(define (raise-stuck who s m t y why kept)
  (define state (system-state s y))
  (define (message what . fields)
    (string-append
     (format "~a: ~a\n  time: ~a\n  last state: ~a" who what t (value->text state))
     (apply string-append fields)))
  (define (raise-singular . fields)
    (raise (exn:fail:mechanics:singular
            (apply message "the motion cannot be followed any further" fields)
            (current-continuation-marks)
            kept)))
  (case why
    [(too-many-steps)
     (raise (exn:fail:mechanics:not-convergent
             (message "the motion takes more steps than allowed"
                      (if (or (method-step m) (method-jacobian? m))
                          ""
                          "\n  if it is stiff, use the method 'Radau-IIA-5"))
             (current-continuation-marks) kept #f))]
    [(no-slope) (raise-singular (or (slope-text s y "there") ""))]
    [(step-fails) (raise-singular (step-text m) (advice m))]
    [else
     (raise-singular (if (method-step m) (step-text m) "")
                     (or (beyond-text s y)
                         (if (eq? why 'boundary)
                             "\n  the state derivative is not finite beyond"
                             "\n  steps became too short to change the time")))]))

;; What there is instead of a finite state derivative; #f if there is one.
(define (slope-text s y where)
  (with-handlers ([exn:fail:mechanics:singular:matrix?
                   (lambda (e)
                     (apply string-append (format "\n  the mass matrix has no inverse ~a" where)
                            (for/list ([v (in-list (null-vectors e))])
                              (format "\n  no inertia in the direction: ~a" (value->text v)))))]
                  [exn:fail? (lambda (e) (format "\n  ~a: ~a" where (exn-message e)))])
    (define slope ((system-derivative s) (system-state s y)))
    (and (not (andmap finite? (scalars slope)))
         (format "\n  state derivative ~a: ~a" where (value->text slope)))))

(define (finite? given)
  (define x (real-number given))
  (and (real? x) (< (abs x) +inf.0)))

;; The same a little further, on either side.
(define (beyond-text s y)
  (define slope (scalars ((system-derivative s) (system-state s y))))
  (define (text h)
    (slope-text s
                (for/flvector #:length (flvector-length y)
                              ([x (in-flvector y)] [v (in-list slope)])
                  (+ x (* h (real->double-flonum (real-number v)))))
                "beyond"))
  (for/or ([h (in-list '(1e-9 -1e-9 1e-6 -1e-6))]) (text h)))

(define (null-vectors e) (or (exn:fail:mechanics:singular:matrix-null-vectors e) '()))

(define (step-text m) (format "\n  length of a step: ~a" (method-step m)))

;; Of equations that repetition did not solve, or of a step into what is no number.
(define (advice m)
  (format "\n  take a shorter step, such as (~a ~a), or a method that chooses its own"
          (method-name m) (/ (method-step m) 4)))
