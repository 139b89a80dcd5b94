#lang racket/base
;; display and its kin show what the prompt would.

(require racket/port
         mechanics
         (only-in mechanics/book L-harmonic)
         (only-in mechanics/show/display/result simplified-result)
         "../../support/checks.rkt" "../../support/run-text.rkt")

(define one (+ (square (sin 'x)) (square (cos 'x))))
(define-syntax-rule (text expression ...) (with-output-to-string (lambda () expression ...)))

(test-case "a value of ours is simplified, with what that took for granted beneath"
  (check-equal? (text (displayln one) (display one) (println one) (print one)) "1\n11\n1")
  (check-equal? (text (displayln (up (+ 'a 'a) 'b))) "(up (* 2 a) b)\n")
  (check-equal? (text (displayln (sqrt (square 'm)))) "m\n; assuming (>= m 0)\n")
  (check-equal? (text (displayln (list (+ 'a 'a) "s" 3))) "((* 2 a) s 3)\n")
  (for ([x (list (list (sqrt (square 'm))) (list (list (sqrt (square 'm))))
                 (vector (sqrt (square 'm))))])
    (check-regexp-match #rx"m[)]+\n; assuming [(]>= m 0[)]\n$" (text (displayln x))))
  (check-equal? (text (displayln (vector 1 (+ 'a 'a)))) "#(1 (* 2 a))\n")
  (check-equal? (text (displayln (prove-zero 0))) "proved: the residual is zero\n"))

(test-case "a long one is broken into lines"
  (define residual
    (((Lagrange-equations (L-harmonic 'm 'k))
      (lambda (t) (* 'a (exp (* 'gamma t)) (cos (+ (* 'omega t) 'phi)))))
     't))
  (check-true (> (length (regexp-match* #rx"\n" (text (displayln residual)))) 2))
  (check-equal? (length (regexp-match* #rx"\n" (text (printf "~a\n" residual)))) 1))

(test-case "functions print by their names"
  (check-equal? (text (displayln (L-harmonic 'm 'k))) "L-harmonic\n")
  (check-equal? (format "~a ~a" sin (D sin)) "sin (D sin)"))

(test-case "values within a text are simplified, on one line"
  (check-equal? (format "~a and ~a, ~s ~v" one 3 "s" (up (+ 'a 'a))) "1 and 3, \"s\" (up (* 2 a))")
  (check-equal? (format "~a" (list (+ 'a 'a) sin)) "((* 2 a) sin)")
  (check-equal? (text (printf "~a\n" one)) "1\n")
  (check-equal? (format "~a" (sqrt (square 'm))) "(abs m)")
  (check-equal? (text (fprintf (current-output-port) "~a" one)) "1")
  (check-equal? (text (parameterize ([current-error-port (current-output-port)])
                        (eprintf "~a" one)))
                "1"))

(test-case "all else is printed as in Racket, and to a port that is given"
  (check-equal? (text (display "s") (print "s") (println '(a b)) (display 'a) (displayln #\b))
                "s\"s\"'(a b)\nab\n")
  (define port (open-output-string))
  (display (+ 'a 'a) port)
  (displayln 1.5 port)
  (print '(1) port 1)
  (println one port)
  (check-equal? (get-output-string port) "(* 2 a)1.5\n(1)1\n")
  (check-equal? (text (write (+ 'a 'a))) "(+ a a)")
  (check-equal? (map object-name (list display displayln print println printf format))
                '(display displayln print println printf format)))

(define ask (open-prompt "-I" "mechanics"))

(test-case "a symbol spelt like π in a result is told once in a session, beside the results"
  (define-values (output errors)
    (ask "(sin 'pi)" "(up 'pi 1)" "(cos ':pi)"))
  (check-equal? output '("(sin pi)" "(up pi 1)" "-1"))
  (check-equal? errors
                "; the symbol pi is an unknown like others; the number π is written ':pi\n"))

(test-case "growth is told where a frequency is not real"
  (define L "(lambda (s) (+ (square (velocity s)) (* 4 (square (coordinate s)))))")
  (define-values (output errors)
    (ask (format "(normal-modes ~a 0)" L)
         (format "(small-oscillation-frequencies ~a 0)" L)))
  (check-equal? output '("(list (up 0+2i 1))" "'(0+2i)"))
  (check-equal? errors
                (lines (string-append "; a frequency that is not real belongs to no oscillation: "
                                      "this one grows as (exp (* 2 t)); the equilibrium is unstable"))))

(test-case "what contains itself is shown as Racket shows it"
  (define v (vector 1 2))
  (vector-set! v 0 v)
  (check-equal? (format "~a" v) "#0=#(#0# 2)"))

(test-case "within a vector procedures are told as they are alone, where there is a width"
  (define v (vector (lambda (x) x) sin (+ 'a 'a)))
  (check-equal? (format "~v" (simplified-result v 40)) "(vector <function> sin (* 2 a))")
  (check-regexp-match #rx"^.vector #<procedure.*> #<procedure:sin> .[*] 2 a[)][)]$"
                      (format "~v" (simplified-result v #f))))
