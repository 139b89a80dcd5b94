#lang racket/base
;; The words and signs of a formula on one line.

(require "one-line-name.rkt" (only-in "name.rkt" letter))

(provide tokens notation-rules (struct-out token))

;; at : position in the text; spaced? : does a space stand before it?
(struct token (kind text value at spaced?) #:authentic)

;; text (position message -> does not return) -> list of tokens, the last of kind 'end
;; rules : ((kind pattern (match -> value or #f)) ...), the first that fits and gives a value
(define (tokens text fail [rules notation-rules])
  (define n (string-length text))
  (let loop ([at 0] [spaced? #f] [found '()])
    (cond [(= at n) (reverse (cons (token 'end "" #f at #t) found))]
          [(char-whitespace? (string-ref text at)) (loop (+ at 1) #t found)]
          [else
           (define t (token-at-position text at spaced? rules))
           (unless t (fail at (substring text at (min n (+ at 12)))))
           (loop (+ at (string-length (token-text t))) #f (cons t found))])))

(define (token-at-position text at spaced? rules)
  (for/or ([rule (in-list rules)])
    (define m (regexp-match (cadr rule) text at))
    (define value (and m ((caddr rule) m)))
    (and value (token (car rule) (car m) value at spaced?))))

;; The notation of infix.rkt, and signs of people
(define notation-rules
  (list
   (list 'number #px"^[½⅓⅔¼¾⅕⅖⅗⅘⅙⅚⅛⅜⅝⅞]" (lambda (m) (small-fraction->number (car m))))
   (list 'number #px"^([0-9]+(?:[.][0-9]*)?|[.][0-9]+)(?:×10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)|e([-+]?[0-9]+))?"
         (lambda (m) (number-of (cadr m) (caddr m) (cadddr m))))
   (list 'number #px"^∞" (lambda (m) +inf.0))
   (list 'number #px"^NaN(?!\\p{L})" (lambda (m) +nan.0))
   (list 'partial #px"^∂(?:([₀-₉]+)|_[(]([0-9,]+)[)])" (lambda (m) (path-of m)))
   (list 'plain #px"^<function>" (lambda (m) '<function>))
   (list 'unit #px"^[𝐢𝐣𝐤](?!\\p{L}|[0-9_^₀-₉])" void)
   (list 'name #px"^D(?!_)" (lambda (m) 'D))
   (list 'name
         (pregexp (format (string-append "^~a+(?:-~a+)*[\u307\u308\u20DB]?[0-9]*"
                                         "(?:[_^](?:~a|[0-9])+|[₀-₉ₐ-ₜᵢᵣᵤᵥⱼ]+)*")
                          letter letter letter))
         (lambda (m) (line-name->symbol (car m))))
   (list 'quoted #px"^[|]((?:[^|\\\\]|\\\\.)*)[|]" (lambda (m) (quoted-symbol (cadr m))))
   (list 'raised #px"^[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+" (lambda (m) (string->number (superscript->text (car m)))))
   (list 'plus #rx"^[+]" void) (list 'minus #px"^[−-]" void) (list 'slash #rx"^/" void)
   (list 'caret #px"^(?:\\^|[*][*])" void) (list 'times #px"^[*·⋅×]" void) (list 'root #rx"^√" void)
   (list 'open #rx"^[(]" void) (list 'close #rx"^[)]" void)
   (list 'bracket #rx"^[[]" void) (list 'bracket-close #rx"^[]]" void)
   (list 'comma #rx"^," void) (list 'semicolon #rx"^;" void)
   (list 'relation #px"^[=<>≤≥∘↦]" void)
   (list 'dots #rx"^⋯" void)))

(define (number-of digits raised plain)
  (define exponent (or plain (and raised (superscript->text raised))))
  (string->number (if exponent (string-append digits "e" exponent) digits)))

(define (path-of m)
  (if (cadr m)
      (list (string->number (list->string (for/list ([c (in-string (cadr m))])
                                            (integer->char (- (char->integer c) 8272))))))
      (map string->number (regexp-match* #rx"[0-9]+" (caddr m)))))

(define (quoted-symbol text)
  (define (character all escaped)
    (if (regexp-match? #rx"^u" escaped)
        (string (integer->char (string->number (substring escaped 1 (sub1 (string-length escaped)))
                                               16)))
        escaped))
  (string->symbol (regexp-replace* #px"\\\\(u[0-9a-f]+;|.)" text character)))
