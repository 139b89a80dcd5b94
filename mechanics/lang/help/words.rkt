#lang racket/base
;; Words of a text as the search compares them: in small letters, without accents and endings.
;;
;; The table of the search and each question are made of them, at the prompt and in the manual's
;; pages.  So the patterns are data, which the pages get with the table; they mean the same in a
;; browser, where `u` is the flag of regular expressions.

(require racket/list
         racket/string)

(provide words-of telling-words telling-text all-words plain
         word-pattern endings joining-words)

;; A number such as 1.29, or letters with an owner's 's.
(define word-pattern "[0-9]+(?:\\.[0-9]+)+|(?:\\p{L}|[0-9_])+(?:'\\p{L}+)?")

;; (pattern insert), used one after the other.  Plurals find the singular, matrices too, sine finds
;; sin, Lagrange's finds Lagrange, conservation finds conserved, and plotting finds plot.
(define endings
  '(("'[a-z]*$" "")
    ("ices$" "ix")
    ("^(.{4,}?)(?:ications?|ators?|ations?|ating|ated?s?|ings?|ed|ions?|ors?)$" "\\1")
    ("([bdgmnprt])\\1$" "\\1")
    ("^(.{3,}?)(?:ies|icals?|ics?|y|es|s|e|i)$" "\\1")))

(define joining-words
  '("a" "about" "am" "an" "and" "are" "as" "at" "be" "by" "can" "do" "does" "for" "from" "get"
    "has" "have" "how" "i" "if" "in" "into" "is" "it" "its" "me" "my" "of" "on" "or" "s" "should"
    "that" "the" "their" "theorem" "there" "this" "to" "use" "using" "want" "what" "when" "where"
    "which" "why" "with" "you"))

;; -> stems of all words, in their order
(define (words-of text) (map stem (all-words text)))

;; Each once, without those that only join others, unless the text has no more than these.
(define (telling-words text) (remove-duplicates (map stem (told text))))

;; The same words as they are typed, but for accents and large letters.
(define (telling-text text) (string-join (told text)))

(define (told text)
  (define all (all-words text))
  (define telling (filter (lambda (w) (not (member w joining-words))) all))
  (if (null? telling) all telling))

(define pattern (pregexp word-pattern))

(define (all-words text) (regexp-match* pattern (plain text)))

;; In small letters, without accents and joined letters: typing poincare finds Poincaré.
(define (plain text)
  (string-downcase
   (string-replace (regexp-replace* #px"\\p{Mn}" (string-normalize-nfkd text) "") "’" "'")))

(define patterns
  (for/list ([e (in-list endings)]) (list (pregexp (first e)) (second e))))

(define (stem word)
  (if (regexp-match? #rx"[0-9]" word)
      word
      (for/fold ([w word]) ([p (in-list patterns)]) (regexp-replace (first p) w (second p)))))
