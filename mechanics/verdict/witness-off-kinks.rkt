#lang racket/base
;; Refutations at points where derivatives do not see what happens are none: at t = 0 the
;; derivative of cos(t sgn t), which is cos t, is not what a formula with sgn 0 = 0 makes of it.
;; Points elsewhere are asked for.

(require "../algebra/expression/expression.rkt" "../algebra/expression/operation.rkt"
         "../algebra/expression/read.rkt" "../algebra/expression/substitute.rkt"
         "../value/algebra.rkt")

(provide looks-at-jumps? assumptions-off-kinks)

;; Is there a jump, of sgn, in e?
(define (looks-at-jumps? e)
  (and (node? e)
       (node-fold e
                  (lambda (leaf) #f)
                  (lambda (n parts) (or (eq? (node-head n) op:sgn) (ormap values parts))))))

;; A with relations that exclude the kinks on which the witness lies; #f if it lies on none.
(define (assumptions-off-kinks A kinks witness)
  (define there
    (for*/list ([k (in-list kinks)]
                [u (in-value (vanishing k))]
                #:when (and u (vanishes-at? u witness)))
      (list '> (list 'expt (expression->datum u) 2) 0)))
  (and (pair? there) (declare-relations A there)))

;; What vanishes at the kink, by its first equation; #f of a family of places.
(define (vanishing k)
  (define equations (kink-equations k))
  (and (pair? equations)
       (not (kink-family? k))
       (e:- (datum->expression (cadr (car equations)))
            (datum->expression (caddr (car equations))))))

(define (vanishes-at? u witness)
  (define x (substitute-expression u witness))
  (and (number? x) (zero? x)))
