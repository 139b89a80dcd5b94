#lang racket/base
;; Statements: S-expressions that are said to be equal where relations hold.

(provide (struct-out statement) substituted expression-size
         pick chance random-between)

;; hints : hashes symbol -> rational, points where the relations hold
(struct statement (left right given hints) #:prefab)

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
