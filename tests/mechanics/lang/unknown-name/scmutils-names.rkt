#lang racket/base
;; A name of scmutils that is typed without its library tells its replacement.

(require (for-label mechanics mechanics/scmutils)
         mechanics/lang/unknown-name/scmutils-names
         mechanics/lang/unknown-name/suggestion
         "../../support/checks.rkt" "../../support/house/exports.rkt")

(define (sorted names) (sort names symbol<?))

(test-case "each name of mechanics/scmutils has a replacement, and none that mechanics exports"
  (check-equal? (sorted scmutils-names) (sorted (own-names 'mechanics/scmutils)))
  (define ours (own-names 'mechanics))
  (check-equal? (filter (lambda (name) (memq name ours)) scmutils-names) '()))

(test-case "the replacement is what mechanics exports"
  (define table (export-table 'mechanics))
  (for ([name (in-list scmutils-names)])
    (define replacement
      (cadr (regexp-match #rx"scmutils' name of [(]?([^ );]+)" (scmutils-sentence name))))
    (check-true (hash-has-key? table (string->symbol replacement)) (format "~a" name))))

(test-case "at the prompt and in a program"
  (check-equal? (what-was-meant 'se '(sec set) #f)
                '("se is scmutils' name of show-expression; (require mechanics/scmutils) has it"
                  "as a symbol it is written 'se"))
  (check-equal? (suggestion 'Q '())
                "Q is scmutils' name of coordinate; (require mechanics/scmutils) has it")
  (define (message-of form)
    (define space (make-base-namespace))
    (with-handlers ([exn:fail:syntax? exn-message])
      (parameterize ([current-namespace space])
        (eval `(module program mechanics ,form)))))
  (check-regexp-match
   #rx"^LE: unbound identifier; LE is scmutils' name of Euler-Lagrange-operator; [(]require mech"
   (message-of '(LE square))))
