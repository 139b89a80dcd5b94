#lang racket/base
;; Statements: S-expressions that are said to be equal where relations hold; and questions of
;; any other kind.

(provide (struct-out statement) (struct-out inquiry) substituted expression-size quoted-symbols
         pick chance random-between)

;; hints : hashes symbol -> rational, points where the relations hold
(struct statement (left right given hints) #:prefab)

;; program : a form of which the value is a verdict, an expression, or a list of data
;; matter : what it is about, for the judge (judge/matter.rkt)
(struct inquiry (program matter) #:prefab)

;; The form that makes an expression, in which the variables that are bound stay as they are.
(define (quoted-symbols e bound)
  (let walk ([e e])
    (cond [(symbol? e) (if (memq e bound) e (list 'quote e))]
          [(pair? e) (cons (car e) (map walk (cdr e)))]
          [else e])))

(define (substituted e old new)
  (let walk ([e e])
    (cond [(equal? e old) new]
          [(pair? e) (cons (car e) (map walk (cdr e)))]
          [else e])))

(define (expression-size e)
  (if (pair? e) (apply + 1 (map expression-size (cdr e))) 1))

;; ---------------------------------------------------------------------------
;; Chance

(define (pick xs) (list-ref xs (random (length xs))))
(define (chance n) (zero? (random n)))          ; one time in n
(define (random-between low high) (+ low (random (- high low -1))))
