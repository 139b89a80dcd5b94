#lang racket/base
;; Is a residual zero that is made by differentiating?

(require "prove-zero.rkt" "smoothness.rkt")

(provide prove-residual-zero)

;; The verdict on the value of (find-residual); kinks that its derivatives pass over are noted.
;; names : the symbols by which it differentiates, which no condition may speak of
;; beside : further surveys; the other keywords are those of prove-zero
(define (prove-residual-zero find-residual names #:beside [surveys '()]
                             #:remarks [remarks (lambda () '())] #:meaning [meaning #f]
                             #:again [again #f])
  (define-values (residual survey) (survey-derivatives find-residual names))
  (prove-zero residual #:variables names #:surveys (append surveys (list survey))
              #:remarks remarks #:meaning meaning #:again again))
