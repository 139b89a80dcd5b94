#lang racket/base
;; The page to hand out, as TeX: formulas as they are drawn, keys for the teacher alone.

(require mechanics/show/document/TeX-document
         (only-in mechanics/teaching/worksheet/exercise formula)
         mechanics/teaching/worksheet/handout
         mechanics/teaching/worksheet/make-exercise
         mechanics/teaching/worksheet/make-worksheet
         (only-in mechanics/value/read-expression read-expression)
         "../../support/checks.rkt")

(define key (read-expression '(* m ((D x) t))))
(define momentum
  (make-exercise 'momentum 'expression "Of `(* 1/2 m ((D x) t))`, twice?" (list (list 'key key))))
(define told (formula "It is said that" (read-expression '(* k ((D y) t)))))
(define w (make-worksheet "W" #f "w" (list told momentum)))

(define (TeX answers?)
  (define-values (text files) (document->TeX (worksheet->document w #:answers? answers?) "w"))
  text)

(test-case "a formula that is told is typeset, too"
  (check-regexp-match #rx"It is said that.*k.*dot[^t]*y.*Of" (TeX #f)))

(test-case "a key is typeset as a formula in a question is, and only for the teacher"
  (check-regexp-match #rx"Of.*frac.*dot.*twice" (TeX #f))
  (check-false (regexp-match? #rx"Key:" (TeX #f)))
  (check-regexp-match #rx"Key:.*m.*dot[^t]*x" (TeX #t)))
