#lang racket/base
;; Where an expression has a value: roots of what is not negative, logarithms of what is
;; positive, inverse functions where they are real.
;;
;; These relations hold wherever there is anything to say of the expression at all.  So
;; they may be used without being told: in √(1 - x) x is at most 1.  They have no datum.
;; What holds everywhere, as x² + y² ≥ 0 does, says nothing, and is left out.

(require racket/promise
         "assumption-set.rkt" "range.rkt" "signs.rkt"
         "../expression/expression.rkt" "../expression/operation.rkt")

(provide domain-relations)

;; e : an expression; -> relations, inner ones first; none where e holds a number that is not
;; real, for then its values are complex
(define (domain-relations e)
  (define found '())
  (define (need! signs u)
    (unless (number? u) (set! found (cons (relation #f u signs) found))))
  (define all-real? #t)
  (node-fold e
             (lambda (leaf)
               (unless (or (symbol? leaf) (real? leaf)) (set! all-real? #f))
               (delay (leaf-range leaf)))
             (lambda (n ranges)         ; promises: few are asked for
               (conditions-of n need! (lambda () (interval-signs (force (car ranges)))))
               (delay (node-range n (map force ranges)))))
  (if all-real? (reverse found) '()))

;; known : -> the signs that its first argument has in any case
(define (conditions-of n need! known)
  (define head (node-head n))
  (define u (and (pair? (node-args n)) (car (node-args n))))
  (define (need-signs! signs) (unless (signs-within? (known) signs) (need! signs u)))

  (cond [(eq? head op:sqrt) (need-signs! nonnegative)]
        [(eq? head op:log) (need-signs! positive)]
        [(eq? head op:expt) (power-conditions (cadr (node-args n)) need-signs!)]
        [(memq head (list op:asin op:acos op:atanh))
         (need! nonnegative (e:- u -1))
         (need! nonnegative (e:- 1 u))]
        [(eq? head op:acosh) (need! nonnegative (e:- u 1))]
        [else (void)]))

;; Of a symbolic power nothing: (-2)³ is real.
(define (power-conditions n need-signs!)
  (cond [(or (not (rational? n)) (integer? n)) (void)]
        [(negative? n) (need-signs! positive)]
        [else (need-signs! nonnegative)]))
