#lang racket/base
;; Commands of the prompt: what is typed after a comma, and words that are commands elsewhere,
;; as long as the reader has not defined them: help, ?, quit, exit.

(require "help-command.rkt"
         "../printer.rkt"
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

;; quit, quit(), help, help D, ?, ? D, ?D -> the same with a comma, or #f
(define (as-command text)
  (define found
    (or (regexp-match #px"^\\s*(quit|exit|bye)\\s*(?:\\(\\s*\\))?\\s*()$" text)
        (regexp-match #px"^\\s*(help)(?:\\s*\\(\\s*\\)|\\s+([^\\s(].*)|)$" text)
        (regexp-match #px"^\\s*(\\?)\\s*([^\\s(?].*|)$" text)))
  (and found
       (not (defined? (string->symbol (cadr found))))
       (format ",~a ~a" (if (equal? (cadr found) "bye") "quit" (cadr found))
               (or (caddr found) ""))))

(define (defined? name)
  (with-handlers ([exn:fail:contract:variable? (lambda (e) #f)] [exn:fail:syntax? (lambda (e) #f)])
    (namespace-variable-value name #f)
    #t))

;; ---------------------------------------------------------------------------
;; Styles: the command is the style's name in small letters

;; Results are shown so from now on, the last one at once.
(define (style-command name)
  (define style
    (for/first ([s (in-list styles)]
                #:when (string=? name (string-downcase (symbol->string s))))
      s))
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
