#lang racket/base
;; From the manual's source to cards: entries of every kind, sentences, examples with what
;; they need.

(require mechanics/lang/help/card
         (only-in mechanics/lang/help/document
                  document-fields document-finding document-prior in-text)
         (only-in mechanics/lang/help/finding finding-title)
         mechanics/lang/help/make-cards
         (only-in mechanics/lang/help/name-documents name-documents)
         mechanics/lang/help/page
         (only-in mechanics/lang/help/page-documents page-documents)
         mechanics/lang/help/prose
         racket/file
         (only-in racket/string string-contains?)
         "../../support/checks.rkt")

(define sample
  #<<end
#lang scribble/manual
@(require "../eval.rkt")
@title[#:tag "sample"]{A sample}
@defmodule[mechanics/sample]
@(define session
   (make-session '(require mechanics/book)
                 '(define plane (up 't 'x 'v))
                 '(define-coordinates (up z w) chart)))

@defproc[((swing [m scalar] [l (or/c real? #f)]) [local local-tuple] [n exact-integer? 3]
          [#:force force (or/c #f procedure?) #f] [x (listof symbol?)] ...)
         void?]{

How the pendulum of mass @racket[m] swings, e.g. in the (x, y) plane: so.
See @racket[still] and D@subscript{t}.

@examples[#:eval session
(define (helper x)
  (* 2 x))
(define unused 3)
(define (above f) (f 1))
(eval:error (swing 1))
(above (lambda (unused) ((swing 1 (helper unused)) plane)))
(swing 2 3)]

@sicm{1.7, p. 76}}

@deftogether[(@defthing[still real?] @defform[#:id turn (turn (axis ...) body)]
              @defparam[limit n (or/c 'a "b" #f)])]{

@examples[#:eval session
(define later still)
(turn (z) d/dz)]

It rests.}

@defstruct*[(exn:stuck exn:fail) ([where any/c])]{Stuck, ``here'' --- or so.}

@defproc[(elsewhere [x any/c] [rows (listof (listof integer?))] [grid (list/c integer? real?)]
                    [all (listof any/c)] [rests (listof equilibrium?)]) boolean?]{Is it elsewhere?

Another paragraph.}

@examples[#:eval session (list 1 (elsewhere plane))]
end
  )

;; The sample as a page of the reference or the guide, which its folder says
(define (pages-in . folders)
  (define top (make-temporary-file "page~a" 'directory))
  (define folder (apply build-path top folders))
  (define file (build-path folder "page.scrbl"))
  (make-directory* folder)
  (call-with-output-file file (lambda (port) (write-string sample port)))
  (begin0 (manual-pages file)
          (delete-directory/files top)))

(define pages (pages-in "guide"))

(define cards (manual-cards pages #'here))

(define (card-of name) (findf-name name cards))
(define (findf-name name cards)
  (for/first ([c (in-list cards)] #:when (eq? (card-name c) name)) c))

(test-case "there is a card for each name, on its page and of its library"
  (check-equal? (map card-name cards)
                '(swing still turn limit exn:stuck exn:stuck? exn:stuck-where elsewhere))
  (check-equal? (card-page (card-of 'swing)) "A sample")
  (check-equal? (card-library (card-of 'swing)) 'mechanics/sample))

(test-case "signatures say how a name is used"
  (define (call name) (signature-call (car (card-signatures (card-of name)))))
  (check-equal? (call 'swing) '("((swing m l)" "local" "[n]" "[#:force force]" "x" "...)"))
  (check-equal? (call 'still) '("still"))
  (check-equal? (call 'turn) '("(turn" "(axis ...)" "body)"))
  (check-equal? (call 'limit) '("(limit" "[n])"))
  (check-equal? (call 'exn:stuck-where) '("(exn:stuck-where" "x)")))

(test-case "arguments have their contracts in words, and their defaults"
  (define s (car (card-signatures (card-of 'swing))))
  (check-equal? (signature-needed s) (list (argument "local" "local tuple" #f #f)))
  (check-equal? (signature-optional s) (list (argument "n" "integer" "3" #f)))
  (check-equal? (signature-keywords s)
                (list (argument "force" "function or #f" "#f" '|#:force|)))
  (check-equal? (signature-rest s) "x ...")
  (check-equal? (signature-parameters s) '(2))
  (check-false (takes? s 0))
  (check-true (takes? s 5))
  (check-false (signature-result s)))

(test-case "lists are told in words, and many of them in the plural"
  (check-equal? (map argument-what (signature-needed (car (card-signatures (card-of 'elsewhere)))))
                '("any value" "list of lists of integers" "list of integer and real number"
                  "list of anything" "list of equilibria")))

(test-case "sentences are plain text"
  (define (sentence name) (card-sentence (card-of name)))
  (check-equal? (sentence 'swing) "How the pendulum of mass m swings, e.g. in the (x, y) plane.")
  (check-equal? (sentence 'still) #f)
  (check-equal? (sentence 'exn:stuck) "Stuck, “here” – or so.")
  (check-equal? (sentence 'elsewhere) "Is it elsewhere?")
  (check-equal? (plain-text '("D" (subscript "t") " " (racket (f _x)) " is x" (superscript "12")))
                "Dₜ (f x) is x¹²")
  (check-equal? (plain-text '("x" (superscript "q"))) "x^q")
  (check-equal? (first-sentence '("\n" (racket x) " is one, on\n" "p. 3 (i.e. there). More."))
                "x is one, on p. 3 (i.e. there).")
  (check-equal? (first-sentence '("A vector is " (racket up?) " in\n" (racket (f x ...)) " too."))
                "A vector is up? in (f x ...) too."))

(test-case "words that are set off are words of their sentence"
  (for ([form '(italic bold emph elem deftech tech math formula onscreen smaller list para)])
    (check-equal? (plain-text `("a " (,form "word"))) "a word" (format "~a" form))))

(test-case "a search finds a page by its title, the guide's first, and by its texts"
  (define (fields . folders)
    (document-fields (car (page-documents (car (apply pages-in folders))))))
  (define (weight-of text fields)
    (for/first ([f (in-list fields)] #:when (equal? (cdr f) text)) (car f)))
  (define-values (guide reference) (values (fields "guide") (fields "mechanics" "reference")))
  (check-true (> (weight-of "A sample" guide) (weight-of "A sample" reference)))
  (define text (cdr (assv in-text guide)))
  (for ([part '("Another paragraph." "It rests." "swing")])
    (check-true (string-contains? text part) part)))

;; Three times the binary logarithm of the uses and one
(test-case "of names those that programs use come first"
  (define documents (name-documents pages cards (hash "swing" 7 "still" 1)))
  (for ([(name prior) (hash "swing" 9 "still" 3 "elsewhere" 0)])
    (define (of-name? d) (equal? name (finding-title (document-finding d))))
    (check-equal? (for/first ([d documents] #:when (of-name? d)) (document-prior d)) prior name)))

(define (example-of name)
  (define e (card-demonstration (card-of name)))
  (and e (list (example-libraries e) (example-definitions e) (example-expressions e))))

(test-case "an example comes with the definitions that it needs, as they are written"
  (check-equal? (example-of 'swing)
                '((mechanics/book)
                  ("(define plane (up 't 'x 'v))" "(define (helper x)\n  (* 2 x))"
                   "(define (above f) (f 1))")
                  ("(above (lambda (unused) ((swing 1 (helper unused)) plane)))"))))

(test-case "coordinates are defined with the fields that come with them"
  (check-equal? (cadr (example-of 'turn)) '("(define-coordinates (up z w) chart)")))

(test-case "names without one of their own have that of another entry, or of their kin"
  (check-equal? (caddr (example-of 'elsewhere)) '("(list 1 (elsewhere plane))"))
  (check-equal? (caddr (example-of 'turn)) '("(turn (z) d/dz)"))
  (check-equal? (caddr (example-of 'limit)) '("(turn (z) d/dz)"))
  (check-equal? (caddr (example-of 'still)) '("(define later still)" "(turn (z) d/dz)"))
  (check-false (example-of 'exn:stuck)))

(test-case "a card knows its place in the book, and what stands beside it"
  (check-equal? (card-place (card-of 'swing)) "1.7, p. 76")
  (check-equal? (card-also (card-of 'swing)) '(still))
  (check-equal? (card-also (card-of 'still)) '(turn limit swing)))
