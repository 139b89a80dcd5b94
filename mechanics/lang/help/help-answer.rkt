#lang racket/base
;; The output of `help`: the card of a name, the finds for a text, or the questions there are.

(require racket/string
         "card-lines.rkt" "cards.rkt" "finding-lines.rkt" "finding.rkt" "search.rkt"
         "words.rkt"
         (only-in "../wrong-call/reader-signature.rkt" head->text)
         "../paper-notation/other-notation.rkt"
         (only-in "../paper-notation/prefix-form.rkt" typed-formula)
         "../paper-notation/typographic.rkt"
         (only-in "../unknown-name/other-library.rkt" exports)
         (only-in "../redefinition/prompt.rkt" head-at-prompt)
         "../../show/display/filled-lines.rkt"
         "../../error/spelling.rkt")

(provide help-about help-lines)

(define columns 80)

;; about : symbol, string or #f; prints
(define (help-about about)
  (for ([line (in-list (help-lines about))])
    (write-string line)
    (newline)))

;; -> lines
(define (help-lines about)
  (cond [(not about) what-can-be-asked]
        [(symbol? about) (about-name about)]
        [(string=? (string-trim about) "") what-can-be-asked]
        [else (about-text (string-trim about))]))

(define what-can-be-asked
  '("(help name)       the card of a name: (help verify-solution)"
    "(help \"words\")    what has to do with them: names, pages of the manual, programs and"
    "                 exercises: (help \"friction\"), (help \"exercise 1.29\")"
    ""
    "Where to begin: (help Lagrange-equations), (help verify-solution), (help D),"
    "(help literal-function), (help up), (help assume), (help evolve-trajectory)."))

;; ---------------------------------------------------------------------------
;; A name

(define (about-name name)
  (define own (own-lines name))
  (cond [(null? own) (about-known-name name)]
        [(card-of name) (append own (list "" "What it hides:" "") (about-known-name name))]
        [else own]))

;; About a definition that the reader made at the prompt.
(define (own-lines name)
  (define head (head-at-prompt name))
  (cond [(not head) '()]
        [(pair? head)
         (list (format "~a is your own definition; it is called as ~a" name (head->text head)))]
        [else (list (format "~a is your own definition." name))]))

(define (about-known-name name)
  (cond [(card-of name) => (lambda (c) (card-lines c columns))]
        [(ormap (lambda (library) (memq name (exports library))) '(racket/base racket/match))
         (list (format "~s is Racket's own, and means here what it means there." name)
               (format "  https://docs.racket-lang.org/search/?q=~s" name))]
        [(otherwise-lines name)]
        [else (about-unknown name)]))

;; -> lines or #f
(define (otherwise-lines name)
  (define advice (written-otherwise name))
  (and advice
       (filled (string-split (format "~s is not a name of mechanics: ~a." name advice)) columns)))

;; Advice on a name of another program, a formula or a sign of print; or #f.
(define (written-otherwise name)
  (define formula (typed-formula name))
  (or (notation-sentence name)
      (typographic-sentence name)
      (and formula (format "operations come first, ~s" formula))))

(define (about-unknown name)
  (define near (likely-names name (card-names)))
  (cons (format "~s is not a name of mechanics.~a" name
                (if (null? near) "" (format "  Did you mean ~a?" (alternatives near))))
        (if (null? near) (known-words-lines (symbol->string name)) '())))

;; A name of words is a question about them, where they are the title of something.
(define (known-words-lines text)
  (define-values (found all-words?) (find-in-table (table-of-search) text))
  (if (and (pair? found) (has-all-words? (car found) text)) (found-lines found) '()))

(define (has-all-words? f text)
  (define words (words-of (string-append (finding-title f) " " (finding-sentence f))))
  (for/and ([w (in-list (words-of text))]) (member w words)))

;; ---------------------------------------------------------------------------
;; A text

(define (about-text text)
  (define otherwise (and (regexp-match? #px"^\\S+$" text) (otherwise-lines (string->symbol text))))
  (define lines (if otherwise
                    (append otherwise (known-words-lines text))
                    (lines-about text)))
  (if (null? lines)
      (list (format "Nothing is found for ~s; (help) tells what can be asked." text))
      lines))

;; Findings for the text; where a letter is wrong and there are none, those of another spelling.
(define (lines-about text)
  (define-values (found all-words?) (find-in-table (table-of-search) text))
  (define otherwise (respelled (table-of-search) text))
  (cond [all-words? (found-lines found)]
        [otherwise (cons (format "Nothing is found for ~s; did you mean ~s?" text otherwise)
                         (lines-about otherwise))]
        [(null? found) '()]
        [else (cons (format "Nothing has all words of ~s; these have some." text)
                    (found-lines found))]))
