#lang racket/base
;; A verdict that decimals stand in the way of, asked again with them as they are written.
;;
;; A body falls 4.9 t² where g is 9.8; but decimals that cancel may have been rounded before,
;; and prove nothing.  As 49/10 and 49/5 they do, which is told.  Only short ones are read, which
;; somebody wrote: rounded results have some sixteen digits.  If one is longer, nothing is
;; read.

(require (only-in racket/list remove-duplicates)
         "changed-values.rkt"
         "../error/refusal.rkt"
         "../generic/describe.rkt"
         "../value/algebra.rkt"
         "../verdict/verdict.rkt")

(provide decimals-as-written)

;; Is it a question within a question?
(define asked-again? (make-parameter #f))

;; -> the verdict, or a proof
(define (decimals-as-written v)
  (if (and (not (asked-again?)) (eq? (verdict-reason v) 'decimals))
      (let-values ([(w readings) (parameterize ([asked-again? #t]) (ask-again v))])
        (if (and w (proved? w)) (with-readings w readings) v))
      v))

;; -> the verdict and how decimals were read, or #f and none
(define (ask-again v)
  (define read '())
  (define (change e)
    (define readings (readings-as-written e))
    (unless readings (raise 'long-decimal))
    (set! read (remove-duplicates (append read readings)))
    (with-decimals-read e readings))
  (define (whole x) (change-values x change value->datum #:at-symbols? #t))
  (define w
    (with-handlers ([(lambda (x) (eq? x 'long-decimal)) (lambda (x) #f)]
                    [refusal? (lambda (x) #f)])
      ((verdict-question v) whole)))
  (values w (filter (lambda (r) (positive? (reading-decimal r))) read)))
