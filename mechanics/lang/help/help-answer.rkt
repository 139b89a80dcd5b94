#lang racket/base
;; The output of `help`: the card of a name, cards that a text finds, or the questions there are.

(require (only-in racket/format ~a)
         (only-in racket/list take)
         racket/string
         "card-lines.rkt" "card.rkt" "cards.rkt" "search.rkt"
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
    "(help \"words\")    names that have to do with them: (help \"constraint\")"
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
  (define found (found-cards (symbol->string name) (all-cards)))
  (cons (format "~s is not a name of mechanics.~a" name
                (if (null? near) "" (format "  Did you mean ~a?" (alternatives near))))
        (if (null? near) (found-lines found) '())))

;; ---------------------------------------------------------------------------
;; A text

(define (about-text text)
  (define otherwise (and (regexp-match? #px"^\\S+$" text) (otherwise-lines (string->symbol text))))
  (define lines (append (or otherwise '()) (found-lines (found-cards text (all-cards)))))
  (if (null? lines)
      (list (format "Nothing is found for ~s; (help) tells what can be asked." text))
      lines))

(define most-found 10)

;; For each card its name, then as much of the sentence as a line has room for.
(define (found-lines cards)
  (define more (- (length cards) most-found))
  (define shown (if (> more 0) (take cards most-found) cards))
  (define names (map (lambda (c) (symbol->string (card-name c))) shown))
  (define room (min 30 (apply max 0 (map string-length names))))
  (append
   (for/list ([c (in-list shown)] [name (in-list names)])
     (shortened (format "~a  ~a" (~a name #:min-width room) (or (card-sentence c) ""))))
   (if (> more 0)
       (list (format "... and ~a more; another word finds fewer." more))
       '())))

(define (shortened line)
  (if (> (string-length line) columns)
      (string-append (string-trim (substring line 0 (- columns 2)) #:left? #f) " …")
      line))
