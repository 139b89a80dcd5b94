#lang racket/base
;; The words and signs of a formula as people type it: of paper, of TeX and of other programs, mixed
;; as they come.  \frac{p_\theta^2}{2m}, p_θ²/(2 m) and p_theta**2/(2*m) have the same names.
;;
;; A command of TeX is a token, and so is a brace: the grammar (handwritten-formula.rkt) nests them.

(require "formula-tokens.rkt" (only-in "name.rkt" Greek-name?)
         (only-in "handwritten-words.rkt" function-named)
         (only-in racket/list split-at-right))

(provide handwritten-tokens)

;; text (position message -> does not return) -> tokens
(define (handwritten-tokens text fail) (tokens (plainly-spelled text) fail rules))

;; ---------------------------------------------------------------------------
;; Spelling

;; Without signs that TeX needs for looks alone; rates as fractions become primes.
(define (plainly-spelled text)
  (for/fold ([text (string-normalize-nfc text)]) ([entry (in-list spellings)])
    (regexp-replace* (car entry) text (cdr entry))))

(define rated "d\\s*(\\^\\{?2\\}?|²)?")
(define rated-name "((?:\\\\?\\p{L}+)(?:_\\{?(?:\\\\?\\p{L}+|[0-9]+)\\}?)?)")
(define (rate-spelling before between behind)
  (define pattern
    (string-append before rated "\\s*" rated-name between "d\\s*t(?:\\^\\{?2\\}?|²)?" behind))
  (cons (pregexp pattern)
        (lambda (all twice name) (string-append "(" name (if twice "''" "'") ")"))))

(define spellings
  (list (cons #rx"[$]|\\\\(?:displaystyle|left|right|[bB]igg?[lr]?)(?![a-zA-Z])" "")
        (cons #px"\\\\(?:[,;:! ]|q?quad(?![a-zA-Z]))|~" " ")
        (cons #px"\\\\begin\\{array\\}\\{c*\\}" "")
        (cons #px"\\\\(?:begin|end)\\{(?:array|aligned|gathered)\\}" "")
        (cons #px"\\\\begin\\{[pb]matrix\\}" "(") (cons #px"\\\\end\\{[pb]matrix\\}" ")")
        (cons #px",?\\s*(?:\\\\\\\\(?:\\[[0-9]ex\\])?|&)" ", ")
        (cons #px"\\\\[lr]vert(?![a-zA-Z])" "|") (cons #px"\\\\([{}])" "\\1")
        (cons #px"\\\\operatorname\\{([a-z]+)\\}" " \\1")
        (rate-spelling "\\\\[dt]?frac\\s*\\{\\s*" "\\s*\\}\\s*\\{\\s*" "\\s*\\}")
        (rate-spelling "(?<!\\p{L})" "\\s*/\\s*" "(?!\\p{L})")
        (cons #px"\\\\[dt]frac(?![a-zA-Z])" "\\\\frac")
        (cons #px"(\\\\frac|\\\\sqrt)(?:\\s*([0-9])|\\s+([a-zA-Z]))" "\\1{\\2\\3}")
        (cons #px"(\\\\frac\\s*\\{[^{}]*\\})\\s*([0-9a-zA-Z])" "\\1{\\2}")
        (cons #px"(?<![=<>])==|:=" "=")))

;; ---------------------------------------------------------------------------
;; Words

(define below "(?:_(?:\\{[^{}]*\\}|\\\\[a-zA-Z]+|[0-9]+|\\p{L}\\p{M}*(?:\\p{L}|\\p{M})*[0-9]*))*")
(define below-line "[₀-₉ₐ-ₜᵢᵣᵤᵥᵦ-ᵪⱼ]*")
(define (word-rule base text-of)
  (list 'word (pregexp (string-append "^" base "(" below below-line ")"))
        (lambda (m)
          (define-values (base index) (split-at-right (cdr m) 1))
          (with-index (apply text-of base) (car index)))))

(define (with-index base index)
  (and base (string-append base (regexp-replace* #px"[{}\\s]" (without-commands index) ""))))

(define (without-commands text)
  (regexp-replace* #px"\\\\(?:var)?([a-zA-Z]+)" text "\\1"))

;; -> text, or #f where TeX has another command of the name
(define (Greek name) (and (or (Greek-name? name) (equal? name "hbar")) name))

(define (dotted dots letters)
  (string-append (regexp-replace #px"^\\\\(?:var)?" letters "")
                 (if (string=? dots "d") "dotdot" "dot")))

(define functions-of-TeX
  '("sin" "cos" "tan" "sec" "csc" "cot" "sinh" "cosh" "tanh" "coth" "exp" "log" "ln"
    "arcsin" "arccos" "arctan"))

;; -> symbol, or #f
(define (function-of-TeX text) (and (member text functions-of-TeX) (function-named text)))

;; ---------------------------------------------------------------------------

(define kinds-of-signs
  '(number raised plus minus slash caret times root open close bracket bracket-close comma
           semicolon))

(define (sign kind pattern) (list kind pattern void))

(define rules
  (append
   (list
    (list 'decimal-comma #px"^[0-9]+,[0-9]+" (lambda (m) (car m)))
    (sign 'fraction #px"^\\\\frac(?![a-zA-Z])") (sign 'root #px"^\\\\sqrt(?=\\s*\\{)|^√")
    (sign 'times #px"^\\\\(?:cdot|times)(?![a-zA-Z])")
    (list 'function #px"^\\\\([a-z]+)" (lambda (m) (function-of-TeX (cadr m))))
    (word-rule "\\\\(d?)dot\\s*(?:(?=\\{)\\{\\s*)?(\\\\?[a-zA-Z]+)\\s*\\}?" dotted)
    (word-rule "\\\\(?:var)?([a-zA-Z]+)" Greek)
    (word-rule "\\\\(?:math(?:rm|it|bf)|text)\\s*\\{\\s*(\\p{L}+[0-9]*)\\s*\\}" values)
    (word-rule "(\\p{L}(?:\\p{L}|\\p{M}|[0-9])*|⟪[^⟫]*⟫)" values)
    (list 'primes #px"^(?:['′’]+|[″\"])"
          (lambda (m) (if (member (car m) '("″" "\"")) 2 (string-length (car m)))))
    (sign 'brace #rx"^{") (sign 'brace-close #rx"^}") (sign 'bar #rx"^[|]")
    (sign 'minus #px"^[–—]")
    (sign 'relation #rx"^="))
   (filter (lambda (rule) (memq (car rule) kinds-of-signs)) notation-rules)))
