#lang racket/base
;; Values as results in lines: reports and lists laid out, each value looked at once, what a picture
;; says elsewhere.

(require file/convertible
         (only-in racket/list dropf takef)
         racket/string
         mechanics
         mechanics/show/display/result mechanics/show/display/result-lines
         (only-in mechanics/show/display/display-style manner-here)
         (only-in mechanics/verdict/verdict verdict-lines)
         "../../support/checks.rkt")

(define (lines-of text) (string-split text "\n" #:trim? #f))
(define (longest text) (apply max (map string-length (lines-of text))))

(define refuted
  (verify-equal (+ 'alpha 'beta 'gamma 'delta 'epsilon 'zeta) (* 'eta 'theta 'iota)))

(test-case "a report says the same on lines of any width, and none is longer"
  (define whole (value->lines refuted 100000))
  (check-equal? (length (lines-of whole)) (length (verdict-lines refuted)))
  (for ([width (in-range 40 100)])
    (define text (value->lines refuted width))
    (check-equal? (string-split text) (string-split whole))
    (check-true (<= (longest text) width) text)))

(define (at? line) (string-prefix? line "  at: "))

;; The lines of the point where it is refuted
(test-case "an equation begins a line where it has no room on the last, and only there"
  (for ([width (in-range 40 100)])
    (define lines
      (takef (dropf (lines-of (value->lines refuted width)) (lambda (l) (not (at? l))))
             (lambda (l) (or (at? l) (string-prefix? l "      ")))))
    (for ([line lines] [next (if (null? lines) '() (cdr lines))])
      (define equation (car (regexp-match #px"[a-z]+ = \\d,?" next)))
      (check-true (> (+ (string-length line) 1 (string-length equation)) width) line))))
(define proved (verify-equal 'x 'x))

(test-case "verdicts in a list begin a line each, and so do values that are too long together"
  (define (shown x) (lines-of (format "~v" (simplified-result x 79))))
  (define one (car (shown proved)))
  (check-equal? (shown (list proved proved))
                (list (format "(list ~a" one) (format "      ~a)" one)))
  (define long (for/fold ([sum 0]) ([k 4]) (+ sum (sin (* (+ k 1) 'omega 't)))))
  (define lines (shown (list 1 long long)))
  (check-equal? (car lines) "(list 1")
  (check-true (>= (length lines) 3)))

(test-case "a value is looked at once; a procedure stays itself where nobody asks for text"
  (define see (seen-once))
  (define x (+ 'a 'a))
  (check-eq? (see x) (see x))
  (define-values (shown notes) (shown-throughout (list (+ 'a 'a) (lambda (x) x))))
  (check-equal? (car shown) (* 2 'a))
  (check-pred procedure? (cadr shown)))

(test-case "a picture is elsewhere the text with its assumptions"
  (define p (simplified-result (sqrt (square 'r)) 79 'picture))
  (check-equal? (convert p 'text) "r\n; assuming (>= r 0)"))

(test-case "typeset is text where pictures are not shown"
  (parameterize ([current-output-port (open-output-string)])
    (check-equal? (map manner-here '(automatic typeset infix)) '(expression text infix))))
