#lang racket/base
;; Proofs that an expression is zero.
;;
;; Each rests on a normal form that is 0: that of the expression as it stands, tried
;; briefly; that of an expression it is a special case of, long parts being symbols
;; (abstracted-parts.rkt); that with sines and cosines as exponentials
;; (in-exponentials.rkt).  Whoever finds no proof here may still look at the normal
;; form for as long as is bearable.

(require "abstracted-parts.rkt" "in-exponentials.rkt"
         "../assumption/assumption-set.rkt"
         "../expression/flat-graph.rkt"
         "../field/work-bounds.rkt"
         "../polynomial/fraction.rkt"
         "../simplify/simplify-expression.rkt")

(provide prove-vanishing datum-mentions?)

;; Fuel of the first attempt.
(define brief-look 500000)

;; t : tape; A : assumptions
;; -> the datums that the proof rests on, or #f if there is none.
(define (prove-vanishing t [A no-assumptions])
  (define e (tape->expression t))
  (or (prove-directly e A (make-fuel brief-look))
      (prove-abstractly t A)
      (prove-in-exponentials e A (make-fuel))))

(define (prove-directly e A fuel)
  (cond [(eqv? e 0) '()]
        [else
         (define-values (F f assumptions) (normal-form e A fuel))
         (and (fraction-zero? f) assumptions)]))

;; Where there are roots, absolute values or inverse functions, complex numbers would
;; be mistaken for positive ones.
(define (prove-in-exponentials e A fuel)
  (and (single-valued? e)
       (let ([other (in-exponentials e)])
         (and (not (eq? other e))
              (prove-directly other A fuel)))))

;; ---------------------------------------------------------------------------

;; The general case, and that parts taken for equal are.  Signs of parts that the general case
;; takes for granted would have to be checked, so it may not take any; and a
;; symbol does not tell that its part is negative, which matters under roots.
(define (prove-abstractly t A)
  (define-values (general differences) (abstract t))
  (define fuel (make-fuel))
  (define (prove e)
    (and (not (fuel-empty? fuel))
         (or (prove-directly e A fuel) (prove-in-exponentials e A fuel))))
  (and general
       (or (null? (assumptions-relations A)) (single-valued? general))
       (let ([assumptions (prove general)])
         (and assumptions
              (not (datum-mentions? assumptions uninterned?))
              (for/fold ([all assumptions]) ([d (in-list differences)])
                (define more (and all (prove d)))
                (and more (append more all)))))))

;; A symbol that stands for a part?
(define (uninterned? x) (and (symbol? x) (not (symbol-interned? x))))

;; Does the predicate hold of something in the datum?
(define (datum-mentions? datum good?)
  (if (pair? datum)
      (or (datum-mentions? (car datum) good?) (datum-mentions? (cdr datum) good?))
      (good? datum)))
