#lang racket/base
;; Points: numbers for symbols, polynomials for literal functions, readings of decimals.

(require "evaluate.rkt" "interval.rkt" "polynomial.rkt")

(provide make-point symbols-of constants-of random-numbers completed
         exact-decimal loose-decimal
         value-of-terms)

;; numbers : symbol -> rational or interval, as a hash
;; which : which stand-ins the literal functions have
(define (make-point numbers which [decimal exact-decimal])
  (point (lambda (s) (hash-ref numbers s #f))
         (lambda (name orders args A) (value-of-terms (stand-in* name which orders) args A))
         decimal))

;; ---------------------------------------------------------------------------
;; Decimals: as the binary fraction that is stored, or anything near it

(define (exact-decimal x A) (inexact->exact x))

(define ((loose-decimal slack) x A)
  (define q (inexact->exact x))
  (define d (* (abs q) slack))
  (if (and (integer? q) (< (abs q) 100))
      q
      ((arithmetic-join A) ((arithmetic-from A) (- q d)) ((arithmetic-from A) (+ q d)))))

;; ---------------------------------------------------------------------------
;; Values of polynomials

(define known-stand-ins (make-hash))
(define (stand-in* name which orders)
  (define key (list name which orders))
  (or (hash-ref known-stand-ins key #f)
      (let ([terms (stand-in name which orders)])
        (hash-set! known-stand-ins key terms)
        terms)))

(define (value-of-terms terms args A)
  (for/fold ([sum 0]) ([t (in-list terms)])
    (add A sum
         (for/fold ([p (term-coefficient t)]) ([x (in-list args)] [n (in-list (term-exponents t))])
           (multiply A p (integer-power A x n))))))

;; ---------------------------------------------------------------------------
;; Symbols and numbers for them

;; Symbols of several S-expressions, without heads; :pi is a number.
(define (symbols-of . es)
  (define found (make-hasheq))
  (let walk ([e es])
    (cond [(eq? e ':pi) (void)]
          [(symbol? e) (hash-set! found e #t)]
          [(pair? e) (for-each walk (if (eq? e es) e (cdr e)))]))
  (sort (hash-keys found) symbol<?))

(define magnitudes
  '#(1/2 3/5 7/4 2 3 1/8 11/3 9/2 5/4 1/3 7/8 13/8 1/50 10 1 25/2 99/100 101/100 1/1000 1000))

;; Sizes of the numbers in S-expressions that stand out, exact.
(define (constants-of . es)
  (define found (make-hasheqv))
  (let walk ([e es])
    (cond [(pair? e) (for-each walk e)]
          [(and (real? e) (rational? e))
           (define size (abs (inexact->exact e)))
           (unless (<= 1/50 size 25/2) (hash-set! found size #t))]))
  (sort (remv 0 (hash-keys found)) <))

;; The first ones mostly moderate; those of even k may be negative.
;; constants : sizes near which some are to be
(define (random-numbers symbols k [constants '()])
  (define range (cond [(< k 30) 12] [(< k 80) 16] [else (vector-length magnitudes)]))
  (for/hasheq ([s (in-list symbols)])
    (define m (vector-ref magnitudes (random range)))
    (define x
      (cond [(zero? (random 3)) (/ (+ (random 64) 1) 16)]
            [(and (pair? constants) (zero? (random 2)))
             (* m (list-ref constants (random (length constants))))]
            [else m]))
    (values s (if (and (even? k) (zero? (random 2))) (- x) x))))

;; The numbers of the hint, and random ones for the other symbols.
(define (completed hint symbols [k 1] [constants '()])
  (for/fold ([all (random-numbers symbols k constants)]) ([(s x) (in-hash hint)])
    (hash-set all s x)))
