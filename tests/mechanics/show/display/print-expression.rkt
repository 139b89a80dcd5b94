#lang racket/base
;; print-expression shows a value as the prompt shows a result.

(require mechanics
         mechanics/scmutils
         (only-in mechanics/error/note start-session-of-notes!)
         (only-in mechanics/show/display/print-expression print-labelled)
         mechanics/lang/printer
         racket/string
         "../../support/checks.rkt")

(define (text-of show x)
  (define port (open-output-string))
  (parameterize ([current-output-port port])
    (show x))
  (get-output-string port))

(test-case "a value is printed simplified, with what that assumed beneath it"
  (check-equal? (text-of print-expression (+ 'a 'a)) "(* 2 a)\n")
  (check-equal? (text-of print-expression (up (sqrt (square 'r)) 1))
                "(up r 1)\n; assuming (>= r 0)\n"))

(test-case "lists are Racket's to print, their elements simplified"
  (check-equal? (text-of print-expression (list 1 (+ 'a 'a))) "(list 1 (* 2 a))\n")
  (check-equal? (text-of print-expression "text") "\"text\"\n"))

(test-case "the short names print the same"
  (define x (* 'a 'b 'a))
  (check-equal? (text-of pe x) (text-of print-expression x))
  (check-equal? (text-of se x) (text-of show-expression x)))

(test-case "the prompt answers the same"
  (for ([x (in-list (list (+ 'a 'a) (list (+ 'a 'a) "b") (vector (+ 'a 'a)) "text" 1/2 sin
                          (up 'a (sqrt (square 'r))) (prove-zero (- 'a 'b)) (list)))])
    (check-equal? (text-of print-expression x) (text-of print-result x))))

(test-case "a labelled value is indented on all its lines, which keep within the width"
  (define long (for/fold ([sum 0]) ([i 20]) (+ sum (* 'alpha (sin (* i 'omega))))))
  (define lines (string-split (text-of (lambda (x) (print-labelled '(f t) x)) long) "\n"))
  (check-equal? (car lines) "(f t)")
  (check-true (> (length lines) 3))
  (check-regexp-match #rx"^  [(][+] " (cadr lines))
  (for ([l (in-list (cddr lines))])
    (check-regexp-match #rx"^     +[^ ]" l))
  (for ([l (in-list lines)]) (check-true (<= (string-length l) 79))))

(test-case "a quoted list is shown as a list, with a note"
  (define errors (open-output-string))
  (start-session-of-notes!)
  (parameterize ([current-error-port errors])
    (check-equal? (text-of print-expression '(+ x x)) "'(+ x x)\n"))
  (check-equal? (get-output-string errors)
                "; a quoted list is no expression; read-expression makes one of it\n"))
