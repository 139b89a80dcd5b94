#lang racket/base
;; The tour: five screens at most, that show what they use.

(require compiler/find-exe
         racket/list
         racket/port
         racket/runtime-path
         racket/string
         "support/checks.rkt")

(define-runtime-path demo "../../examples/mechanics/demo.rkt")

(define rows 24)          ; of which the last is the prompt's
(define columns 80)

(define (run-demo)
  (define-values (process out in err)
    (subprocess #f #f 'stdout (find-exe) demo))
  (close-output-port in)
  (define text (port->string out))
  (close-input-port out)
  (subprocess-wait process)
  (values (subprocess-status process)
          (string-split (string-trim text "\n" #:left? #f) "\n" #:trim? #f)))

;; Lists of lines, each beginning with a title.
(define (in-screens lines)
  (define (title? line) (string-prefix? line "──"))
  (let loop ([lines lines] [screens '()])
    (cond [(null? lines) (reverse screens)]
          [else
           (define-values (body others) (splitf-at (cdr lines) (lambda (l) (not (title? l)))))
           (loop others (cons (cons (car lines) body) screens))])))

(define-values (code lines) (run-demo))
(define screens (in-screens lines))

(test-case "the tour ends well, and waits for nobody where there is no terminal"
  (check-equal? code 0)
  (check-false (ormap (lambda (line) (regexp-match? #rx"Enter" line)) lines)))

(test-case "it has five screens at most, that fit a terminal with a line to wait in"
  (check-true (<= 3 (length screens) 5))
  (for ([screen (in-list screens)])
    (check-true (< (length screen) rows) (car screen))
    (for ([line (in-list screen)])
      (check-true (<= (string-length line) columns) line))))

(test-case "it shows the definition of what it uses, before the use"
  (define text (string-join lines "\n"))
  (for ([name '("L-free" "straight" "L-harmonic" "proposed" "L-Kepler" "orbit" "hanging" "x" "r")])
    (define uses (regexp-match-positions* (pregexp (format "[ (]~a[ )\n]" (regexp-quote name)))
                                          text))
    (define shown
      (regexp-match-positions (pregexp (format "> \\(define [(]*~a[ )]" (regexp-quote name))) text))
    (check-true (pair? uses) name)
    (check-true (and shown (<= (caar shown) (caar uses))) name)))
