#lang racket/base
;; Text whose characters all have a shape: one that a terminal would obey, or end a line at, is
;; shown as the character that stands for the unknown.

(provide visible)

(define (visible text) (regexp-replace* #px"\\p{C}|[\u2028\u2029]" text "\uFFFD"))
