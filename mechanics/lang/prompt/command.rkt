#lang racket/base
;; Commands of the prompt: words after a comma, and common commands without one, help, ?, quit,
;; exit, as long as the reader has not defined them.

(require "typed-forms.rkt"
         "../printer.rkt"
         (only-in "../redefinition/prompt.rkt" variable-name?)
         "../../show/display/display-style.rkt")

(provide command? run-command)

(define (command? text)
  (or (regexp-match? #px"^\\s*," text)
      (and (as-command text) #t)))

;; -> forms to evaluate in place of the command, or eof to end the session
(define (run-command text)
  (define found
    (regexp-match #px"^\\s*,\\s*([^\\s()]*)\\s*(.*?)\\s*$" (or (as-command text) text)))
  (define-values (name argument) (values (cadr found) (caddr found)))
  (cond [(equal? argument "")
         (case name
           [("help" "h" "?") (print-commands) '()]
           [("more" "m") (print-more) '()]
           [("quit" "q" "exit") eof]
           [else (style-command name) '()])]
        [(member name '("help" "h" "?")) (help-on argument)]
        [else (print-unknown name) '()]))

;; ,help NAME is the form (help NAME), and ,help SOME WORDS is (help "SOME WORDS"), if the language
;; has them.  text : after ,help -> forms to evaluate
(define (help-on text)
  (cond [(memq 'help (namespace-mapped-symbols))
         (list (datum->syntax #f (list 'help (or (single-subject text) text))))]
        [else
         (printf "there is no help on names here; the manual has it: make docs\n")
         '()]))

;; -> identifier, a string as (help "words") has it, or #f
(define (single-subject text)
  (define forms (with-handlers ([exn:fail:read? (lambda (e) '())]) (forms-in text)))
  (and (= 1 (length forms))
       (or (identifier? (car forms)) (string? (syntax-e (car forms))))
       (car forms)))

;; quit, quit(), help, help D, ?, ? D, ?D -> the same with a comma, or #f
(define (as-command text)
  (define found
    (or (regexp-match #px"^\\s*(quit|exit|bye)\\s*(?:\\(\\s*\\))?\\s*()$" text)
        (regexp-match #px"^\\s*(help)(?:\\s*\\(\\s*\\)|\\s+([^\\s(].*)|)$" text)
        (regexp-match #px"^\\s*(\\?)\\s*([^\\s(?].*|)$" text)))
  (and found
       (not (variable-name? (string->symbol (cadr found))))
       (format ",~a ~a" (if (equal? (cadr found) "bye") "quit" (cadr found))
               (or (caddr found) ""))))

;; ---------------------------------------------------------------------------
;; Styles: the command is the style's name in small letters

;; Shows results in that style from now on, the last one at once.
(define (style-command name)
  (define style
    (findf (lambda (s) (string=? name (string-downcase (symbol->string s)))) styles))
  (cond [style
         (display-style style)
         (unless (print-last) (printf "; results are shown so from now on\n"))]
        [else (print-unknown name)]))

;; ---------------------------------------------------------------------------

(define (print-commands)
  (write-string #<<text
,help         this list
,help NAME    what is known of a name, as (help NAME) says
,more         the next screen of a long result
,text         shows results as formulas of several lines, the last one at once;
,infix        on one line;  ,tex  as TeX;  ,mathml  as MathML;
,expression   as S-expressions, as in the beginning
,quit         leave; so does Ctrl-D
Tab completes a name, the arrow keys bring back what was typed, Ctrl-C stops.

text
                ))

(define (print-unknown name)
  (printf ",~a is no command; ,help lists them\n" name))
