#lang info
(define name "mechanics manual")
(define scribblings '(("mechanics.scrbl" (multi-page))))
