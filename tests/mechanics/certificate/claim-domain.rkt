#lang racket/base
;; The domain of a claim: each part of it that may lack a value gives a hypothesis, in the words of
;; the certificate.

(require mechanics
         "../support/checks.rkt" "../support/messages.rkt")

;; Of (1 + u)² = 1 + 2 u + u²
(define (hypotheses-with u)
  (define words
    (format "~a" (certificate (verify-equal (square (+ 1 u)) (+ 1 (* 2 u) (square u))))))
  (define found (regexp-match #rx" under (.*); the derivatives are ours$" words))
  (and found (cadr found)))

(test-case "functions with a domain of their own"
  (for ([(u expected)
         (in-hash (hash (sin 'x) #f                        (exp 'x) #f
                        (atan 'x) #f                       (expt 'x 2) #f
                        (tan 'x) "cos x <> 0"              (sqrt 'x) "0 <= x"
                        (log 'x) "0 < x"                   (/ 1 'x) "x <> 0"
                        (asin 'x) "- 1 <= x, x <= 1"       (acos 'x) "- 1 <= x, x <= 1"
                        (expt 'x -3) "x <> 0"              (expt 'x -1/2) "0 < x"
                        (expt 'x 3/2) "0 <= x"             (expt 'x 'k) "0 < x"))])
    (check-equal? (hypotheses-with u) expected (format "~a" u))))

(test-case "what holds of numbers is no hypothesis, and the same one stands once"
  (check-equal? (hypotheses-with (+ (sqrt 3) (tan 'x))) "cos x <> 0")
  (check-equal? (hypotheses-with (+ (/ 'y 'x) (/ 'z 'x))) "x <> 0"))

(when (directory-exists? "/proc")
  (test-case "where a certificate cannot be written, that is told in its name"
    (check-regexp-match #rx"^write-certificate: the file cannot be written\n  file: /proc/swing[.]v"
                        (message-of (write-certificate (verify-equal 'x 'x) "/proc/swing.v")
                                    exn:fail?))))
