#lang racket/base
;; The prompt's commands that choose how results are shown.

(require "../../support/checks.rkt" "../../support/run-text.rkt")

;; Answers of the prompt, line by line, the banner left out.
(define (answers-to . input)
  (define-values (output errors) (apply session '("-l" "mechanics/lang/prompt/start") input))
  (check-equal? errors "")
  (cddr output))

;; In MathML
(define omega
  (string-append "<math xmlns=\"http://www.w3.org/1998/Math/MathML\" display=\"block\">"
                 "<mi mathvariant=\"normal\">Ω</mi></math>"))

(test-case "a style is chosen, and the last result is shown in it"
  (check-equal? (answers-to "(/ 'a 'theta_1)" ",text" "(/ 'b 'Omega)" ",tex" ",infix" "'Omega"
                            ",mathml")
                `("(/ a theta_1)"
                  " a" "────" " θ₁"
                  " b" "───" " Ω"
                  "\\frac{b}{\\Omega}"
                  "b/Ω"
                  "Ω"
                  ,omega)))

(test-case "S-expressions come back"
  (check-equal? (answers-to ",infix" "(/ 'a 'b)" ",expression" "(/ 'b 'a)")
                '("; results are shown so from now on" "a/b" "(/ a b)" "(/ b a)")))

(test-case "the command is what display-style says, and an unknown one is refused"
  (check-equal? (answers-to ",infix" "(display-style)" ",latex" "(display-style)" ",automatic"
                            "(display-style)")
                '("; results are shown so from now on" "infix"
                  ",latex is no command; ,help lists them" "infix"
                  "infix"                ; the last result again
                  "automatic"))
  (check-not-false (member ",infix        on one line;  ,tex  as TeX;  ,mathml  as MathML;"
                           (answers-to ",help"))))
