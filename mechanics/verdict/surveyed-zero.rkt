#lang racket/base
;; Is a residual zero that is made by differentiating?

(require "derivative-survey.rkt" "prove-zero.rkt")

(provide prove-residual-zero)

;; The verdict on the value of (find-residual); kinks that its derivatives pass over are noted.
;; names : the symbols by which it differentiates, which no condition may speak of
;; beside : further surveys
;; within : as domain, but without values of derivatives; where that has no value is no kink
;; functions, order : those that it differentiates, and how often (derivative-survey.rkt)
;; The other keywords are those of prove-zero.
(define (prove-residual-zero find-residual names #:beside [surveys '()]
                             #:domain [domain (lambda () '())] #:within [within domain]
                             #:functions [functions within] #:order [order 2]
                             #:remarks [remarks (lambda () '())] #:meaning [meaning #f]
                             #:again [again #f] #:about [subject #f])
  (define-values (residual survey)
    (survey-derivatives find-residual names
                        #:domain within #:functions functions #:order order))
  (prove-zero residual #:variables names #:surveys (append surveys (list survey))
              #:domain domain #:remarks remarks #:meaning meaning #:again again
              #:about subject))
