#lang racket/base
;; Names as a physics book writes them.
;;
;;     theta_1   θ with the subscript 1          v^x_r   v with the superscript x, subscript r
;;     thetadot  θ with a dot, xdotdot two       omega0  ω with the subscript 0
;;
;; A name with other characters than letters and digits stands as it is.

(require "../expression/pi.rkt")

(provide name-parts dotted-parts (struct-out parts) subscripts superscripts letter->greek
         Greek-name? letter inverse)

;; base : the name shown, its Greek letters as letters
;; sort : 'letter, 'capital (Greek), 'word of several letters, or 'odd
;; dots : how many; digits : those after the base, "" mostly
;; marks: ((#\_ . text) or (#\^ . text) ...)
(struct parts (base sort dots digits marks) #:transparent)

(define (name-parts symbol)
  (define text (symbol->string symbol))
  (cond [(eq? symbol exact-pi) (parts "π" 'letter 0 "" '())]
        [(regexp-match whole-name text)
         => (lambda (m) (regular (cadr m) (caddr m) (cadddr m)))]
        [else (parts text 'odd 0 "" '())]))

;; The same with so many dots, which stand over the letter alone: those of p_x over the p.
(define (dotted-parts symbol dots) (struct-copy parts (name-parts symbol) [dots dots]))

(define letter "(?:\\p{Lu}|\\p{Ll}|\\p{Lt}|\\p{Lo})")          ; a regular expression

(define whole-name
  (let ([mark (format "[_^](?:~a|\\p{Nd})+" letter)])
    (pregexp (format "^(~a+(?:-~a+)*|[∇£])(\\p{Nd}*)((?:~a)*)$" letter letter mark))))

(define one-mark #px"[_^][^_^]+")

;; Texts below and above the line; digits at the end of a name stand below, too.
(define (subscripts p)
  (define below (marked #\_ p))
  (if (string=? "" (parts-digits p)) below (cons (parts-digits p) below)))

(define (superscripts p) (marked #\^ p))

(define (marked sign p)
  (for/list ([m (in-list (parts-marks p))] #:when (eqv? (car m) sign)) (cdr m)))

(define (regular stem digits marks)
  (define-values (base dots) (without-dots stem))
  (define shown (shown-letters base))
  (parts shown (sort-of shown) dots digits
         (for/list ([m (in-list (regexp-match* one-mark marks))])
           (cons (string-ref m 0) (shown-letters (substring m 1))))))

(define (sort-of base)
  (cond [(> (string-length base) 1) 'word]
        [(memv (string-ref base 0) (string->list "ΓΔΘΛΞΠΣΥΦΨΩ")) 'capital]
        [else 'letter]))

;; "thetadot" is theta with one dot; the rest must be one letter.
(define (without-dots stem)
  (define m (regexp-match #rx"^(.*[^t]|t|.*[^o]t|.*[^d]ot)((?:dot)+)$" stem))
  (define dots (if m (quotient (string-length (caddr m)) 3) 0))
  (if (and m (<= dots 3) (= 1 (string-length (shown-letters (cadr m)))))
      (values (cadr m) dots)
      (values stem 0)))

(define (shown-letters text) (hash-ref letters text text))

(define (letter->greek letter) (hash-ref names letter #f))
(define (Greek-name? text) (hash-has-key? letters text))

(define letters
  (hash "alpha" "α" "beta" "β" "gamma" "γ" "delta" "δ" "epsilon" "ε" "zeta" "ζ" "eta" "η"
        "theta" "θ" "iota" "ι" "kappa" "κ" "lambda" "λ" "mu" "μ" "nu" "ν" "xi" "ξ"
        "omicron" "ο" "pi" "π" "rho" "ρ" "sigma" "σ" "tau" "τ" "upsilon" "υ" "phi" "φ"
        "chi" "χ" "psi" "ψ" "omega" "ω"
        "Gamma" "Γ" "Delta" "Δ" "Theta" "Θ" "Lambda" "Λ" "Xi" "Ξ" "Pi" "Π" "Sigma" "Σ"
        "Upsilon" "Υ" "Phi" "Φ" "Psi" "Ψ" "Omega" "Ω"))

;; The table from values to keys.
(define (inverse table) (for/hash ([(key value) (in-hash table)]) (values value key)))

(define names (inverse letters))
