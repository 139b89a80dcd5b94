#lang racket/base
;; Formulas as people write them, on paper and in other programs, read as S-expressions.
;;
;; Their spelling is made plain (paper-spelling.rkt), and the tokens are read by the grammar of
;; read-infix.rkt.  Where two readers could differ about the meaning (unclear-tokens.rkt), or where
;; something is left over, there is no reading.  Names stay as they are typed.

(require "formula-tokens.rkt" "one-line-name.rkt" "paper-spelling.rkt" "read-infix.rkt"
         "unclear-tokens.rkt"
         (only-in "../../operation/operation-column.rkt" operation-names))

(provide read-paper as-typed function-named own-operations)

;; known?   : symbol -> is it a name of the reader's, or of the library?
;; foreign? : symbol -> is it another program's name of something that is called otherwise here?
;; -> a datum, or #f
(define (read-paper text known? foreign?)
  (let/ec return
    (define (fail at what) (return #f))
    (define all
      (clear-tokens (tokens (plain-spelling text) fail (paper-rules known?)) known? foreign?))
    (and all (own-operations (tokens->datum all fail) known?))))

;; ---------------------------------------------------------------------------
;; Tokens

;; The rules for names, hyphens being part of known names; and those for signs, as they are in
;; infix.rkt.
(define (paper-rules known?)
  (define (hyphenated m) (and (known? (string->symbol (car m))) (string->symbol (car m))))
  (list*
   (list 'name #px"^D(?=[¹²³])" (lambda (m) 'D))
   (list 'name #px"^\\p{L}(?:\\p{L}|[0-9_])*(?:-(?:\\p{L}|[0-9_])+)+" hyphenated)
   (list 'function #px"^\\p{L}+[0-9]*(?!\\p{L}|\\p{M}|[0-9_₀-₉])"
         (lambda (m) (function-named (car m))))
   (list 'name #px"^(?:\\p{L}(?:\\p{L}|\\p{M}|[0-9_])*[₀-₉ₐ-ₜᵢᵣᵤᵥⱼ]*|°|⟪[0-9]+⟫)"
         (lambda (m) (paper-name (car m))))
   (filter (lambda (rule) (memq (car rule) kinds-of-signs)) notation-rules)))

(define kinds-of-signs
  '(number raised plus minus slash caret times root open close comma relation))

;; ẋ is xdot; other letters stay, for the reader may have defined what has their name.
(define (paper-name text)
  (cond [(assoc text special-names) => cdr]
        [(regexp-match? #px"[\u307\u308\u20DB]" (string-normalize-nfd text))
         (line-name->symbol text)]
        [else (string->symbol text)]))

(define special-names
  '(("π" . pi) ("Pi" . pi) ("°" . (/ pi 180))
    ("deg" . (/ pi 180)) ("degree" . (/ pi 180)) ("degrees" . (/ pi 180))))

;; -> symbol, or #f
(define (function-named text)
  (define name (string->symbol text))
  (cond [(memq name functions) name]
        [(assq name other-functions) => cdr]
        [else #f]))

(define functions (append '(square cube) (operation-names function reciprocal)))

(define other-functions
  '((ln . log) (arcsin . asin) (arccos . acos) (arctan . atan) (fabs . abs)
    (Sin . sin) (Cos . cos) (Tan . tan) (Sinh . sinh) (Cosh . cosh) (Tanh . tanh)
    (Exp . exp) (Log . log) (Sqrt . sqrt) (Abs . abs)
    (ArcSin . asin) (ArcCos . acos) (ArcTan . ArcTan)
    (pow . pow) (Power . Power) (atan2 . atan2) (log10 . log10)))

;; ---------------------------------------------------------------------------
;; Meaning

;; Functions of other programs, and powers of e, in ours.
(define (own-operations d known?)
  (if (pair? d)
      (let ([d (for/list ([part (in-list d)]) (own-operations part known?))])
        (case (car d)
          [(expt) (if (power-of-e? d known?) (list 'exp (caddr d)) d)]
          [(pow Power) (cons 'expt (cdr d))]
          [(atan2) (cons 'atan (cdr d))]
          [(ArcTan) (cons 'atan (reverse (cdr d)))]
          [(log10) (list 'log (cadr d) 10)]
          [else d]))
      d))

(define (power-of-e? d known?)
  (and (memq (cadr d) '(e E)) (not (known? (cadr d))) (not (number? (caddr d)))))

;; The same as one types it: differences, and -x as (- x).
(define (as-typed d)
  (if (pair? d)
      (let ([d (map as-typed d)])
        (case (car d)
          [(+) (signed-sum (cdr d))]
          [(*) (if (negative? (cadr d)) (list '- (without-sign d)) d)]
          [else d]))
      d))

(define (signed-sum terms)
  (for/fold ([sum (car terms)]) ([t (in-list (cdr terms))])
    (cond [(negative? t) (list '- sum (- t))]
          [(and (pair? t) (eq? (car t) '-) (null? (cddr t))) (list '- sum (cadr t))]
          [(and (pair? sum) (eq? (car sum) '+)) (append sum (list t))]
          [else (list '+ sum t)])))

(define (negative? d) (and (real? d) (< d 0)))

;; (* -1 k x) -> (* k x)
(define (without-sign product)
  (define c (- (cadr product)))
  (define factors (if (eqv? c 1) (cddr product) (cons c (cddr product))))
  (if (null? (cdr factors)) (car factors) (cons '* factors)))
