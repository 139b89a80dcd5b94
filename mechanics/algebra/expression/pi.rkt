#lang racket/base
;; π, exactly: the symbol :pi.
;;
;; The flonum pi is a rational number whose sine is not 0.  Exact results hold the
;; symbol :pi in its place, a name that the language gives the flonum, so that it is read as
;; it is printed: quoted, as other symbols are, it is π itself.  The symbol pi remains free
;; for whoever wants it.  The book's other names are quoted in the same way, and simplify to
;; multiples: ':2pi to (* 2 :pi).
;;
;; π is a leaf, and to polynomials a variable.  Nothing is lost by that, for π is
;; transcendental: a polynomial in it with algebraic coefficients is 0 only if all of these
;; are.  Sines and cosines know it where it is a term of an angle (kernel/turns.rkt).  To all
;; else it is a number: it has a sign and digits, no value is chosen for it, and it does not
;; count among the symbols of an expression (symbols.rkt).

(require "../../numeric/constants.rkt")

(provide exact-pi pi-symbol? pi-multiple pi-alias? pi-flonum pi-digits)

(define exact-pi ':pi)

;; The rational multiple of π that the symbol s stands for, or #f.
(define (pi-multiple s)
  (case s
    [(:pi) 1]
    [(:2pi) 2]
    [(:pi/2) 1/2]
    [(:-pi) -1]
    [else #f]))

(define (pi-symbol? x) (and (pi-multiple x) #t))

;; Is it one of the names that stand for multiples of :pi?
(define (pi-alias? s) (and (memq s '(:2pi :pi/2 :-pi)) #t))

;; The flonum nearest to the symbol's value: π doubled or halved is rounded as π is.
(define (pi-flonum s) (* (pi-multiple s) pi))

;; π to 50 digits, rounded down; the error is less than 10^-50.
(define pi-digits (/ 314159265358979323846264338327950288419716939937510 (expt 10 50)))
