#lang racket/base
;; The multiples of π the book names.

(provide pi :pi :-pi :pi/2 :2pi)

(define pi 3.141592653589793)
(define :pi pi)
(define :-pi (- pi))
(define :pi/2 (/ pi 2))
(define :2pi (* 2 pi))
