#lang racket/base
;; Formulas as other programs and TeX spell them, in the signs of people: \frac{p^2}{2 m},
;; Sqrt[l/g] and np.sqrt(l/g) become ((p^2)/(2 m)), sqrt(l/g) and sqrt(l/g).
;;
;; Each spelling is an entry of a table.  What no entry knows stays, and no token begins with it.

(require (only-in "name.rkt" Greek-name?) (only-in "one-line-name.rkt" raised-text))

(provide plain-spelling)

(define (plain-spelling text)
  (respelled (if (regexp-match? #rx"[\\\\{]" text) (without-TeX text) text) of-programs))

;; The entries are applied until nothing changes, so that nested braces open from within.
(define (respelled text table)
  (define next
    (for/fold ([text text]) ([entry (in-list table)])
      (regexp-replace* (car entry) text (cadr entry))))
  (if (equal? next text) text (respelled next table)))

;; ---------------------------------------------------------------------------
;; Programs

(define of-programs
  `((#px"(?<!(?:\\p{L}|[.]))(?:np|numpy|math|Math|cmath|sp|sympy)[.](?=\\p{L})" "")
    (#rx"%pi" "π") (#rx"%e" "E")
    (#rx"[.]([*/^])" "\\1")
    (#rx"(<|>|:|=)=" "\\1\u0338") (#rx"<\u0338" "≤") (#rx">\u0338" "≥") (#rx"[:=]\u0338" "=")
    (#rx"[–—‐]" "-")
    (#px"([0-9.])\\s*×\\s*10(?:\\^\\(?(-?[0-9]+)\\)?)" "\\1e\\2")
    (#px"([0-9.])\\*\\^(-?[0-9]+)" "\\1e\\2")
    (#px"(?<!\\p{L})([A-Z]\\p{L}*|\\p{L}+['′]+)\\[([^][]*)\\]" "\\1(\\2)")
    (#px"[|]([^|]+)[|]" "abs(\\1)")
    (#px"(\\p{L}(?:\\p{L}|[0-9_])*)(['′]+)"
     ,(lambda (all name primes)
        (string-append "D" (raised-text (number->string (string-length primes))) name)))
    (#px"^\\s*[+](?=\\S)" "")))

;; ---------------------------------------------------------------------------
;; TeX

(define (without-TeX text)
  (respelled (spaced-letters text) of-TeX))

;; Letters in a row are factors, mv those of a product, but for commands and subscripts.
(define (spaced-letters text)
  (regexp-replace* #px"[_\\\\]?\\p{L}+" text
                   (lambda (found)
                     (if (or (regexp-match? #px"^[_\\\\]" found) (= 1 (string-length found)))
                         found
                         (regexp-replace* #rx"(.)(?=.)" found "\\1 ")))))

(define of-TeX
  `((#px"\\\\(?:left|right|[bB]igg?[lr]?)(?![a-zA-Z])" "")
    (#px"\\\\(?:[,;:! ]|q?quad(?![a-zA-Z]))|~" " ")
    (#px"\\\\(?:var)?([a-zA-Z]+)"
     ,(lambda (command name) (if (Greek-name? name) (string-append " " name) command)))
    (#px"\\\\[dt]?frac\\s*\\{\\s*d(?!\\p{L})[^{}]*\\}\\s*\\{\\s*d(?!\\p{L})[^{}]*\\}" "∂")
    (#px"\\\\hbar(?![a-zA-Z])" " hbar")
    (#px"\\\\cdot(?![a-zA-Z])" "·") (#px"\\\\times(?![a-zA-Z])" "×")
    (#px"\\\\(arcsin|arccos|arctan|sinh|cosh|tanh|sin|cos|tan|exp|log|ln)(?![a-zA-Z])" " \\1")
    (#px"\\\\[dt]?frac\\s*([0-9])\\s*([0-9])" "(\\1/\\2)")
    (#px"_\\s*\\{\\s*((?:\\p{L}|[0-9])+)\\s*\\}" "_\\1")
    (#px"\\\\dot\\s*\\{\\s*(\\p{L}+)\\s*\\}" "\\1\u0307")
    (#px"\\\\ddot\\s*\\{\\s*(\\p{L}+)\\s*\\}" "\\1\u0308")
    (#px"\\^\\s*\\{([^{}]*)\\}" "^(\\1)")
    (#px"\\\\sqrt\\s*\\{([^{}]*)\\}" "sqrt(\\1)")
    (#px"\\\\[dt]?frac\\s*\\{([^{}]*)\\}\\s*\\{([^{}]*)\\}" "((\\1)/(\\2))")))
