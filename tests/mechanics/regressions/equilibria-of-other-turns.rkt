#lang racket/base
;; Equilibria of cos x − x/2 were given within one turn, without a word of those of other turns.

(require mechanics
         mechanics/error/note
         "../support/checks.rkt")

(define ((with-potential V) s) (- (* 1/2 (square (velocity s))) (V (coordinate s))))

;; The notes, in a session of its own
(define (noted V)
  (define port (open-output-string))
  (define found #f)
  (thread-wait
   (thread (lambda ()
             (parameterize ([current-error-port port])
               (start-session-of-notes!)
               (set! found (equilibria (with-potential V) (up 't 'x 'v)))))))
  (check-equal? (length found) 2)
  (get-output-string port))

(test-case "a system that is another one a turn on has others there"
  (define text (noted (lambda (x) (- (cos x) (/ x 2)))))
  (check-regexp-match #rx"^; equilibria: found are those within one turn of x; " text)
  (check-regexp-match #rx"the system is not the same a turn on, where there are others\n$" text))

(test-case "of an angle they are all"
  (check-equal? (noted cos) "")
  (check-equal? (noted (lambda (x) (* 'm 'g 'l (- 1 (cos x))))) ""))

(test-case "of a frequency nobody knows"
  (check-regexp-match #rx"^; equilibria: found are those within one turn of \\(\\* k x\\); "
                      (noted (lambda (x) (cos (* 'k x))))))
