#lang racket/base
;; Square roots within an expression, and its conjugate by one of them.
;;
;; Where e(√A) holds a root, e(−√A) is its conjugate, and e = P + Q with
;;
;;     P = (e(√A) + e(−√A))/2,      Q = (e(√A) − e(−√A))/2,
;;
;; of which P does not depend on the sign of the root, and Q changes with it.

(require "expression.rkt" "nodes.rkt" "operation.rkt"
         "substitute.rkt")

(provide roots-in conjugate parts-by-root applications-of)

;; The square roots in e, outer ones first
(define (roots-in e) (reverse (applications-of op:sqrt e)))

;; The nodes of e with this head, inner ones first, each once
(define (applications-of head e)
  (parts-in e (lambda (n) (and (eq? (node-head n) head) n))))

;; e with the root's opposite in its place
(define (conjugate e root)
  (define mark (string->uninterned-symbol "root"))
  (substitute-expression (substitute-expression e (list (cons root mark)))
                         (list (cons mark (e:* -1 root)))))

(define (parts-by-root e root)
  (define other (conjugate e root))
  (values (e:* 1/2 (e:+ e other)) (e:* 1/2 (e:- e other))))
