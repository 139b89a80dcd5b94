#lang racket/base
;; The text of the manual as plain characters.  A part of a page is a string or a datum, as
;; the reader of at-expressions makes them.

(require racket/list
         racket/string)

(provide plain-text first-sentence distinct-words)

;; parts -> text of one line
(define (plain-text parts) (bare (one-line parts)))

(define (one-line parts)
  (string-normalize-spaces (typographic (apply string-append (map part->text parts)))))

;; Stops in code end no sentence: until it is known where one ends, they are other letters.
(define stops '((#\. . #\uE000) (#\? . #\uE001) (#\! . #\uE002) (#\: . #\uE003)))

(define (disguised text)
  (exchange text (lambda (c) (cond [(assv c stops) => cdr] [else c]))))

(define (bare text)
  (exchange text (lambda (c)
                   (define found (findf (lambda (s) (char=? (cdr s) c)) stops))
                   (if found (car found) c))))

(define (exchange text f) (list->string (map f (string->list text))))

(define (part->text part)
  (cond [(string? part) part]
        [(not (and (pair? part) (list? part))) ""]
        [else
         (define parts (without-keywords (cdr part)))
         (case (car part)
           [(racket racketid racketidfont racketmodname racketresult exec tt filepath)
            (disguised (string-join (map code-text parts) " "))]
           [(italic bold emph elem deftech tech math formula onscreen smaller list para)
            (apply string-append (map part->text parts))]
           [(subscript) (in-small parts subscripts "_")]
           [(superscript) (in-small parts superscripts "^")]
           [(hash-lang) "#lang"]
           [else ""])]))

(define (without-keywords parts)
  (cond [(null? parts) '()]
        [(keyword? (car parts)) (without-keywords (if (pair? (cdr parts)) (cddr parts) '()))]
        [else (cons (car parts) (without-keywords (cdr parts)))]))

(define (code-text d) (if (string? d) d (format "~s" (without-escapes d))))

;; _name is how an argument is written in a form.
(define (without-escapes d)
  (cond [(pair? d) (cons (without-escapes (car d)) (without-escapes (cdr d)))]
        [(and (symbol? d) (regexp-match #rx"^_(.+)$" (symbol->string d)))
         => (lambda (found) (string->symbol (cadr found)))]
        [else d]))

(define subscripts (hash #\0 #\₀ #\1 #\₁ #\2 #\₂ #\3 #\₃ #\4 #\₄ #\t #\ₜ #\k #\ₖ #\+ #\₊ #\i #\ᵢ))
(define superscripts
  (hash #\0 #\⁰ #\1 #\¹ #\2 #\² #\3 #\³ #\4 #\⁴ #\k #\ᵏ #\+ #\⁺ #\- #\⁻ #\n #\ⁿ))

(define (in-small parts characters otherwise)
  (define text (apply string-append (map part->text parts)))
  (define found (for/list ([c (in-string text)]) (hash-ref characters c #f)))
  (if (memq #f found) (string-append otherwise text) (list->string found)))

(define (typographic text)
  (for/fold ([text text]) ([pair (in-list '(("---" . "–") ("``" . "“") ("''" . "”")))])
    (string-replace text (car pair) (cdr pair))))

;; In small letters, in the order in which they come, with spaces between; items of lists, too.
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

;; The first sentence of a body, or #f.  What a colon announces is left out.
(define (first-sentence parts)
  (define text (one-line (first-paragraph parts)))
  (define found (regexp-match sentence-end text))
  (define sentence (bare (if found (car found) text)))
  (cond [(string=? sentence "") #f]
        [(regexp-match? #rx"[.?!][)”]?$" sentence) sentence]
        [else (string-append (string-trim sentence #rx"[:,]" #:left? #f) ".")]))

;; Not the stop of an abbreviation.
(define sentence-end #px"^.*?(?<!e[.]g)(?<!i[.]e)(?<![ (]p)[.?!:][)”]?(?=\\s|$)")

;; The parts before an empty line or a display, such as a list; those before any text left
;; out.
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
