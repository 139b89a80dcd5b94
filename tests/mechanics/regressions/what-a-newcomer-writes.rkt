#lang racket/base
;; Lines of students in their first minutes, taken for something else in silence or
;; complained of in words of the inside.

(require racket/string
         mechanics
         (only-in mechanics/book L-harmonic L-pendulum)
         "../support/checks.rkt" "../support/messages.rkt"
         "../support/run-text.rkt")

(define (complaint . input)
  (define-values (output errors) (apply session '("-I" "mechanics") input))
  errors)

(test-case "a path beside the Lagrangian is no dissipation function"
  (check-message
   (string-append
    "Lagrange-equations: a dissipation function takes the local tuple (up t q v); given x, "
    "a literal function (-> Real Real), which takes 1 argument\n"
    "  a path comes in parentheses of its own: ((Lagrange-equations L) x)")
   (Lagrange-equations (L-harmonic 'm 'k) (literal-function 'x)))
  (check-not-exn (lambda () (Lagrange-equations (L-harmonic 'm 'k)
                                                (literal-function 'F (Lagrangian 1))))))

(test-case "the decimal pi is told to leave rounding; π itself is proved"
  (define L (L-pendulum 'g 'm 'l))
  (check-regexp-match #rx"note: 1.2246[0-9]*e-16 may be no more than what rounding leaves"
                      (format "~a" (verify-solution L (lambda (t) pi))))
  (check-pred proved? (verify-solution L (lambda (t) ':pi))))

(test-case "a form without its parentheses"
  (check-regexp-match #rx"define: stands first within parentheses, as in \\(define m 3\\)"
                      (complaint "define y 3"))
  (check-regexp-match #rx"let: stands first within parentheses, as in \\(let \\(\\[?\\(?m 3"
                      (complaint "let")))

(test-case "commas between arguments, and quotes on both sides of a symbol"
  (check-true (string-contains? (complaint "(up 1, 2)") "no comma separates arguments"))
  (check-true (string-contains? (complaint "‘x’") "‘ in it is a curly quote; type 'x\n")))
