#lang racket/base
;; Reading S-expressions as expressions: the datum an expression prints as gives
;; an equal expression back.  Expressions may stand within the datum.

(require "expression.rkt" "operation.rkt" "substitute.rkt"
         "../../operation/operation-column.rkt")

(provide datum->expression operation-name?)

;; reject : part of the datum that is no expression -> does not return
(define (datum->expression d [reject raise-no-expression])
  (let read ([d d])
    (cond [(expression? d) d]
          [(and (list? d) (pair? d))
           (or (read-operation (car d) (map read (cdr d)) (lambda () (reject d)))
               (make-node (datum->head (car d) reject) (map read (cdr d))))]
          [else (reject d)])))

(define (raise-no-expression d)
  (raise-argument-error 'datum->expression "an expression as it prints" d))

;; ---------------------------------------------------------------------------
;; Operations

(define (find-head name)
  (case name
    [(up) op:up]
    [(down) op:down]
    [else (find-operation name)]))

;; Is head the name of an operation, and not of an unknown function?
(define (operation-name? head)
  (and (symbol? head)
       (or (memq head '(square cube))
           (find-head head)
           (assq head reciprocals))
       #t))

;; -> an expression, or #f if the head is no operation's name
(define (read-operation head args reject)
  (define (between low high)
    (unless (<= low (length args) high) (reject)))
  (case head
    [(+) (rebuild op:+ args)]
    [(*) (rebuild op:* args)]
    [(-) (between 1 +inf.0)
         (if (null? (cdr args)) (e:negate (car args)) (fold-left e:- args))]
    [(/) (between 1 +inf.0)
         (if (null? (cdr args)) (e:/ 1 (car args)) (fold-left e:/ args))]
    [(expt) (between 2 2) (power (car args) (cadr args))]
    [(square cube)
     (between 1 1)
     (e:expt (car args) (if (eq? head 'square) 2 3))]
    [else
     (define inverted (assq head reciprocals))
     (define op (find-head (if inverted (cdr inverted) head)))
     (when (and op (operation-numeric op)) (between 1 (if (eq? op op:atan) 2 1)))
     (define n (and op (make-node op args)))
     (if inverted (e:/ 1 n) n)]))

;; Roots of numbers stay as they are.
(define (power b n)
  (if (and (number? b) (number? n) (not (integer? n)))
      (make-node op:expt (list b n))
      (e:expt b n)))

(define (fold-left f args)
  (for/fold ([x (car args)]) ([a (in-list (cdr args))]) (f x a)))

;; ---------------------------------------------------------------------------
;; Literal heads: x, (D x), ((expt D 2) x), ((partial 1) F), ...

(define (datum->head h reject)
  (cond [(symbol? h) (make-literal-head h)]
        [(and (list? h) (= 2 (length h)) (symbol? (cadr h)))
         (differentiate (car h) (make-literal-head (cadr h)) (lambda () (reject h)))]
        [else (reject h)]))

;; how : D, (partial i ...), (expt how n) or (* how ...)
(define (differentiate how head reject)
  (define kind (and (list? how) (pair? how) (car how)))
  (cond [(eq? how 'D) (literal-head-derivative head '())]
        [(and (eq? kind 'partial) (andmap exact-nonnegative-integer? (cdr how)))
         (literal-head-derivative head (cdr how))]
        [(and (eq? kind 'expt) (= 3 (length how)) (exact-nonnegative-integer? (caddr how)))
         (for/fold ([h head]) ([i (in-range (caddr how))]) (differentiate (cadr how) h reject))]
        [(eq? kind '*)
         (for/fold ([h head]) ([one (in-list (cdr how))]) (differentiate one h reject))]
        [else (reject)]))
