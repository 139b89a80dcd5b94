#lang racket/base
;; display, format and the printer of results went round without end in a list that contains
;; itself, directly or behind a pair.

(require mechanics
         racket/port
         "../support/checks.rkt" "../support/run-text.rkt")

;; The value that `make` gives when it is given a place for itself.
(define (knot make)
  (define hole (make-placeholder #f))
  (placeholder-set! hole (make hole))
  (make-reader-graph hole))

(define inside (knot (lambda (itself) (list 1 itself))))
(define behind (knot (lambda (itself) (cons 1 itself))))
(define row (vector 'x 1))
(vector-set! row 1 row)

(define-syntax-rule (text expression) (with-output-to-string (lambda () expression)))

(test-case "they are printed as by Racket"
  (check-equal? (text (display inside)) "#0=(1 #0#)")
  (check-equal? (text (println inside)) "#0='(1 #0#)\n")
  (check-equal? (text (print-expression behind)) "#0='(1 . #0#)\n")
  (check-equal? (format "~a ~s ~a" inside behind row) "#0=(1 #0#) #0=(1 . #0#) #0=#(x #0#)"))

(test-case "so is a result of a program"
  (check-equal? (prints "(define l (vector 1 2))" "(vector-set! l 1 l)" "l") "#0='#(1 #0#)\n"))

(test-case "what is shared and no circle is printed as it is"
  (define pair (list (+ 'a 'a) 1))
  (check-equal? (text (display (list pair pair))) "(((* 2 a) 1) ((* 2 a) 1))"))
