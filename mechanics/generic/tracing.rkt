#lang racket/base
;; Tests of values that are not known yet.
;;
;; A function is *traced* by running it on placeholders: nobody knows yet which
;; number a placeholder will be, so a test of it has no answer.  Every test of ours
;; calls `look-inside` first, which ends the trace; where nothing is traced, it
;; does nothing.

(require "describe.rkt"
         "../algebra/expression/expression.rkt")

(provide call-traced being-traced? look-inside make-placeholder open-value? open-leaf?)

;; #f, or a procedure for the name of the test
(define current-escape (make-parameter #f))

;; The value of (f), or (escape name) when f looks inside a placeholder by the
;; test of that name.
(define (call-traced f escape)
  (define reason
    (let/ec leave
      (parameterize ([current-escape leave])
        (box (f)))))
  (if (box? reason) (unbox reason) (escape reason)))

(define (being-traced?) (and (current-escape) #t))

(define (look-inside name)
  (define leave (current-escape))
  (when leave (leave name)))

;; A placeholder is a symbol that no program can write, for the algebra a symbol
;; like others.
(define (make-placeholder name) (string->uninterned-symbol name))

;; Does x hold a placeholder, or an expression that may?
(define (open-value? x)
  (let/ec return
    (map-leaves (lambda (leaf) (when (open-leaf? leaf) (return #t))) x)
    #f))

(define (open-leaf? x)
  (or (node? x)
      (and (symbol? x) (not (symbol-interned? x)))))
