#lang racket/base
;; Results that a reader moves, which a prompt shows in a window.  The property marks them, so that
;; a prompt need not load their makers to know that it has none.

(provide prop:live live?)

(define-values (prop:live live? live-ref) (make-struct-type-property 'live))
