#lang racket/base
;; Where the book treats what an entry is about.

(require scribble/base)

(provide the-book sicm fdg)

(define the-book
  (list (italic "Structure and Interpretation of Classical Mechanics")
        ", second edition, by Gerald Jay Sussman and Jack Wisdom"))

;; @sicm{1.5, p. 33}
(define (sicm . place)
  (elem (smaller "SICM " place)))

;; @fdg{chapter 11}: its sequel, Functional Differential Geometry (MIT Press, 2013)
(define (fdg . place)
  (elem (smaller "FDG " place)))
