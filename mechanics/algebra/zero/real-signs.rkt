#lang racket/base
;; The signs that an expression may have, by all that is known of it.
;;
;; Three ways are tried: its structure and the relations declared (assumption/assumption-set.rkt), the
;; intervals its symbols are in (assumption/range.rkt), and for P + √A the rule of squares: the part
;; decides whose square is the greater.

(require racket/list
         "../assumption/assumption-set.rkt" "../assumption/leaf-bounds.rkt"
         "../assumption/range.rkt" "../assumption/signs.rkt"
         "../expression/conjugate.rkt" "../expression/expression.rkt" "../expression/operation.rkt"
         "../simplify/domain-question.rkt" "../simplify/simplify-expression.rkt")

(provide real-signs opposite-signs?)

;; e : an expression; A : assumptions, by which it is simplified -> signs
(define (real-signs e A [depth 2])
  (define simple (simplify-expression e A))
  (define bounds (bounds-from (assumptions-relations A)))
  (define signs
    (bitwise-and (known-signs (infer-signs A (neutral-workspace) simple))
                 (interval-signs (range-over simple (lambda (leaf) (bounds-of bounds leaf))))))
  (cond [(or (signs-decided? signs) (eqv? depth 0)) signs]
        [else (bitwise-and signs (signs-by-squares simple A (- depth 1)))]))

;; By the first root for which squares tell
(define (signs-by-squares e A depth)
  (or (for*/or ([r (in-list (roots-in e))] [k (in-value (root-signs e r A depth))])
        (and (not (eqv? k any-sign)) k))
      any-sign))

;; e = P + Q, where the sign of Q changes with that of the root
(define (root-signs e r A depth)
  (define-values (P Q) (parts-by-root e r))
  (define p (real-signs P A depth))
  (define q (real-signs Q A depth))
  (define together (signs-sum p q))
  (if (and (eqv? together any-sign) (or (signs-decided? p) (signs-decided? q)))
      (greater-part p q (real-signs (e:- (e:expt P 2) (e:expt Q 2)) A depth))
      together))

;; The sign of P + Q, which have the signs p and q, where P² − Q² has the signs of `excess`
(define (greater-part p q excess)
  (cond [(signs-within? excess nonnegative) (if (signs-within? excess positive) p (bitwise-ior p zero))]
        [(signs-within? excess nonpositive) (if (signs-within? excess negative) q (bitwise-ior q zero))]
        [else any-sign]))

;; Is one of them never negative, the other never positive?
(define (opposite-signs? P Q A)
  (define p (real-signs P A))
  (and (signs-decided? p)
       (signs-within? (real-signs Q A) (if (signs-within? p nonnegative) nonpositive nonnegative))))
