#lang racket/base
;; Verdicts that decimals have a part in, asked again with exact numbers or symbols in their place.
;;
;; A body falls 4.9 t² where g is 9.8; but decimals that cancel may have been rounded before,
;; and prove nothing.  As 49/10 and 49/5 they do, which is told.  Where decimals stand in the way of
;; a verdict only short ones are read, which somebody wrote: rounded results have some sixteen
;; digits.  If one is longer, nothing is read.
;;
;; A proof may owe all to rounding as well: of A cos(3.13… t) where 9.8 is the square of 3.13… for
;; flonums.  So a proof about decimals is asked for again with a symbol for each.  If that is
;; none, they are read, and what leads to no proof then is none.

(require (only-in racket/list remove-duplicates)
         "changed-values.rkt"
         "../algebra/expression/expression.rkt"
         "../error/refusal.rkt"
         "../generic/describe.rkt" "../generic/irrational.rkt" "../generic/scalar.rkt"
         "../value/algebra.rkt" "../value/shape.rkt"
         "../verdict/verdict.rkt")

(provide verdict-with-decimals)

;; Is it a question within a question?
(define asked-again? (make-parameter #f))

;; matter : -> values that are asked about, at symbols
(define (verdict-with-decimals v matter)
  (cond [(asked-again?) v]
        [(eq? (verdict-reason v) 'decimals) (or (proof-as-written v) v)]
        [(and (proved? v)
              (null? (verdict-readings v))
              (ormap decimal? (scalars (matter))))
         (proof-whatever-rounding v)]
        [else v]))

(define (decimal? x)
  (and (scalar? x) (some-leaf? flonum? (irrational-as-expression x))))

;; -> the verdict, or #f if it has no answer
(define (ask v change)
  (with-handlers ([(lambda (x) (or (eq? x 'long-decimal) (refusal? x))) (lambda (x) #f)])
    (parameterize ([asked-again? #t])
      ((verdict-question v) (lambda (x) (change-values x change value->datum #:at-symbols? #t))))))

(define (proof-as-written v)
  (define read '())
  (define w
    (ask v (lambda (e)
             (define readings (or (readings-as-written e) (raise 'long-decimal)))
             (set! read (append read readings))
             (with-decimals-read e readings))))
  (and w (proved? w) (with-readings w (readings-told read))))

;; Of a number and its negative one is told.
(define (readings-told read)
  (define all (map reading-decimal read))
  (define (told? x) (or (positive? x) (and (negative? x) (not (memv (- x) all)))))
  (filter (lambda (r) (told? (reading-decimal r))) (remove-duplicates read)))

;; The proof v; or it with readings, or a doubt
(define (proof-whatever-rounding v)
  (define-values (general _) (ask-with-unknowns v (lambda (xs) '())))
  (define-values (answer read)
    (if (eq? general 'open) (ask-with-unknowns v read-decimals) (values general '())))
  (if (eq? answer 'open)
      (with-doubt v (readings-told read))
      (with-readings v (readings-told (filter reading-expression read)))))

;; read : decimals -> readings; decimals without one are unknowns
;; -> 'proved, whatever the unknowns are, 'open, or 'unasked; and all readings
(define (ask-with-unknowns v read)
  (define-values (unknowns all) (values (make-hasheqv) '()))
  (define w
    (ask v (lambda (e)
             (define readings (read (decimals-of e)))
             (set! all (append all readings))
             (with-unknown-flonums
              (with-decimals-read e (filter reading-expression readings)) unknowns))))
  (values (cond [(not w) 'unasked]
                [(and (proved? w) (not (mentions-unknown? (verdict-assumptions w) unknowns)))
                 'proved]
                [else 'open])
          all))
