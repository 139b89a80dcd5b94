#lang racket/base
;; Formulas written as in print, 2x or x^2 or m*v, which Racket reads as one name, in prefix form.
;;
;; Loosest first, a formula is a sum, a quotient, a product, a number before a name, a power.
;; A hyphen is part of many names: a difference is a letter less a number.

(provide typed-formula)

;; name : symbol -> text such as (expt x 2), or #f if it is no formula
(define (typed-formula name)
  (define text (with-powers (symbol->string name)))
  (and (not (number-or-name? text)) (formula text)))

;; x² and x**2 as x^2
(define (with-powers text)
  (regexp-replaces text '([#rx"³" "^3"] [#rx"²" "^2"] [#rx"[*][*]" "^"])))

(define (formula text)
  (or (and (degrees? text) "(/ pi 180)")
      (number-or-name? text)
      (for/or ([way (in-list ways)]) (way text))))

;; "x" -> "x"; "x^0" -> #f
(define (number-or-name? text)
  (and (or (real-text? text)
           (regexp-match? #px"^\\p{L}(?:\\p{L}|[0-9_'-])*$" text))
       (not (regexp-match? difference text))
       text))

(define (degrees? text) (and (member text '("deg" "degree" "degrees" "°")) #t))

(define difference #px"^(\\p{L})-([0-9.]+)$")

(define (real-text? text)
  (and (regexp-match? #px"^[0-9.]+$" text) (string->number text) #t))

;; text -> the operation on its two operands, or #f
(define ((splitting pattern name) text)
  (define found (regexp-match pattern text))
  (define left (and found (formula (cadr found))))
  (define right (and left (formula (caddr found))))
  (and right (format "(~a ~a ~a)" name left right)))

;; -x and -3x
(define (negative text)
  (define found (regexp-match #px"^-((?:[0-9.]*)\\p{L}.*)$" text))
  (define positive (and found (formula (cadr found))))
  (and positive (format "(- ~a)" positive)))

(define ways
  (list (splitting #px"^(.+)\\+(.+)$" "+")
        (splitting difference "-")
        negative
        (splitting #px"^(.+)/(.+)$" "/")
        (splitting #px"^(.+)\\*(.+)$" "*")
        (splitting #px"^([0-9.]+)((?:\\p{L}|°).*)$" "*")
        (splitting #px"^([^^]+)\\^(.+)$" "expt")))
