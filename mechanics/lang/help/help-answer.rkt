#lang racket/base
;; What `help` prints: the card of a name, cards that a text finds, or what can be asked.

(require racket/list
         racket/string
         "card-lines.rkt" "card.rkt" "cards.rkt" "later.rkt" "search.rkt"
         (only-in "../wrong-call/reader-signature.rkt" head->text)
         "../paper-notation/other-notation.rkt" "../paper-notation/typed-formula.rkt"
         "../paper-notation/typographic.rkt"
         (only-in "../unknown-name/other-library.rkt" exports)
         (only-in "../redefinition/prompt.rkt" head-at-prompt)
         "../../error/spelling.rkt")

(provide help-about help-lines)

;; Width of a terminal as it always was.
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

;; What the reader defined at the prompt.
(define (own-lines name)
  (define head (head-at-prompt name))
  (cond [(not head) '()]
        [(pair? head)
         (list (format "~a is your own definition; it is called as ~a" name (head->text head)))]
        [else (list (format "~a is your own definition." name))]))

(define (about-known-name name)
  (cond [(card-of name) => (lambda (c) (card-lines c columns))]
        [(later-sentence name)
         => (lambda (sentence) (filled (string-split (format "~s: ~a." name sentence)) columns))]
        [(rackets? name)
         (list (format "~s is Racket's own, and means here what it means there." name)
               (format "  https://docs.racket-lang.org/search/?q=~s" name))]
        [(otherwise-lines name)]
        [else (about-unknown name)]))

;; -> lines or #f
(define (otherwise-lines name)
  (define advice (written-otherwise name))
  (and advice
       (filled (string-split (format "~s is not a name of mechanics: ~a." name advice)) columns)))

;; What to write for a name of another program, a formula or a sign of print; or #f.
(define (written-otherwise name)
  (define formula (typed-formula name))
  (or (notation-sentence name)
      (typographic-sentence name)
      (and formula (format "operations come first, ~a" formula))))

(define (about-unknown name)
  (define near (likely-names name (append (card-names) later-names)))
  (define found (found-cards (symbol->string name) (all-cards)))
  (cons (format "~s is not a name of mechanics.~a" name
                (if (null? near) "" (format "  Did you mean ~a?" (alternatives near))))
        (if (and (null? near) (pair? found))
            (found-lines found)
            '())))

(define (rackets? name)
  (for/or ([library (in-list '(racket/base racket/match))])
    (and (memq name (exports library)) #t)))

;; ---------------------------------------------------------------------------
;; A text

(define (about-text text)
  (define found (found-cards text (all-cards)))
  (define later (later-found text))
  (define otherwise
    (or (and (regexp-match? #px"^\\S+$" text) (otherwise-lines (string->symbol text))) '()))
  (cond [(and (null? found) (null? later) (null? otherwise))
         (list (format "Nothing is found for ~s; (help) tells what can be asked." text))]
        [else (append otherwise
                      (if (null? found) '() (found-lines found))
                      (if (null? later) '() (later-lines later)))]))

(define (later-found text)
  (define pattern (regexp (regexp-quote text #f)))
  (if (< (string-length text) 3)
      '()
      (filter (lambda (name) (regexp-match? pattern (symbol->string name))) later-names)))

;; The shortest names of chapters to come.
(define (later-lines names)
  (define texts (sort (map symbol->string names) < #:key string-length))
  (define shown (take texts (min most-later (length texts))))
  (filled (cons "Of chapters to come:" shown) columns))

(define most-later 4)

(define most-found 10)

;; name, then as much of the sentence as a line has room for
(define (found-lines cards)
  (define shown (take cards (min most-found (length cards))))
  (define room (apply max 0 (map (lambda (c) (string-length (card-name->text c))) shown)))
  (append
   (for/list ([c (in-list shown)])
     (define name (card-name->text c))
     (define margin (make-string (- (min room 30) (min 30 (string-length name))) #\space))
     (shortened (string-append name margin "  " (or (card-sentence c) ""))))
   (if (> (length cards) most-found)
       (list (format "... and ~a more; another word finds fewer." (- (length cards) most-found)))
       '())))

(define (card-name->text c) (symbol->string (card-name c)))

(define (shortened line)
  (if (> (string-length line) columns)
      (string-append (string-trim (substring line 0 (- columns 2)) #:left? #f) " …")
      line))
