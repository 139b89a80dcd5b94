#lang racket/base
;; Formulas in the text of the manual, as @formula{½ m ẋ²} has them.

(require racket/file
         racket/list
         racket/runtime-path
         (only-in xml document-element read-xml xml->xexpr xexpr-drop-empty-attributes)
         "support/checks.rkt" "../../scribblings/mechanics/look/formula.rkt")

(define-runtime-path manual "../../scribblings/mechanics")

;; Formulas as they stand in the sources.
(define formulas
  (remove-duplicates
   (append*
    (for/list ([file (in-directory manual)] #:when (regexp-match? #rx"[.]scrbl$" file))
      (regexp-match* #rx"@formula{([^{}@]*)}" (file->string file) #:match-select cadr)))))

(define (parsed markup)
  (parameterize ([xexpr-drop-empty-attributes #t])
    (xml->xexpr (document-element (read-xml (open-input-string markup))))))

(define (children x) (cddr x))

(test-case "every formula of the manual is well-formed, and has no combining dot left"
  (check-true (> (length formulas) 40))
  (for ([f (in-list formulas)])
    (define markup (formula->markup f))
    (check-eq? (car (parsed markup)) 'math f)
    (check-false (regexp-match? #px"[\u307\u308\u20DB]" markup) f)))

(test-case "what read-infix knows is typeset as results are"
  (check-equal? (children (parsed (formula->markup "½ θ\u307²")))
                '((mrow (mfrac (mn "1") (mn "2")) (mspace ((width "0.17em")))
                        (msup (mover (mi "θ") (mo ((stretchy "false")) "˙")) (mn "2"))))))

(test-case "what it does not know is typeset sign by sign"
  (define (signs text)
    (filter (lambda (x) (not (and (pair? x) (eq? (car x) 'mspace))))
            (children (parsed (formula->markup text)))))
  (check-equal? (signs "∂L/∂θ\u307")
                '((mfrac (mrow (mo ((stretchy "false")) "∂") (mi "L"))
                         (mrow (mo ((stretchy "false")) "∂")
                               (mover (mi "θ") (mo ((stretchy "false")) "˙"))))))
  (check-equal? (signs "h²D²/2!")
                '((msup (mi "h") (mn "2")) (msup (mi "D") (mn "2")) (mo ((stretchy "false")) "/")
                  (mn "2") (mo ((stretchy "false")) "!")))
  (check-equal? (signs "|x|")
                '((mo ((stretchy "false")) "|") (mi "x") (mo ((stretchy "false")) "|")))
  (check-equal? (signs "f′ <") '((mi "f") (mo ((stretchy "false")) "′")
                                 (mo ((stretchy "false")) "<"))))
