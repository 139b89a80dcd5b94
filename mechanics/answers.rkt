#lang racket/base
;; What a student's file or notebook requires: holes, and what checks the answers.

(require "error/uncompiled.rkt")
(tell-if-uncompiled)

(require "teaching/worksheet/answer-data.rkt" "teaching/worksheet/cell-check.rkt"
         "teaching/worksheet/check-answers.rkt")

(provide unanswered check-answers exercises check)
