#lang racket/base
;; What is wrong with a claim.

(provide (struct-out fault))

;; kind : a symbol that says what is wrong; numbers : symbol -> rational, or #f
;; left, right : values there, or #f
(struct fault (kind numbers left right) #:prefab)
