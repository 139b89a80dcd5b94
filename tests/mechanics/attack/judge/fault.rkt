#lang racket/base
;; Faults of claims.

(provide (struct-out fault))

;; kind : a symbol that says what is wrong; numbers : symbol -> rational, or #f
;; left, right : values there, or #f
(struct fault (kind numbers left right) #:prefab)
