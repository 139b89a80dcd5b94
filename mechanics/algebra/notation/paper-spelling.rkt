#lang racket/base
;; Formulas as other programs spell them, in the signs that handwritten-tokens.rkt knows: Sqrt[l/g]
;; and np.sqrt(l/g) become sqrt(l/g); and TeX with a space forgotten, \alphax and \sinx.
;;
;; Each spelling is an entry of a table.  Other text stays, and no token begins with it.

(require (only-in "name.rkt" Greek-name?))

(provide plain-spelling)

(define (plain-spelling text)
  (respelled (if (regexp-match? #rx"[\\\\{]" text) (with-spaces text) text)))

;; The entries are applied until nothing changes, so that nested brackets open from within.
(define (respelled text)
  (define next
    (for/fold ([text text]) ([entry (in-list of-programs)])
      (regexp-replace* (car entry) text (cadr entry))))
  (if (equal? next text) text (respelled next)))

(define of-programs
  `((#px"^\\s*([$]+)([^$]*)\\1\\s*$" "\\2")
    (#px"(?<![(0-9.])([0-9.]+)\\s*(?:°|deg(?:rees?)?(?!\\p{L}))" "(\\1 (π/180))")
    (#px"°|(?<!\\p{L})deg(?:rees?)?(?!\\p{L})" "(π/180)")
    (#px"(?<!(?:\\p{L}|[.]))(?:np|numpy|math|Math|cmath|sp|sympy)[.](?=\\p{L})" "")
    (#rx"%pi" "π") (#rx"%e" "E")
    (#rx"[.]([*/^])" "\\1")
    (#rx"<=" "≤") (#rx">=" "≥")
    (#px"([0-9.])\\s*×\\s*10(?:\\^\\(?(-?[0-9]+)\\)?)" "\\1e\\2")
    (#px"([0-9.])\\*\\^(-?[0-9]+)" "\\1e\\2")
    (#px"(?<!\\p{L})([A-Z]\\p{L}*|\\p{L}+['′]+)\\[([^][]*)\\]" "\\1(\\2)")
    (#px"^\\s*[+](?=\\S)" "")))

;; ---------------------------------------------------------------------------
;; TeX

;; Letters in a row are factors, mv those of a product, but for commands and subscripts.
(define (with-spaces text)
  (regexp-replace* #px"[_\\\\]?\\p{L}+" text
                   (lambda (found)
                     (cond [(regexp-match? #rx"^_" found) found]
                           [(regexp-match? #rx"^\\\\" found) (spaced-command found)]
                           [else (spaced found)]))))

(define (spaced letters) (regexp-replace* #rx"(.)(?=.)" letters "\\1 "))

;; \alphax, \omegat, \sinx -> \alpha x, \omega t, \sin x
(define (spaced-command found)
  (define ends
    (for/list ([n (in-range (string-length found) 2 -1)]
               #:when (command? (substring found 1 n)))
      n))
  (define rest (if (pair? ends) (substring found (car ends)) ""))
  (if (<= 1 (string-length rest) 2)
      (string-append (substring found 0 (car ends)) " " (spaced rest))
      found))

(define (command? name)
  (or (Greek-name? name) (and (member name '("sin" "cos" "tan" "exp" "ln")) #t)))
