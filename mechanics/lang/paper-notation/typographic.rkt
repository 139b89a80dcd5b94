#lang racket/base
;; Signs of print, which a program pasted from a page of a PDF may hold where those of the
;; keyboard belong: Racket takes them for letters of names.

(require "../../error/note.rkt")

(provide typographic-sentence typographic-sentences tell-curly-quotes)

;; character, what it is called, what to type
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
  (define found (for/first ([c (in-string text)] #:when (assv c signs)) (assv c signs)))
  (and found
       (format "~a in it is ~a; type ~a" (car found) (cadr found) (as-typed text))))

;; The same as a list, or #f.
(define (typographic-sentences name)
  (define sentence (typographic-sentence name))
  (and sentence (list sentence)))

;; The text with the signs of the keyboard.
(define (as-typed text)
  (apply string-append
         (for/list ([c (in-string (without-closing-quote text))])
           (define entry (assv c signs))
           (if entry (caddr entry) (string c)))))

;; Of ‘x’ the symbol 'x was meant, which has no quote at its end.
(define (without-closing-quote text)
  (define last (- (string-length text) 1))
  (if (and (> last 0)
           (memv (string-ref text 0) '(#\‘ #\’ #\' #\´))
           (memv (string-ref text last) '(#\‘ #\’ #\´)))
      (substring text 0 last)
      text))

;; ---------------------------------------------------------------------------
;; 'x’ is a symbol, of another name than was meant: nothing fails.

(define (tell-curly-quotes stx)
  (syntax-case stx ()
    [(q name)
     (and (eq? (syntax-e #'q) 'quote) (identifier? #'name))
     (tell-curly-quote #'name)]
    [(first . others) (begin (tell-curly-quotes #'first) (tell-curly-quotes #'others))]
    [_ (void)]))

(define (tell-curly-quote id)
  (define text (symbol->string (syntax-e id)))
  (define clean (regexp-replace* #rx"[‘’“”]" text ""))
  (define line (and (path? (syntax-source id)) (syntax-line id)))
  (unless (equal? clean text)
    (note (format "'~a~a is a symbol with a curly quote in its name; the symbol ~a is written '~a"
                  text (if line (format ", line ~a," line) "") clean clean))))
