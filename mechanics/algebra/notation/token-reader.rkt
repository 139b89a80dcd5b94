#lang racket/base
;; The tokens of a formula, taken one after the other by a grammar.

(require "formula-tokens.rkt")

(provide (struct-out reader) ahead ahead? glued? take! accept! expect! unexpected)

;; left : the tokens not yet read, the last of kind 'end; refuse : token -> does not return
(struct reader ([left #:mutable] refuse) #:authentic)

(define (ahead in) (car (reader-left in)))
(define (ahead? in . kinds) (and (memq (token-kind (ahead in)) kinds) #t))
(define (glued? in . kinds) (and (apply ahead? in kinds) (not (token-spaced? (ahead in)))))

(define (take! in)
  (define t (ahead in))
  (set-reader-left! in (cdr (reader-left in)))
  t)

;; The token ahead, taken if it is of the kind; else #f, or a complaint
(define (accept! in kind) (and (ahead? in kind) (take! in)))
(define (expect! in kind) (or (accept! in kind) (unexpected in)))

(define (unexpected in) ((reader-refuse in) (ahead in)))
