#lang racket/base
;; Where an expression has a value: roots of what is not negative, logarithms of what is
;; positive, inverse functions where they are real.
;;
;; These relations hold wherever there is anything to say of the expression at all.  So
;; they may be used without being told: in √(1 - x) x is at most 1.  They have no datum.

(require "assumption-set.rkt" "signs.rkt"
         "../expression/expression.rkt" "../expression/operation.rkt")

(provide domain-relations)

;; e : an expression; -> relations, inner ones first; none where e holds a number that is not
;; real, for then its values are complex
(define (domain-relations e)
  (define found '())
  (define (need! signs u)
    (unless (or (number? u) (square? u)) (set! found (cons (relation #f u signs) found))))
  (define all-real?
    (node-fold e
               (lambda (leaf) (or (symbol? leaf) (real? leaf)))
               (lambda (n parts)
                 (conditions-of n need!)
                 (andmap values parts))))
  (if all-real? (reverse found) '()))

;; Of a square there is nothing to say.
(define (square? e)
  (and (node? e)
       (let ([args (node-args e)])
         (cond [(eq? (node-head e) op:*) (and (= (length args) 2) (equal? (car args) (cadr args)))]
               [(eq? (node-head e) op:expt)
                (and (exact-integer? (cadr args)) (even? (cadr args)))]
               [else #f]))))

(define (conditions-of n need!)
  (define head (node-head n))
  (define u (and (pair? (node-args n)) (car (node-args n))))
  (define (within low high)
    (need! nonnegative (e:- u low))
    (need! nonnegative (e:- high u)))
  (cond [(eq? head op:sqrt) (need! nonnegative u)]
        [(eq? head op:log) (need! positive u)]
        [(eq? head op:expt) (power-conditions u (cadr (node-args n)) need!)]
        [(memq head (list op:asin op:acos)) (within -1 1)]
        [(eq? head op:acosh) (need! nonnegative (e:- u 1))]
        [(eq? head op:atanh) (within -1 1)]
        [else (void)]))

;; Of a symbolic power nothing: (-2)³ is real.
(define (power-conditions u n need!)
  (cond [(or (not (rational? n)) (integer? n)) (void)]
        [(negative? n) (need! positive u)]
        [else (need! nonnegative u)]))
