#lang racket/base
;; `require` at the prompt, after definitions.

(require racket/string
         "../../support/checks.rkt" "../../support/run-text.rkt")

;; The output and the errors at a prompt where nothing was defined, each a list of lines.
(define ask (open-fresh-prompt))
(define (talk . input)
  (define-values (output errors) (apply ask input))
  (values output (string-split errors "\n")))

(test-case "a definition is not replaced, and that is said with its signature"
  (define-values (output errors)
    (talk "(define ((L-pendulum m l g) local) (list 'mine m l g))"
          "(require mechanics/book)"
          "((L-pendulum 1 2 3) 'local)"
          "L-harmonic"))
  (check-equal? output '("'(mine 1 2 3)" "L-harmonic"))
  (check-equal? errors
                '("; mechanics/book: your own definitions stay"
                  ";   (L-pendulum m l g); the library's is ((L-pendulum g m l) local)"
                  ";   the library's: (require (prefix-in its: mechanics/book)), then its:L-pendulum")))

(test-case "nor is one in the module that the prompt belongs to"
  (define-values (output errors)
    (session '("-l" "racket/base" "-l" "racket/enter" "-i")
             "(module m mechanics (define (first x) (list 'mine x)))"
             "(enter! 'm)"
             "(require racket/list)"
             "(list (first 1) (second '(1 2)))"))
  (check-equal? output '("'((mine 1) 2)"))
  (check-equal? errors
                (lines "; racket/list: your own definitions stay"
                       ";   first"
                       ";   the library's: (require (prefix-in its: racket/list)), then its:first")))

(test-case "what is asked for by name replaces it"
  (define-values (output errors)
    (talk "(define (first x) 'mine)" "(require (only-in racket/list first))" "(first '(1 2))"))
  (check-equal? output '("1"))
  (check-equal? errors '()))

(test-case "a definition after a require is the reader's, and stays so at the next"
  (define-values (output errors)
    (talk "(require racket/list)" "(define (first x) 'mine)" "(first '(1 2))"
          "(require (only-in racket/list second) racket/list)" "(first '(1 2))" "(second '(1 2))"))
  (check-equal? output '("mine" "mine" "2"))
  (check-equal? (length errors) 4))

(test-case "a procedure finds what is required after it, with keywords or without"
  (define-values (output errors)
    (talk "(define (draw) (plot-point (frame 0 1 0 1) 1/2 1/2))"
          "(define (line) (plot-function (frame 0 1 0 1) sin 0 1 #:samples 3))"
          "(require mechanics/plot)"
          "(void (draw))"
          "'drawn"))
  (check-equal? output '("drawn"))
  (check-equal? errors '()))

(test-case "what cannot be required is told as ever, and the rest is required"
  (define-values (output errors)
    (talk "(require 5)" "(require (only-in racket/list first) no-such-library)" "(first '(1 2))"))
  (check-equal? output '("1"))
  (check-regexp-match #rx"bad syntax for require sub-form" (string-join errors "\n"))
  (check-regexp-match #rx"collection not found" (string-join errors "\n")))

(test-case "whatever syntax a library exports, it is required without a word"
  (define-values (output errors)
    (talk "(define (g) (thrice 2))"
          "(module m racket/base (provide thrice shout) (define (thrice x #:by [n 3]) (* n x))"
          "  (require (for-syntax racket/base))"
          "  (define-syntax (shout stx)"
          "    (if (identifier? stx) #'(displayln 'used) (cadr (syntax-e stx)))))"
          "(require 'm)"
          "(g)"
          "(require mechanics racket/unit)"
          "(+ 1 1)"))
  (check-equal? output '("6" "2"))
  (check-equal? errors '()))

(test-case "what is required twice in one form is told once, and 'm is written so"
  (define-values (output errors)
    (talk "(module m racket/base (provide a) (define a 3))" "(define a 4)" "(require 'm 'm)" "a"))
  (check-equal? output '("4"))
  (check-equal? errors
                '("; 'm: your own definitions stay"
                  ";   a"
                  ";   the library's: (require (prefix-in its: 'm)), then its:a")))

(test-case "a definition that hides a name of a library is told once, with how to get that back"
  (define-values (output errors)
    (talk "(define D 3)" "(define (sin x) 'mine)" "(define D 4)" "(sin 1)"
          "(require (only-in mechanics D))" "((D square) 3)" "(define mine 3)" "(define mine 4)"
          "(require mechanics/plot)" "(define (frame x) x)"))
  (define (said name library)
    (format (string-append "; ~a: your definition hides the one of ~a; "
                           "(require (only-in ~a ~a)) brings that back")
            name library library name))
  (check-equal? output '("mine" "6"))
  (check-equal? errors (list (said 'D 'mechanics) (said 'sin 'mechanics)
                             (said 'frame 'mechanics/plot))))
