#lang racket/base
;; Cards that a text is about.  All its words must occur, each in the name, in the sentence, in the
;; name of an argument or in the title of the page.
;;
;; A name counts more than a sentence, and a word more than a part of a word.  But a word has many
;; senses: `golden-section-min` is no section of a motion.  So the card's page counts as well: a
;; page that is named after the words, or on which many cards have them, is about them.
;;
;; Where few cards are found, cards follow whose whole entry in the manual has the words.

(require racket/list
         racket/string
         "card.rkt")

(provide found-cards)

;; -> cards, the best first; of equals in the order of the manual
(define (found-cards text cards)
  (define telling (telling-words text))
  (define words (remove-duplicates (map (lambda (w) (stem (plain w))) telling)))
  (define matching (filter (lambda (c) (all-in? words (all-text c))) cards))
  (define topic (topic-of-pages words matching cards))
  (define (score c)
    (+ (weight words (string-join telling) c) (* most-for-topic (hash-ref topic (card-page c)))))
  (define found (sort matching > #:key score #:cache-keys? #t))
  (if (< (length found) few)
      (remove-duplicates
       (append found (filter (lambda (c) (all-begin-in? words (plain (card-words c)))) cards))
       eq?)
      found))

(define few 3)

;; The words of the text without those that only join others, unless it has no more than these.
(define (telling-words text)
  (define all (string-split text))
  (define telling (filter (lambda (w) (not (member (plain w) joining-words))) all))
  (if (null? telling) all telling))

(define joining-words
  '("a" "an" "and" "are" "at" "by" "do" "does" "for" "from" "has" "have" "how" "i" "in" "is" "it"
    "my" "of" "on" "or" "that" "the" "there" "this" "to" "what" "where" "which" "with"))

;; The beginning of a word, without its ending: plurals find the singular, sine finds sin,
;; Lagrange's finds Lagrange, and conservation finds conserved.
(define (stem word)
  (define owner (regexp-replace #rx"(.)['’]s?$" word "\\1"))
  (define long (regexp-match #rx"^(......*?)(ication|ation|ing|ed)s?$" owner))
  (cond [long (cadr long)]
        [(> (string-length owner) 3) (regexp-replace #rx"(ies|y|es|s|e)$" owner "")]
        [else owner]))

(define endings "(y|ies|e|es|s|'s|ed|ing|ations?|ications?)?")

(define (all-in? words text)
  (for/and ([w (in-list words)]) (string-contains? text w)))

;; Does each word begin a word of the text?  Within words it would occur by chance.
(define (all-begin-in? words text [end ""])
  (for/and ([w (in-list words)])
    (regexp-match? (string-append "(^|[^a-z0-9])" (regexp-quote w) end) text)))

;; Is each word a word of the text, up to its ending?  sin is, of singular it is not.
(define (all-words-in? words text)
  (all-begin-in? words text (string-append endings "([^a-z0-9]|$)")))

;; In small letters, without accents and joined letters: typing poincare finds Poincaré.
(define (plain text)
  (string-foldcase (regexp-replace* #px"\\p{Mn}" (string-normalize-nfkd text) "")))

;; ---------------------------------------------------------------------------
;; Which come first

;; text : the words as they were typed, which may be the name itself
(define (weight words text c)
  (define name (name-text c))
  (define both (sentence-text c))
  (+ (cond [(string=? (symbol->string (card-name c)) text) 7.0]
           [(string=? name (plain text)) 6.0]
           [(all-words-in? words name) 3.0]
           [(all-begin-in? words name) 2.7]
           [(all-in? words name) 2.4]
           [(all-words-in? words both) 2.0]
           [(all-begin-in? words both) 1.8]
           [(all-in? words both) 1.5]
           [else 0.0])
     (if (eq? (card-library c) 'mechanics) 0.0 for-another-library)))

;; Names of mechanics itself come before the examples of the book.
(define for-another-library -0.4)

(define most-for-topic 1.5)

;; A page of few cards is not about all that it names.
(define cards-of-a-page 5)

;; -> hash, page to a number up to 1, the share of the page that is about the words
(define (topic-of-pages words matching cards)
  (define telling
    (pages-counted (filter (lambda (c) (all-words-in? words (sentence-text c))) matching)))
  (for/hash ([(page count) (in-hash (pages-counted cards))])
    (values page
            (if (all-words-in? words (plain page))
                1.0
                (/ (hash-ref telling page 0) (+ count cards-of-a-page 0.0))))))

(define (pages-counted cards)
  (for/fold ([counts (hash)]) ([c (in-list cards)])
    (hash-update counts (card-page c) add1 0)))

;; ---------------------------------------------------------------------------
;; Texts of a card

(define (name-text c) (plain (symbol->string (card-name c))))

(define (sentence-text c)
  (plain (string-append (symbol->string (card-name c)) " " (or (card-sentence c) ""))))

(define (all-text c)
  (plain
   (string-join
    (list* (symbol->string (card-name c))
           (or (card-sentence c) "")
           (card-page c)
           (append-map signature-call (card-signatures c))))))
