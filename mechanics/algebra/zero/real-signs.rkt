#lang racket/base
;; The signs that an expression may have, by all that is known of it.
;;
;; Three ways are tried: its structure and the relations declared (assumption/assumption-set.rkt),
;; the intervals its symbols are in (assumption/range.rkt), and for P + √A the rule of squares: the
;; part decides whose square is the greater.
;;
;; Of a conjugate nothing is concluded unless it has a real value wherever e has one: √(1 + √x) has,
;; √(1 − √x) has none beyond 1.

(require racket/list
         "../assumption/assumption-set.rkt" "../assumption/domain.rkt"
         "../assumption/leaf-bounds.rkt"
         "../assumption/range.rkt" "../assumption/signs.rkt"
         "../expression/conjugate.rkt" "../expression/expression.rkt" "../expression/nodes.rkt"
         "../expression/operation.rkt"
         "../simplify/domain-question.rkt" "../simplify/simplify-expression.rkt")

(provide real-signs opposite-signs? conjugate-roots)

;; e : an expression; A : assumptions, by which it is simplified -> signs
(define (real-signs e A [depth 2])
  (define simple (simplify-where e A))
  (define bounds (bounds-around (assumptions-relations A)))
  (define signs
    (bitwise-and (known-signs (infer-signs A (neutral-workspace) simple))
                 (interval-signs (range-over simple (lambda (leaf) (bounds-of bounds leaf))))))
  (cond [(or (signs-decided? signs) (eqv? depth 0)) signs]
        [else (bitwise-and signs (signs-by-squares simple A (- depth 1)))]))

;; By the first root for which squares tell
(define (signs-by-squares e A depth)
  (or (for*/or ([r (in-list (conjugate-roots e A))]
                [k (in-value (root-signs e r A depth))])
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
  (define (or-zero signs) (if (signs-within? zero excess) (bitwise-ior signs zero) signs))
  (cond [(signs-within? excess nonnegative) (or-zero p)]
        [(signs-within? excess nonpositive) (or-zero q)]
        [else any-sign]))

;; Is one of them never negative, the other never positive?
(define (opposite-signs? P Q A)
  (define p (real-signs P A))
  (and (signs-decided? p)
       (signs-within? (real-signs Q A) (if (signs-within? p nonnegative) nonpositive nonnegative))))

;; ---------------------------------------------------------------------------
;; Conjugates

;; The roots in e by which its conjugates are real wherever e is
(define (conjugate-roots e A)
  (define roots (roots-in e))
  (define needs (if (null? roots) '() (needs-of e)))
  (filter (lambda (r) (as-real? (conjugate e r) needs A)) roots))

;; Has e a real value wherever these needs, and A, are satisfied?
(define (as-real? e needs A)
  (for/and ([n (in-list (remove* needs (needs-of e)))])
    (and (relation? n)
         (signs-within? (real-signs (relation-expression n) A 0) (relation-signs n)))))

;; Needs of the operations of e for a value: relations, and nodes of which none tells
(define (needs-of e)
  (append-map (lambda (n) (if (untold? n) (list n) (node-relations n))) (nodes-in e)))

;; Symbolic powers, and angles of points
(define (untold? n)
  (or (and (headed? n op:expt) (not (rational? (cadr (node-args n)))))
      (and (headed? n op:atan) (pair? (cdr (node-args n))))))
