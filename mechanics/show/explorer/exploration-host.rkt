#lang racket/base
;; Where maps are explored: in a window, unless a host has a way of its own, as a notebook has.

(provide current-exploration-host)

;; #f, or a procedure as explore-in-window (explore-in-window.rkt), which need not wait
(define current-exploration-host (make-parameter #f))
