#lang racket/base
;; Presenting a normal form as an expression that stays as it is.

(require "argument-alignment.rkt" "normalize.rkt"
         "../expression/expression.rkt" "../expression/nodes.rkt"
         "../expression/operation.rkt"
         "../field/field.rkt"
         "../kernel/find-kernels.rkt" "../kernel/kernel.rkt"
         "../presentation/present.rkt")

(provide settle)

;; The expression for a normal form.  Which angles are basic depends on those
;; that occur, and so do the degrees of roots and their radicands; a result in
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
;; shown, so that their common factor may change; one that multiplies all has none in
;; common with another.
(define (settled? F e s)
  (and (or (not (field-inexact? F)) (flonum-in-front? e))
       (or (not (or (atlas-dependent? (field-atlas F))
                    (new-roots? F e)
                    (new-angles? F e)))
           (same-field? F e s))))

;; Would e be simplified in this very field?
(define (same-field? F e s)
  (define atlas (collect-kernels e s))
  (and (equal? (kernel-expressions (atlas-kernels atlas)) (kernel-expressions (field-kernels F)))
       (same-circles? (atlas-doubled atlas) (atlas-doubled (field-atlas F)))))

(define (same-circles? as bs)
  (define (expressions os) (for/hash ([o (in-list os)]) (values (circle-expression o) #t)))
  (equal? (expressions as) (expressions bs)))

;; Has presentation put angles together that did not occur?
(define (new-angles? F e)
  (define known
    (for/hash ([k (in-vector (field-kernels F))] #:when (circle? (kernel-relation k)))
      (values (circle-expression (kernel-relation k)) #t)))
  (define (new? n parts)
    (cond [(memq (node-head n) (list op:+ op:- op:* op:/ op:expt)) (ormap values parts)]
          [(memq (node-head n) (list op:sin op:cos op:sinh op:cosh))
           (not (hash-ref known (car (node-args n)) #f))]
          [else #f]))
  (and (positive? (hash-count known)) (node-fold e (lambda (leaf) #f) new?)))

;; Does e show a root that is no kernel of F, as one of another degree or radicand?
(define (new-roots? F e)
  (define known (kernel-expressions (field-kernels F)))
  (define (new? n)
    (define root (root-of n))
    (and root (not (hash-ref known root #f))))
  (and (pair? (atlas-tower (field-atlas F))) (some-node? new? e)))

;; The root that the node is a power of, or #f.
(define (root-of n)
  (define u (car (node-args n)))
  (define k
    (cond [(headed? n op:sqrt) 1/2]
          [(headed? n op:expt) (cadr (node-args n))]
          [else #f]))
  (cond [(or (not (rational? k)) (integer? k)) #f]
        [(eqv? 2 (denominator k)) (make-node op:sqrt (list u))]
        [else (make-node op:expt (list u (/ 1 (denominator k))))]))

;; Is at most one flonum in e, as a factor of the whole?  A whole one is an integer when it is
;; read again, which has common factors with others.
(define (flonum-in-front? e)
  (define (first-in-front? in-front?)
    (and (in-front? (car (node-args e))) (andmap exact-expression? (cdr (node-args e)))))
  (define (factor? e) (and (real? e) (not (and (flonum? e) (integer? e)))))
  (cond [(headed? e op:/) (first-in-front? flonum-in-front?)]
        [(headed? e op:*) (first-in-front? factor?)]
        [else (or (factor? e) (exact-expression? e))]))

(define (exact-expression? e)
  (all-leaves? (lambda (leaf) (or (symbol? leaf) (exact? leaf))) e))
