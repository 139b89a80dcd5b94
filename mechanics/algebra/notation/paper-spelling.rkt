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
  `((#px"^\\s*([$]+)([^$]*)\\1\\s*$" "\\2")
    (#px"(?<![(0-9.])([0-9.]+)\\s*(?:°|deg(?:rees?)?(?!\\p{L}))" "(\\1 °)")
    (#px"(?<!(?:\\p{L}|[.]))(?:np|numpy|math|Math|cmath|sp|sympy)[.](?=\\p{L})" "")
    (#rx"%pi" "π") (#rx"%e" "E")
    (#rx"[.]([*/^])" "\\1")
    (#rx"(<|>|:|=)=" "\\1\u0338") (#rx"<\u0338" "≤") (#rx">\u0338" "≥") (#rx"[:=]\u0338" "=")
    (#rx"[–—‐]" "-")
    (#px"([0-9.])\\s*×\\s*10(?:\\^\\(?(-?[0-9]+)\\)?)" "\\1e\\2")
    (#px"([0-9.])\\*\\^(-?[0-9]+)" "\\1e\\2")
    (#px"(?<!\\p{L})([A-Z]\\p{L}*|\\p{L}+['′]+)\\[([^][]*)\\]" "\\1(\\2)")
    (#px"[|]([^|]+)[|]" "abs(\\1)")
    ;; x' and x'' are rates, unless called, x'(t); but x' * y may be Matlab's.
    (#px"(?<!\\p{L}|_)(\\p{L}+)['′]['′](?!['′]|\\s*[(]|\\p{L}|[0-9])" "\\1\u0308")
    (#px"(?<!\\p{L}|_)(\\p{L}+)['′](?!['′]|\\s*[(*]|\\p{L}|[0-9])" "\\1\u0307")
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

;; The name behind a backslash: alpha, thetadot, and alphax, which lacks a space; or #f
(define (Greek-factors name)
  (define ends
    (for/list ([n (in-range 2 (+ 1 (string-length name)))]
               #:when (Greek-name? (substring name 0 n)))
      n))
  (define end (and (pair? ends) (apply max ends)))
  (define rest (and end (substring name end)))
  (cond [(not end) #f]
        [(regexp-match? #rx"^(dot)*$" rest) (string-append " " name)]
        [(<= (string-length rest) 2)
         (string-append " " (substring name 0 end) " " (spaced-letters rest))]
        [else #f]))

(define of-TeX
  `((#px"\\\\(?:left|right|[bB]igg?[lr]?)(?![a-zA-Z])" "")
    (#px"\\\\(?:[,;:! ]|q?quad(?![a-zA-Z]))|~" " ")
    (#px"\\\\(d?dot)(?:\\s*(\\\\[a-zA-Z]+)|\\s+(\\p{L}))"
     ,(lambda (all dots command letter) (format "\\~a{~a}" dots (or command letter))))
    (#px"\\\\(?:var)?([a-zA-Z]+)" ,(lambda (command name) (or (Greek-factors name) command)))
    (#px"\\\\[dt]?frac\\s*\\{\\s*d(?!\\p{L})[^{}]*\\}\\s*\\{\\s*d(?!\\p{L})[^{}]*\\}" "∂")
    (#px"\\\\hbar(?![a-zA-Z])" " hbar")
    (#px"\\\\cdot(?![a-zA-Z])" "·") (#px"\\\\times(?![a-zA-Z])" "×")
    (#px"\\\\(arcsin|arccos|arctan|sinh|cosh|tanh|sin|cos|tan|exp|log|ln)(?![a-zA-Z])" " \\1")
    (#px"\\\\(sin|cos|tan|exp|ln)([a-zA-Z])(?![a-zA-Z])" " \\1 \\2")
    (#px"\\\\[dt]?frac\\s*([0-9])\\s*([0-9])(?![0-9.])" " (\\1/\\2) ")
    (#px"(\\\\[dt]?frac)(?:\\s*(?=[0-9])|\\s+)([0-9a-zA-Z])(?![0-9.])" "\\1{\\2}")
    (#px"(\\\\[dt]?frac\\s*\\{[^{}]*\\})\\s*([0-9a-zA-Z])(?![0-9.])" "\\1{\\2} ")
    (#px"\\\\sqrt(?:\\s*(?=[0-9])|\\s+)([0-9a-zA-Z])(?![0-9a-zA-Z.])" "sqrt(\\1)")
    (#px"_\\s*\\{\\s*((?:\\p{L}|[0-9])+)\\s*\\}" "_\\1")
    (#px"\\\\dot\\s*\\{\\s*(\\p{L}+)\\s*\\}" "\\1\u0307")
    (#px"\\\\ddot\\s*\\{\\s*(\\p{L}+)\\s*\\}" "\\1\u0308")
    (#px"\\^\\s*\\{([^{}]*)\\}" "^(\\1)")
    (#px"\\\\sqrt\\s*\\{([^{}]*)\\}" "sqrt(\\1)")
    (#px"\\\\[dt]?frac\\s*\\{([^{}]*)\\}\\s*\\{([^{}]*)\\}" "((\\1)/(\\2))")))
