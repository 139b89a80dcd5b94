#lang racket/base
;; Minima between two numbers, their kinds, and their change with the values that the
;; function or the ends depend on.

(require racket/flonum
         "minimum.rkt" "minimum-between.rkt" "minimum-near.rkt" "objective.rkt"
         "varying-minimum.rkt"
         "../calculus/perturbed-value.rkt"
         "../error/progress.rkt"
         "../generic/number-argument.rkt")

(provide least-between all-between)

;; method : f low high -> (list argument value steps)
;; judge? : are gradient and curvature to be looked at?  If not, steps of the method are counted.
;; -> minimum
(define (least-between who f low high method progress? #:judge? judge?)
  (with-search minimum-between who f low high method progress?
    (lambda (found) (described who f low high found judge?))))

;; -> list of minima, from left to right
(define (all-between who f low high method progress?)
  (with-search minima-between who f low high method progress?
    (lambda (all) (for/list ([one (in-list all)]) (described who f low high one #t)))))

(define (with-search search who f low high method progress? receive)
  (define (value x) (number-beneath who (f x)))
  (define (end x) (number-beneath who x))
  (define-values (a b) (values (end low) (end high)))
  (receive
   (call-with-progress
    progress?
    (lambda (note!) (search who (counted-values note! who value) a b method)))))

;; found : as minimum-between.rkt has it
(define (described who f low high found judge?)
  (define x (found-x found))
  (define t (make-objective who f x))
  (define count (if judge? (found-evaluations found) (found-steps found)))
  (define (plain kind) (minimum x (found-y found) kind #f #f count))
  (case (found-kind found)
    [(low high) (at-end t f found (plain 'end) low high judge?)]
    [(flat) (varying-minimum t (plain 'flat) (flvector x))]
    [else
     (define-values (m at)
       (if (or judge? (varying? (f x)))
           (judged-minimum t (flvector x) (found-y found) count)
           (values (plain 'minimum) (flvector x))))
     (varying-minimum t m at)]))

;; An end moves as it is said to; but where the function is level at it, the minimum may
;; leave it.
(define (at-end t f found m low high judge?)
  (define end (if (eq? (found-kind found) 'low) low high))
  (define other (if (eq? (found-kind found) 'low) high low))
  (define x (minimum-argument m))
  (define g (and (or judge? (varying? (f end))) (objective-gradient t (flvector x))))
  (define slope (and g (flvector-ref g 0)))
  (define (m-with argument value)
    (minimum argument value 'end (and slope (abs slope)) #f (minimum-evaluations m)))
  (cond
    [(not (varying? (f end))) (m-with x (minimum-value m))]
    [(and slope (> (* slope (- (innermost other) (innermost end))) 0.0)) (m-with end (f end))]
    [else (raise-kind (objective-who t) 'end x)]))
