#lang racket/base
;; Presenting a normal form as an expression that stays as it is.

(require "argument-alignment.rkt" "normalize.rkt"
         "../expression/expression.rkt" "../expression/operation.rkt"
         "../field/field.rkt"
         "../kernel/find-kernels.rkt" "../kernel/kernel.rkt"
         "../presentation/present.rkt")

(provide settle)

;; What a normal form is presented as.  Which angles are basic depends on those
;; that occur, and so do the degrees of roots and what stands under them; a result in
;; others is simplified again until it stays as it is or is one that came before: the
;; least of those that keep coming back.
(define (settle form s)
  (let loop ([form form] [seen '()])
    (define e (present (normal-field form) (normal-fraction form)))
    (define cycle (member e (reverse seen)))
    (cond [cycle (least-expression cycle)]
          [(or (not (node? e)) (settled? (normal-field form) e s)) e]
          [(= (length seen) settle-limit) (least-expression (cons e seen))]
          [else (loop (normalize e s) (cons e seen))])))

(define settle-limit 4)

;; Would e, presented from this field, come out again?  Flonums are rounded when they are
;; shown, so that what they have in common may change; one that multiplies all has nothing in
;; common with another.
(define (settled? F e s)
  (and (or (not (field-inexact? F)) (flonum-in-front? e))
       (or (not (or (atlas-dependent? (field-atlas F))
                    (new-roots? F e)
                    (new-angles? F e)))
           (same-field? F e s))))

;; Would e be simplified in this very field?
(define (same-field? F e s)
  (define known
    (for/hash ([k (in-vector (field-kernels F))]) (values (kernel-expression k) #t)))
  (define (known? e) (hash-ref known e #f))
  (define atlas (collect-kernels e s))
  (define kernels (atlas-kernels atlas))
  (and (= (length kernels) (hash-count known))
       (for/and ([k (in-list kernels)]) (known? (kernel-expression k)))
       (same-circles? (atlas-doubled atlas) (atlas-doubled (field-atlas F)))))

(define (same-circles? as bs)
  (define (expressions os) (for/hash ([o (in-list os)]) (values (circle-expression o) #t)))
  (equal? (expressions as) (expressions bs)))

;; Has presentation put angles together that did not occur?
(define (new-angles? F e)
  (define known
    (for/hash ([k (in-vector (field-kernels F))] #:when (circle? (kernel-relation k)))
      (values (circle-expression (kernel-relation k)) #t)))
  (define memo (make-memo))
  (define (new? e)
    (and (node? e) (memo e (lambda () (new-node? e)))))
  (define (new-node? n)
    (cond [(memq (node-head n) (list op:+ op:- op:* op:/ op:expt))
           (ormap new? (node-args n))]
          [(memq (node-head n) (list op:sin op:cos op:sinh op:cosh))
           (not (hash-ref known (car (node-args n)) #f))]
          [else #f]))
  (and (positive? (hash-count known)) (new? e)))

;; Does e show a root that is no kernel of F, as one of another degree or radicand?
(define (new-roots? F e)
  (define known
    (for/hash ([k (in-vector (field-kernels F))] #:when (root? (kernel-relation k)))
      (values (kernel-expression k) #t)))
  (define memo (make-memo))
  (define (new? e)
    (and (node? e)
         (memo e (lambda () (or (and (lone-root? e) (not (hash-ref known (root-of e) #f)))
                                (ormap new? (node-args e)))))))
  (and (pair? (atlas-tower (field-atlas F))) (new? e)))

(define (lone-root? n)
  (or (eq? (node-head n) op:sqrt)
      (and (eq? (node-head n) op:expt)
           (rational? (cadr (node-args n)))
           (not (integer? (cadr (node-args n)))))))

;; The root that the node is a power of.
(define (root-of n)
  (define degree (if (eq? (node-head n) op:sqrt) 2 (denominator (cadr (node-args n)))))
  (define u (car (node-args n)))
  (if (eqv? degree 2) (make-node op:sqrt (list u)) (make-node op:expt (list u (/ 1 degree)))))

;; Is at most one flonum in e, as a factor of the whole?  A whole one is an integer when it is
;; read again, which has common factors with others.
(define (flonum-in-front? e)
  (define exact? (exactness))
  (define (in-front? e)
    (cond [(and (node? e) (eq? (node-head e) op:/))
           (and (in-front? (car (node-args e))) (andmap exact? (cdr (node-args e))))]
          [(and (node? e) (eq? (node-head e) op:*))
           (and (factor? (car (node-args e))) (andmap exact? (cdr (node-args e))))]
          [else (or (factor? e) (exact? e))]))
  (define (factor? e) (and (real? e) (not (and (flonum? e) (integer? e)))))
  (in-front? e))

;; -> expression -> is there no flonum in it?  Shared parts are looked at once.
(define (exactness)
  (define memo (make-memo))
  (define (exact-expression? e)
    (cond [(number? e) (exact? e)]
          [(node? e) (memo e (lambda () (andmap exact-expression? (node-args e))))]
          [else #t]))
  exact-expression?)
