#lang racket/base
;; Square roots within an expression, and its conjugate by one of them.
;;
;; Where e(√A) holds a root, e(−√A) is its conjugate, and e = P + Q with
;;
;;     P = (e(√A) + e(−√A))/2,      Q = (e(√A) − e(−√A))/2,
;;
;; of which P does not depend on the sign of the root, and Q changes with it.

(require racket/list
         "../expression/expression.rkt" "../expression/operation.rkt"
         "../expression/substitute.rkt")

(provide nodes-in roots-in conjugate parts-by-root)

;; The square roots in e, outer ones first, each once
(define (roots-in e) (remove-duplicates (reverse (nodes-in e op:sqrt))))

;; The nodes with this head, inner ones first
(define (nodes-in e head)
  (define found '())
  (node-fold e void
             (lambda (n parts) (when (eq? (node-head n) head) (set! found (cons n found)))))
  (reverse found))

;; e with the root's opposite in its place
(define (conjugate e root)
  (define mark (string->uninterned-symbol "root"))
  (substitute-expression (substitute-expression e (list (cons root mark)))
                         (list (cons mark (e:* -1 root)))))

(define (parts-by-root e root)
  (define other (conjugate e root))
  (values (e:* 1/2 (e:+ e other)) (e:* 1/2 (e:- e other))))
