#lang racket/base
;; Signs of print, which a program pasted from a page of a PDF may have in place of those of the
;; keyboard: Racket takes them for letters of names.

(require "../written-form.rkt"
         "../../error/note.rkt")

(provide typographic-sentence tell-curly-quotes)

;; character, its name, the text to type
(define signs
  '((#\‘ "a curly quote" "'") (#\’ "a curly quote" "'") (#\′ "a prime" "'")
    (#\´ "an accent" "'")
    (#\“ "a curly quote" "\"") (#\” "a curly quote" "\"")
    (#\− "a minus of print" "-") (#\– "a dash" "-") (#\— "a dash" "-") (#\‐ "a hyphen of print" "-")
    (#\× "a multiplication sign" "*") (#\· "a multiplication dot" "*")
    (#\⋅ "a multiplication dot" "*") (#\∙ "a multiplication dot" "*")
    (#\÷ "a division sign" "/")
    (#\→ "an arrow of print" "->")))

;; name : symbol -> text or #f
(define (typographic-sentence name)
  (define text (symbol->string name))
  (define found (for/or ([c (in-string text)]) (assv c signs)))
  (and found
       (format "~a in it is ~a; type ~a" (car found) (cadr found) (as-typed text))))

;; The text with the signs of the keyboard.
(define (as-typed text)
  (apply string-append
         (for/list ([c (in-string (without-closing-quote text))])
           (define entry (assv c signs))
           (if entry (caddr entry) (string c)))))

;; ‘x’ was meant for the symbol 'x, which has no quote at its end.
(define (without-closing-quote text) (regexp-replace #px"^([‘’'´].*)[‘’´]$" text "\\1"))

;; ---------------------------------------------------------------------------
;; 'x’ is a symbol of another name than x: nothing fails.

(define (tell-curly-quotes stx)
  (syntax-case stx ()
    [_ (quoted-name stx) (tell-curly-quote (quoted-name stx))]
    [(first . others) (begin (tell-curly-quotes #'first) (tell-curly-quotes #'others))]
    [_ (void)]))

(define (tell-curly-quote id)
  (define text (symbol->string (syntax-e id)))
  (define clean (regexp-replace* #rx"[‘’“”]" text ""))
  (define line (and (path? (syntax-source id)) (syntax-line id)))
  (unless (equal? clean text)
    (note (format "'~a~a is a symbol with a curly quote in its name; the symbol ~a is written '~a"
                  text (if line (format ", line ~a," line) "") clean clean))))
