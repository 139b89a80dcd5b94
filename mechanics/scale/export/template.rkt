#lang racket/base
;; Files that are the same for all systems but for a few words, written @WORD@ in them.

(require racket/file)

(provide fill-template)

;; words : hash, from the words without their signs to texts
(define (fill-template file words)
  (regexp-replace* #px"@([A-Z_]+)@" (file->string file)
                   (lambda (all word) (hash-ref words word))))
