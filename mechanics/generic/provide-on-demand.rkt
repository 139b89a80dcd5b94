#lang racket/base
;; Rooms that are loaded when something of theirs is first called.
;;
;;     (provide-on-demand ["file.rkt" name ...] ...)
;;
;; provides the names, procedures all, and requires a file when one of its is called.  A
;; procedure with keywords is to be made by `define-plain` (define-plain.rkt says why).

(require racket/lazy-require)

(provide provide-on-demand)

(define-syntax-rule (provide-on-demand [file name ...] ...)
  (begin
    (lazy-require [file (name ...)] ...)
    (provide name ... ...)))
