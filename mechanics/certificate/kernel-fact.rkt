#lang racket/base
;; A fact about a kernel, with its proof in Coq, and those that hold of each root or absolute value.

(require "Coq-term.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/operation.rkt")

(provide (struct-out fact) root-relation modulus-relation)

;; sort   : 'value, left = right replaces left; 'relation, a power of a kernel; 'known, anything;
;;          'divisor and 'factor, as 'value and 'known, where a proof may do without
;; left   : expression; right : expression, or of what is known a relation sign with expressions
;; script : its proof in parts; 'identity stands for the proof of an equality by the facts before
(struct fact (sort left right script) #:authentic)

(define (root-relation n [sign (if (power-of-e? (car (node-args n)))
                                   "left; apply exp_pos."
                                   "nonnegative.")])
  (fact 'relation (make-node op:* (list n n)) (car (node-args n))
        (list (string-append "apply sqrt_sqrt; " sign))))

;; Is it an exponential, or one by its definition, as Rpower is?
(define (power-of-e? e)
  (or (headed? e op:exp)
      (and (headed? e op:expt)
           (let-values ([(kind _) (split-power (cadr (node-args e)))]) (eq? kind 'exponential)))))

(define (modulus-relation n)
  (define a (car (node-args n)))
  (fact 'relation (make-node op:* (list n n)) (make-node op:* (list a a))
        '("apply modulus_squared.")))
