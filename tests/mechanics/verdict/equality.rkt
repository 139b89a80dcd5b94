#lang racket/base
;; `=` and `zero?` of expressions: a proof counts, what it rests on is told, and where forms
;; alone tell, that is told.

(require racket/port
         racket/string
         mechanics
         "../support/checks.rkt" "../support/notes.rkt" "../support/run-text.rkt")

(define one-by-Pythagoras (+ (square (sin 'x)) (square (cos 'x))))

(test-case "expressions that are equal are equal however they are written"
  (check-true (= (square (sin 'x)) (- 1 (square (cos 'x)))))
  (check-true (= (* 2 (+ 'a 'b)) (+ (* 2 'a) (* 2 'b)) (+ 'a 'b 'a 'b)))
  (check-true (zero? (- one-by-Pythagoras 1)))
  (check-true (one? one-by-Pythagoras))
  (check-true (= (up one-by-Pythagoras (down 'a)) (up 1 (down (+ (/ 'a 2) (/ 'a 2))))))
  (check-true (= (matrix-by-rows (list one-by-Pythagoras 0)) (matrix-by-rows '(1 0))))
  (check-true (zero? (up (- one-by-Pythagoras 1) 0))))

(test-case "multiples of π have several names"
  (check-true (= ':2pi (* 2 ':pi)))
  (check-true (= ':-pi (- ':pi)))
  (check-false (= ':2pi ':pi)))

(test-case "what differs somewhere differs, without a word"
  (check-equal? (told (check-false (= 'a 'b))
                      (check-false (= 'x 0))
                      (check-false (= 'x +inf.0))
                      (check-false (zero? 'x))
                      (check-false (= (+ 'a 1) (- 'a 1)))
                      (check-false (= (up 1 'a) (up 1 'b)))
                      (check-false (= (up 1 2) (up 1 2 3)))
                      (check-false (= (up 1 2) 3))
                      (check-false (zero? (up 0 'a))))
                ""))

(test-case "numbers are compared as ever"
  (check-true (= 1 1.0 1))
  (check-false (= 0.3 (+ 0.1 0.2)))
  (check-false (= +nan.0 +nan.0))
  (check-true (zero? -0.0))
  (check-true (one? 1.0))
  (check-false (one? 2))
  (check-eq? (object-name =) '=)
  (check-eq? (object-name zero?) 'zero?))

(test-case "what a proof takes for granted is told"
  (check-equal? (told (check-true (= (sqrt (square 'm)) 'm)) (= (sqrt (square 'm)) 'm))
                "; = takes (sqrt (* m m)) and m for equal assuming (>= m 0)\n")
  (check-equal? (told (check-true (= (up 1 (sqrt (square 'n))) (up 1 'n))))
                "; = takes (sqrt (* n n)) and n for equal assuming (>= n 0)\n")
  (check-equal? (told (assuming ('(>= m 0)) (= (sqrt (square 'm)) 'm))) ""))

;; √(b − a) has a value where b ≥ a alone, there and beside it.
(test-case "what is assumed for the parts of a question holds together"
  (define size (sqrt (square (- 'a 'b))))
  (define root (sqrt (- 'b 'a)))
  (check-true (= (+ root size) (+ root (- 'b 'a))))
  (check-true (= size (- 'a 'b)))
  (check-false (= (up (+ root size) size) (up (+ root (- 'b 'a)) (- 'a 'b))))
  (check-true (= (up (+ root size) size) (up (+ root (- 'b 'a)) (- 'b 'a))))
  (check-false (zero? (list->up (list (- (+ root size) (+ root (- 'b 'a))) (- size (- 'a 'b))))))
  (check-false (= (matrix-by-rows (list (+ root size) size))
                  (matrix-by-rows (list (+ root (- 'b 'a)) (- 'a 'b)))))
  (check-false (= (- 'a 'b) size (+ size root (- root)) (- 'b 'a))))

(test-case "where the form alone tells, that is told once"
  (check-regexp-match #rx"^; = answers #f for .* written differently: whether they are equal is not"
                      (told (check-false (= (* 0.1 3 'x) (* 0.3 'x)))))
  (define text (told (check-false (= sin cos)) (= (D sin) cos) (= sin sin)))
  (check-regexp-match #rx"^; = answers #f for two functions .*\n;   [(]verify-equal f g[)]" text)
  (check-equal? (length (string-split text "\n")) 2))

(test-case "what an answer rests on is told of each question, once"
  (define x+y (+ 'x 'y 'z 'u 'v 'w))
  (define r (sqrt (square x+y)))
  (define text (told (= r x+y) (= r x+y) (= (* 2 r) (* 2 x+y))
                     (= (* 0.1 3 'x) (* 0.3 'x)) (= (* 0.1 7 'x) (* 0.7 'x))))
  (check-equal? (map (lambda (line) (regexp-match? #rx"equal assuming" line))
                     (filter (lambda (line) (regexp-match? #rx"^; =" line))
                             (string-split text "\n")))
                '(#t #t #f #f)))

(test-case "where there is no session nothing is said"
  (check-equal? (with-output-to-string
                  (lambda ()
                    (parameterize ([current-error-port (current-output-port)]) (= sin cos))))
                ""))

(test-case "a branch on equality is taken by what is equal, in derivatives too"
  (define (f x) (if (= (square x) (* x x)) (* 3 x) 0))
  (check-equal? ((D f) 'a) 3))

(test-case "notes go to the error port of a program, and not among its results"
  (check-equal? (prints "(= sin cos)") "#f\n")
  (define-values (output errors) (session '("-I" "mechanics") "(= sin cos)" "(= cos tan)"))
  (check-equal? output '("#f" "#f"))
  (check-equal? (length (regexp-match* #rx"; = answers" errors)) 1))

(test-case "matrices of other sizes are other matrices, whichever stands first"
  (define-values (narrow wide) (values (matrix-by-rows '(a b) '(c d))
                                       (matrix-by-rows '(a b e) '(c d f))))
  (check-false (= narrow wide))
  (check-false (= wide narrow)))
