#lang racket/base
;; The text of the manual as plain characters.  A part of a page is a string or a datum, as
;; the reader of at-expressions makes them.

(require racket/list
         racket/string)

(provide plain-text first-sentence distinct-words without-keywords)

;; parts -> text of one line
(define (plain-text parts) (bare (one-line parts)))

(define (one-line parts)
  (string-normalize-spaces (typographic (parts->text parts))))

(define (parts->text parts) (string-append* (map part->text parts)))

;; Stops in code end no sentence: until sentences are found, they are letters for private use.
(define private #xE000)

(define (disguised text) (shifted #rx"[.?!:]" text private))
(define (bare text) (shifted #px"\\p{Co}" text (- private)))

(define (shifted pattern text by)
  (regexp-replace* pattern text
                   (lambda (c) (string (integer->char (+ (char->integer (string-ref c 0)) by))))))

(define (part->text part)
  (cond [(string? part) part]
        [(eq? part 'the-book) "the book"]
        [(not (and (pair? part) (list? part))) ""]
        [else
         (define parts (without-keywords (cdr part)))
         (case (car part)
           [(racket racketid racketidfont racketmodname racketresult exec tt filepath)
            (disguised (string-join (map code-text parts) " "))]
           [(italic bold emph elem deftech tech math formula onscreen smaller list para)
            (parts->text parts)]
           [(subscript) (in-small parts subscripts "_")]
           [(superscript) (in-small parts superscripts "^")]
           [(hash-lang) "#lang"]
           [else ""])]))

(define (without-keywords parts)
  (cond [(null? parts) '()]
        [(keyword? (car parts)) (without-keywords (if (pair? (cdr parts)) (cddr parts) '()))]
        [else (cons (car parts) (without-keywords (cdr parts)))]))

(define (code-text d) (if (string? d) d (format "~s" (without-escapes d))))

;; Without the _ of _name, an argument in a form.
(define (without-escapes d)
  (cond [(pair? d) (cons (without-escapes (car d)) (without-escapes (cdr d)))]
        [(and (symbol? d) (regexp-match #rx"^_(.+)$" (symbol->string d)))
         => (lambda (found) (string->symbol (cadr found)))]
        [else d]))

;; usual letters, and the small ones
(define subscripts '("01234tk+i" "₀₁₂₃₄ₜₖ₊ᵢ"))
(define superscripts '("01234k+-n" "⁰¹²³⁴ᵏ⁺⁻ⁿ"))

(define (in-small parts letters otherwise)
  (define text (parts->text parts))
  (define found
    (for/list ([c (in-string text)])
      (for/first ([usual (in-string (car letters))] [small (in-string (cadr letters))]
                  #:when (char=? c usual))
        small)))
  (if (memq #f found) (string-append otherwise text) (list->string found)))

(define (typographic text)
  (regexp-replaces text '([#rx"---" "–"] [#rx"``" "“"] [#rx"''" "”"])))

;; Each word once, in small letters, in their order, with spaces between; items of lists, too.
(define (distinct-words parts)
  (string-join (remove-duplicates
                (regexp-match* #px"\\p{L}(?:\\p{L}|-)+" (string-downcase (all-text parts))))))

(define (all-text parts)
  (string-join (for/list ([p (in-list parts)])
                 (if (and (pair? p) (memq (car p) '(itemlist item)))
                     (all-text (cdr p))
                     (one-line (list p))))))

;; ---------------------------------------------------------------------------
;; Sentences

;; The first sentence of a body, or #f.  It may end with a colon, which becomes a stop.
(define (first-sentence parts)
  (define text (one-line (first-paragraph parts)))
  (define found (regexp-match sentence-end text))
  (define sentence (bare (if found (car found) text)))
  (cond [(string=? sentence "") #f]
        [(regexp-match? #rx"[.?!][)”]?$" sentence) sentence]
        [else (string-append (string-trim sentence #rx"[:,]" #:left? #f) ".")]))

;; Not the stop of an abbreviation.
(define sentence-end #px"^.*?(?<!e[.]g)(?<!i[.]e)(?<![ (]p)[.?!:][)”]?(?=\\s|$)")

;; The parts before an empty line or a display, such as a list; empty lines at the start are
;; dropped.
(define (first-paragraph parts)
  (define begun (dropf parts (lambda (p) (and (string? p) (regexp-match? #px"^\\s*$" p)))))
  (let loop ([parts begun] [broken? #f])
    (cond [(null? parts) '()]
          [(display-form? (car parts)) '()]
          [(not (equal? (car parts) "\n")) (cons (car parts) (loop (cdr parts) #f))]
          [broken? '()]
          [else (cons "\n" (loop (cdr parts) #t))])))

(define (display-form? part)
  (and (pair? part)
       (memq (car part) '(examples bigfloat-examples racketblock itemlist sicm tabular verbatim
                          margin-note nested centered))))
