#lang racket/base
;; Results in the style that the reader chose, and in the one that fits the place.

(require mechanics
         mechanics/scmutils
         (only-in mechanics/show/display/waiting-remark announcement-delay)
         (only-in mechanics/show/display/display-style manner-here styles)
         (only-in mechanics/generic/notation prop:notation)
         (only-in mechanics/lang/printer install-printer! print-result)
         (only-in mechanics/show/plot/on-demand why-not)
         file/convertible
         racket/port
         racket/pretty
         racket/string
         "../../support/checks.rkt"
         "../../support/messages.rkt" "../../support/run-text.rkt" "../../support/skip.rkt")

(define ratio (/ (sqrt (square 'r)) 'theta_1))

(define (printed style x)
  (with-output-to-string
    (lambda () (parameterize ([display-style style]) (print-expression x)))))

(test-case "in a port of text results are S-expressions, unless something else is chosen"
  (for ([style '(automatic expression)])
    (check-equal? (printed style ratio) (lines "(/ r theta_1)" "; assuming (>= r 0)")))
  (for ([style '(text typeset)])
    (check-equal? (printed style ratio) (lines " r" "────" " θ₁" "; assuming r ≥ 0")))
  (check-equal? (printed 'infix ratio) (lines "r/θ₁" "; assuming r ≥ 0"))
  (check-equal? (printed 'TeX ratio) (lines "\\frac{r}{\\theta_{1}}" "% assuming r ≥ 0"))
  (check-regexp-match #rx"^<math .*</math>\n<!-- assuming r ≥ 0 -->\n$" (printed 'MathML ratio)))

(test-case "what is no mathematics is the same in all styles, and functions have their names"
  (for ([style (in-list styles)])
    (check-equal? (printed style "text") "\"text\"\n")
    (check-equal? (printed style 1/2) "1/2\n")
    (check-equal? (printed style (list 1 2)) "'(1 2)\n")
    (check-equal? (printed style (lambda (x) x)) "<function>\n"))
  (check-equal? (printed 'text sin) "sin\n"))

(test-case "the elements of a list are in the style, too"
  (check-equal? (printed 'infix (list 1 (/ 'a 'b) (up 'c))) "list(1, a/b, up(c))\n")
  (check-equal? (printed 'text (list 'a (square 'b))) "a, b²\n"))

(test-case "what contains itself is written by Racket, in all styles"
  (define v (vector 1 'a))
  (vector-set! v 0 v)
  (for ([style (in-list styles)])
    (check-equal? (printed style v) "#0='#(#0# a)\n")))

(test-case "an unknown style is refused, with those there are"
  (define message
    (string-append "~a: there is no such style\n  styles: 'automatic, 'typeset, 'text, 'infix, "
                   "'TeX, 'MathML, 'expression\n  given: 'latex"))
  (check-message (format message 'display-style) (display-style 'latex))
  (check-message (format message 'print-expression) (print-expression 'a #:as 'latex))
  (check-message (format message 'show-expression) (se 'a #:as 'latex))
  (check-equal? (display-style) 'automatic))

(test-case "one result in a style of its own; to show is to typeset"
  (define (text-of print . arguments) (with-output-to-string (lambda () (apply print arguments))))
  (check-equal? (with-output-to-string (lambda () (pe (/ 'a 'b) #:as 'infix))) "a/b\n")
  (check-equal? (with-output-to-string (lambda () (se (/ 'a 'b) #:as 'expression))) "(/ a b)\n")
  (for ([show (in-list (list se show-expression))])
    (check-equal? (text-of show (/ 'a 'b)) (lines " a" "───" " b"))))

(test-case "the prompt has the style of the session"
  (check-equal? (answers "(/ 'a 'b)" "(display-style 'infix)" "(/ 'a 'b)" "(display-style)"
                         "(display-style 'automatic)" "(/ 'a 'b)")
                '("(/ a b)" "a/b" "infix" "(/ a b)"))
  (parameterize ([display-style 'automatic])
    (check-equal? (prints "(display-style 'infix)" "(up 'a (/ 'b 'c))") "up(a, b/c)\n")))

;; ---------------------------------------------------------------------------
;; Values that cannot be typeset

;; A value whose notation does this.
(struct troublesome (act)
  #:property prop:custom-print-quotable 'never
  #:property prop:custom-write (lambda (x port mode) (write-string "(troublesome)" port))
  #:property prop:notation (lambda (x see) ((troublesome-act x))))

(define (raising . parts) (troublesome (lambda () (apply raise-user-error 'layout parts))))

(test-case "where typesetting fails the result is as it was before, and why"
  (for ([style '(text infix TeX MathML)])
    (check-equal? (printed style (raising "gave\n  up"))
                  (lines "(troublesome)" "; not typeset: layout: gave; up"))))

(test-case "a break while a result is typeset leaves its plain form"
  (define interrupted
    (troublesome (lambda () (break-thread (current-thread)) (sleep 30) 'done)))
  (define errors (open-output-string))
  (define output
    (with-output-to-string
      (lambda ()
        (parameterize ([current-print (current-print)] [current-error-port errors]
                       [display-style 'text] [announcement-delay #f])
          (install-printer!)
          ((current-print) interrupted)
          ((current-print) (/ 'a 'b))))))
  (check-equal? output (lines "(troublesome)" " a" "───" " b"))
  (check-equal? (get-output-string errors) "; interrupted; the result as computed:\n"))

;; ---------------------------------------------------------------------------
;; Pictures

(test-case "a port of text has no pictures; one that takes them has, and its style is minded"
  (check-equal? (manner-here) 'expression)
  (check-equal? (manner-here 'typeset) 'text)
  (define-values (in out) (make-pipe-with-specials))
  (parameterize ([current-output-port out])
    (check-equal? (manner-here) 'picture)
    (check-equal? (manner-here 'text) 'text)))

;; As examples of Scribble are printed, and results in notebooks.
(test-case "on a page a result is one picture, and what is no mathematics is text"
  (define-values (in out) (make-pipe-with-specials))
  (parameterize ([current-output-port out]
                 [current-print pretty-print-handler]
                 [pretty-print-size-hook (lambda (x display? port) (and (convertible? x) 1))]
                 [pretty-print-print-hook (lambda (x display? port) (write-special x port))])
    (for-each print-result (list "text" ratio 3)))
  (close-output-port out)
  (define parts (let loop ()
                  (define c (read-char-or-special in))
                  (if (eof-object? c) '() (cons c (loop)))))
  (define pictures (filter convertible? parts))
  (check-equal? (list->string (filter char? parts)) "\"text\"\n\n3\n")
  (check-equal? (length pictures) 1)
  (check-equal? (convert (car pictures) 'text) "(/ r theta_1)\n; assuming (>= r 0)")
  (skip-unless (not (why-not))
               "the shared libraries of racket/draw are not installed: no pictures of formulas"
    (check-equal? (subbytes (convert (car pictures) 'png-bytes) 1 4) #"PNG")
    (check-true (regexp-match? #rx#"<svg " (convert (car pictures) 'svg-bytes)))
    (check-equal? (subbytes (convert (car pictures) 'pdf-bytes) 0 4) #"%PDF")))

(test-case "to typeset is to make what prints as text, and is converted to pictures"
  (define t (typeset ratio))
  (check-equal? (format "~a|~s|~v" t t t)
                (string-join (for/list ([_ 3]) "(/ r theta_1)\n; assuming (>= r 0)") "|"))
  (check-equal? (convert t 'text) "(/ r theta_1)\n; assuming (>= r 0)")
  (check-false (convert t 'no-such-format))
  (check-equal? (convert t 'no-such-format 'default) 'default)
  (check-equal? (typeset "text") "text"))
