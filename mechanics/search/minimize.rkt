#lang racket/base
;; Minima of functions made by the generic arithmetic (SICM pp. 19 and 22).
;;
;; `find-minimum` tells the kind of its result; the others give the results of the book's
;; procedures of their names.  All can be differentiated by the values that the function depends on.

(require "least-between.rkt" "minimum.rkt" "minimum-near.rkt" "objective.rkt" "varying-minimum.rkt"
         "../error/complain.rkt" "../error/failure.rkt" "../error/note.rkt"
         "../generic/define-plain.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/number-argument.rkt" "../generic/wrong-argument.rkt"
         "../numeric/finite-number.rkt" "../error/progress.rkt" "../numeric/checked-arguments.rkt"
         (prefix-in numeric: "../numeric/optimization/brent-minimum.rkt")
         "../numeric/optimization/golden-section.rkt"
         (prefix-in numeric: "../numeric/optimization/nelder-mead.rkt"))

(provide find-minimum minima minimize brent-min golden-section-min
         multidimensional-minimize nelder-mead)

;; ---------------------------------------------------------------------------
;; Minima, and their kinds

;; (find-minimum f low high), of a function of a number, or (find-minimum f start) for a start
;; of any shape.
(define-plain (find-minimum f start [high #f]
                            #:tolerance [tolerance 1e-8] #:method [method #f]
                            #:observe [observe void] #:progress? [progress? (report-progress)])
  (define who 'find-minimum)
  (check-search who f tolerance method)
  (if high
      (least-between who f start high (brent who tolerance observe) progress? #:judge? #t)
      (least-near who f start method tolerance observe progress?)))

;; Minima of a function of a number between low and high, from left to right
(define-plain (minima f low high #:tolerance [tolerance 1e-8]
                      #:observe [observe void] #:progress? [progress? (report-progress)])
  (define who 'minima)
  (check-search who f tolerance)
  (all-between who f low high (brent who tolerance observe) progress?))

(define (check-search who f tolerance [method #f])
  (check-function-of-one-variable who f)
  (check-tolerance who tolerance)
  (unless (memq method '(quasi-newton nelder-mead #f))
    (complain-of-argument who "'quasi-newton or 'nelder-mead" method)))

;; ---------------------------------------------------------------------------
;; In one variable: (argument value steps) of a minimum of f between low and high

(define-plain (minimize f low high #:tolerance [tolerance 1e-8]
                        #:observe [observe void] #:progress? [progress? (report-progress)])
  (triples-between 'minimize f low high (brent 'minimize tolerance observe) progress?))

(define-plain (brent-min f low high [tolerance 1e-8] #:observe [observe void]
                         #:progress? [progress? (report-progress)])
  (triples-between 'brent-min f low high (brent 'brent-min tolerance observe) progress?))

;; done? : a tolerance, or a predicate of low, best and high argument, the values there
;; and the count of steps
(define-plain (golden-section-min f low high [done? 1e-8] #:observe [observe void]
                                  #:progress? [progress? (report-progress)])
  (define who 'golden-section-min)
  (if (procedure? done?) (check-predicate who done?) (check-tolerance who done?))
  (define (method f low high)
    (golden-section f low high (if (procedure? done?) done? (width-at-most done?)) observe))
  (triples-between who f low high method progress?))

(define (triples-between who f low high method progress?)
  (check-function-of-one-variable who f)
  (define m (least-between who f low high method progress? #:judge? #f))
  (note-kind who m)
  (minimum->triple m (minimum-evaluations m)))

(define ((brent who tolerance observe) f low high)
  (numeric:minimize f low high #:tolerance tolerance #:observe observe #:name who))

(define (check-predicate who done?)
  (unless (accepts? done? 7)
    (complain-showing
     who "a predicate that ends the search takes three arguments, the values there and a count"
     "given" done?)))

;; ---------------------------------------------------------------------------
;; In several variables: from the gradient, or, of a function that has none
;; everywhere or does not say in which direction it falls, from values alone

;; The argument, of the shape of `start`, at which f has a minimum; report : receives
;; it, the value there, the size of the gradient, #f where it is not known, and the
;; evaluations of f.
(define-plain (multidimensional-minimize f start
                                         #:tolerance [tolerance 1e-8]
                                         #:method [method #f]
                                         #:observe [observe void]
                                         #:report [report (lambda (x y size count) x)]
                                         #:progress? [progress? (report-progress)])
  (define who 'multidimensional-minimize)
  (check-search who f tolerance method)
  (define m (least-near who f start method tolerance observe progress?))
  (when (eq? (minimum-kind m) 'saddle) (raise-saddle who m))
  (note-kind who m)
  (report (minimum-argument m) (minimum-value m) (minimum-gradient m) (minimum-evaluations m)))

(define (least-near who f start method tolerance observe progress?)
  (define t (make-objective who f start))
  (define (search note!)
    (define (show x y) (observe (objective-argument t x) y))
    (minimum-near t method tolerance (counting-search note! who show)))
  (define-values (m x) (call-with-progress progress? search))
  (varying-minimum t m x))

;; (list argument value evaluations), at the limit those of the best argument
(define-plain (nelder-mead f start [step #f] [tolerance 1e-8] [limit 20000]
                           #:observe [observe void]
                           #:progress? [progress? (report-progress)])
  (define who 'nelder-mead)
  (check-function-of-one-variable who f)
  (when step (check-argument who positive-finite? step "a positive step"))
  (check-tolerance who tolerance)
  (check-argument who exact-positive-integer? limit "a number of evaluations, a positive integer")
  (define t (make-objective who f start))
  (define (argument x) (objective-argument t x))
  (define (search note!)
    (define watch (counting-search note! who (lambda (x y) (observe (argument x) y))))
    (numeric:nelder-mead (lambda (x) (objective-value t x)) (objective-start t)
                         #:step step #:tolerance tolerance #:limit limit #:name who
                         #:stop-at-limit? #t
                         #:observe watch #:argument argument))
  (define-values (x y count) (call-with-progress progress? search))
  (define m (if-varying t x (lambda () (judged-minimum t x y count))))
  (if m (minimum->triple m count) (list (argument x) y count)))

;; ---------------------------------------------------------------------------
;; Notes on the kind of a minimum, which the results of these procedures do not show

(define (note-kind who m)
  (define at (value->text (minimum-argument m)))
  (case (minimum-kind m)
    [(end) (note-with-result (format "~a: least at the end of the interval, ~a" who at))]
    [(flat)
     (note-with-result (format "~a: the function is flat around ~a, and nothing lower was found"
                               who at))]
    [else (void)]))

(define (raise-saddle who m)
  (raise-not-convergent who "no minimum found: the search ended at a saddle"
                        (minimum-argument m) #f #:show? #f
                        "at" (minimum-argument m)
                        "size of the gradient there" (minimum-gradient m)
                        "least curvature there" (minimum-curvature m)))
