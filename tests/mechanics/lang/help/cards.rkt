#lang racket/base
;; Every name has a card that says something and shows it used; what the examples print is
;; what the manual's prompts print.

;; for-label: compiled with this file, for what is read on demand.
(require (for-label mechanics mechanics/book mechanics/lang/help/card-table mechanics/plot
                    mechanics/scmutils)
         (only-in mechanics assume assumptions forget-assumptions ode-integration-method)
         mechanics/lang/help/card
         mechanics/lang/help/cards
         mechanics/lang/help/demonstration
         racket/list
         racket/port
         racket/sandbox
         racket/string
         (only-in "../../../../scribblings/mechanics/eval.rkt" close-session make-session)
         "../../support/checks.rkt" "../../support/bigfloats.rkt"
         "../../support/house/exports.rkt")

(define (exported)
  (append-map own-names '(mechanics mechanics/book mechanics/plot mechanics/scmutils)))

(define known (map card-name (all-cards)))

(define (in-order names) (sort names symbol<?))

(define (names-of cards) (in-order (map card-name cards)))

;; ---------------------------------------------------------------------------
;; Sentences and examples

(test-case "every exported name has a card, and no name has two"
  (check-equal? (in-order (remove* known (exported))) '())
  (check-false (check-duplicates known)))

(test-case "every card has a sentence of some length, and a signature"
  (for ([c (in-list (all-cards))])
    (define sentence (card-sentence c))
    (check-true (and sentence (<= 5 (string-length sentence) 320)) (format "~s" (card-name c)))
    (check-regexp-match #px"[.?!][)”]?$" sentence)
    (check-false (null? (card-signatures c)))))

;; Names that are not typed, or whose example would open a window or need a library.  To get
;; shorter.
(define without-example
  '(#%app #%module-begin #%top #%top-interaction
    exn:fail:mechanics exn:fail:mechanics:not-convergent
    exn:fail:mechanics:not-convergent:integral exn:fail:mechanics:singular
    exn:fail:mechanics:singular:matrix
    animation-show frame->pict graphics-show interaction-show))

(define (read-all text) (port->list read (open-input-string text)))

(define (example-uses? e name)
  (and (memq name (flatten (append-map read-all (append (example-definitions e)
                                                        (example-expressions e)))))
       #t))

(test-case "every name is used in the example of its card"
  (define lacking
    (for/list ([c (in-list (all-cards))]
               #:unless (and (card-demonstration c)
                             (example-uses? (card-demonstration c) (card-name c))))
      c))
  (check-equal? (names-of lacking) (in-order without-example)))

(test-case "names that a card refers to have cards"
  (for ([c (in-list (all-cards))])
    (check-equal? (remove* known (card-also c)) '() (format "~s" (card-name c)))))

;; ---------------------------------------------------------------------------
;; Examples

(define (printed-lines c)
  (for/list ([a (in-list (demonstrate (card-demonstration c) 76))])
    (string-join (answer-printed a) "\n")))

(define (complaint? text)
  (and (regexp-match? #px"^([^\\s(\"]+|[(].*[)]): " text)
       (not (regexp-match? #rx"^(proved|refuted|undecided|equivalent): " text))))

;; These show what is refused.
(define refusals '(animation-save export-system graphics-save unequal-contraction))

(define needs-bigfloats #rx"bigfloat|ode-precision")

;; (card . texts), what the examples print
(define printed
  (for/list ([c (in-list (all-cards))]
             #:when (card-demonstration c)
             #:unless (and (not bigfloats?)
                           (regexp-match? needs-bigfloats (format "~s" (card-demonstration c)))))
    (cons c (printed-lines c))))

(test-case "the examples run by themselves; errors are only where they are shown"
  (define failing
    (for/list ([p (in-list printed)] #:when (ormap complaint? (cdr p))) (car p)))
  (check-equal? (names-of failing) refusals))

;; Messages are not broken into lines.
(test-case "no line that an example prints, but of formulas and messages, is longer than 78"
  (for* ([p (in-list printed)]
         #:unless (memq (card-name (car p)) (cons '^ refusals))
         [text (in-list (cdr p))]
         [line (in-list (string-split text "\n"))]
         #:unless (regexp-match? #rx"[()0-9]" line))
    (check-true (<= (string-length line) 78) line)))

;; The manual's output after the expressions of a card.
(define (manual-answers c)
  (define e (card-demonstration c))
  (define session (make-session))
  (define (evaluate form) (session form))
  (for ([library (in-list (example-libraries e))]) (evaluate `(require ,library)))
  (for-each evaluate (append-map read-all (example-definitions e)))
  (begin0 (for/list ([x (in-list (append-map read-all (example-expressions e)))])
            (define value (evaluate x))
            (words (call-in-sandbox-context session (lambda () (printed-by-session value)))))
          (close-session session)))

(define (printed-by-session value)
  (with-output-to-string (lambda () ((current-print) value))))

;; The manual's pages are narrower.
(define (words text) (string-normalize-spaces text))

(test-case "the results are those of the manual's prompts"
  (for ([name '(negate Lagrange-equations verify-conserved L-harmonic)])
    (define c (card-of name))
    (check-equal? (map words (printed-lines c)) (manual-answers c) (format "~s" name))))

(test-case "what an example declares or sets stays in it, and nothing of the caller's gets in"
  (define (results name) (printed-lines (card-of name)))
  (define before (results 'sqrt))
  (results 'assume)
  (check-equal? (assumptions) '())
  (define method (ode-integration-method))
  (results 'set-ode-integration-method!)
  (check-equal? (ode-integration-method) method)
  (assume '(< m 0))
  (check-equal? (results 'sqrt) before)
  (check-equal? (assumptions 'declared) '((< m 0)))
  (forget-assumptions))
