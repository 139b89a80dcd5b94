#lang racket/base
;; Circles: basic angles, and the combinations of them that presentation asks for;
;; and other kernels it makes up.
;;
;; An angle is known up to its sign: of u and -u the one with a positive leading
;; term has the circle.

(require "kernel.rkt"
         "../expression/expression.rkt" "../expression/operation.rkt"
         "../expression/simplifier.rkt")

(provide signed-angle make-circle make-circles combine-circles! whole-kernel!)

;; (make u) with 1, or (make -u) with -1 if u has a negative leading
;; term.
(define (signed-angle s u make)
  (define simple (simplifier-simplify s u))
  (define leading
    (if (number? simple) simple (caar (simplifier-terms s simple))))
  (if (and (real? leading) (negative? leading))
      (cons (make (simplifier-simplify s (e:negate simple))) -1)
      (cons (make simple) 1)))

;; intern : expression relation -> kernel
(define (make-circle u sign intern)
  (define o (circle u sign #f #f))
  (define circular? (eqv? sign 1))
  (define (of op) (make-node op (list u)))
  (set-circle-sine! o (intern (of (if circular? op:sin op:sinh)) o))
  (set-circle-cosine! o (intern (of (if circular? op:cos op:cosh)) #f))
  o)

;; ---------------------------------------------------------------------------
;; Circles by their angles, with all kernels by rank

;; known : (sign . angle) -> circle        wholes : expression -> kernel taken as a whole
(struct circles (known wholes simplifier [ranked #:mutable]) #:authentic)

(define (make-circles kernels s)
  (define cs
    (circles (make-hash) (make-hash) s
             (sort (vector->list kernels) < #:key kernel-rank)))
  (for ([k (in-vector kernels)] #:when (circle? (kernel-relation k)))
    (define o (kernel-relation k))
    (hash-set! (circles-known cs) (cons (circle-sign o) (circle-expression o)) o))
  cs)

;; The circle of a linear combination ((circle . integer) ...) of angles of one
;; sign, not empty, and ±1.
(define (combine-circles! cs multiples)
  (define sign (circle-sign (caar multiples)))
  (define u
    (sum-of-terms (for/list ([m (in-list multiples)]) (cons (cdr m) (circle-expression (car m))))))
  (define (make u) (make-circle u sign (lambda (e o) (add-kernel! cs e o))))
  (signed-angle (circles-simplifier cs) u
                (lambda (u) (hash-ref! (circles-known cs) (cons sign u) (lambda () (make u))))))

;; The kernel of an expression that presentation takes as a whole.
(define (whole-kernel! cs e relation)
  (hash-ref! (circles-wholes cs) e (lambda () (add-kernel! cs e relation))))

(define (add-kernel! cs expression relation)
  (define k (make-kernel expression relation))
  (set-circles-ranked! cs (insert-kernel! k (circles-ranked cs)))
  k)
