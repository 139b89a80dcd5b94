#lang racket/base
;; The library of a student's file or notebook: holes, and the check of answers.

(require "error/uncompiled.rkt")
(tell-if-uncompiled)

(require "teaching/worksheet/answer-data.rkt" "teaching/worksheet/cell-check.rkt"
         "teaching/worksheet/check-answers.rkt")

(provide unanswered check-answers exercises check)
