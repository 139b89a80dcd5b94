#lang racket/base
;; `#lang mechanics/worksheet`: the teacher's file of a worksheet; all of mechanics, and the
;; forms of worksheets.

(require "error/uncompiled.rkt")
(tell-if-uncompiled)

(require (except-in "main.rkt" #%module-begin)
         "lang/worksheet-forms.rkt")

(provide (all-from-out "main.rkt" "lang/worksheet-forms.rkt"))

(module reader syntax/module-reader
  mechanics/worksheet
  #:wrapper1 (lambda (read) (tell-of-stale-files) (read))
  (require "error/stale-files.rkt"))

(module configure-runtime racket/base
  (require "lang/runtime.rkt"))
