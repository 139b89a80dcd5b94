#lang racket/base
;; The decimal pi, in questions that π itself would settle, had four answers: undecided without
;; a reason, refuted, undecided at points where every such sine is zero, and decimals in the way.

(require mechanics
         "../support/checks.rkt" "../support/messages.rkt")

(define note
  #rx"note: .* may be no more than what rounding leaves, as of [(]sin pi[)]: .*':pi for π")

(define (text x) (format "~a" x))

(test-case "a number that rounding left is undecided, however it is asked, and π is named"
  (for ([v (list (prove-zero (sin pi))
                 (verify-equal (sin (* 2 pi)) 0)
                 (verify-equal 0 (sin (* 2 pi)))
                 (prove-zero (up (sin pi) 0)))])
    (check-pred undecided? v)
    (check-eq? (verdict-reason v) 'decimals)
    (check-regexp-match note (text v)))
  (define exactly-0 (prove-zero (- (cos pi) -1)))
  (check-pred undecided? exactly-0)
  (check-eq? (verdict-reason exactly-0) 'decimals)
  (check-regexp-match #rx"note: exact numbers would tell: .*':pi for π" (text exactly-0))
  (check-pred undecided? (verify-equal (cos pi) -1))
  (check-pred proved? (prove-zero (sin ':pi)))
  (check-pred proved? (verify-equal (sin ':2pi) 0)))

(test-case "a factor that rounding left is refuted with the same note"
  (define v (prove-zero (* (sin pi) 'x)))
  (check-pred refuted? v)
  (check-regexp-match note (text v)))

(test-case "an angle counted in turns is looked at between whole turns, too"
  (for ([e (list (sin (* 2 pi 't)) (sin (* ':2pi 't)) (- 1 (cos (* 2 pi 't)))
                 (- 1 (cos (* ':2pi 't))) (tan (* ':pi 't 'n)))])
    (check-pred refuted? (prove-zero e) (text e))))

(test-case "a symbol that is spelt like π is told to be an unknown"
  (for ([name '(pi Pi PI π)])
    (check-regexp-match (format "note: the symbol ~a is an unknown like others; .*':pi" name)
                        (text (prove-zero (sin name)))))
  (check-false (regexp-match? #rx"unknown" (text (prove-zero (cos ':pi)))))
  (check-false (regexp-match? #rx"unknown" (text (prove-zero (- (sin 'pi) (sin 'pi)))))))

(test-case "exact constants are rounded"
  (check-equal? (map floor (list ':pi ':-pi (/ ':pi 4))) '(3 -4 0))
  (check-equal? (list (ceiling ':pi) (truncate ':-pi) (round ':2pi)) '(4 -3 6))
  (check-equal? (floor (* 2 (sin (/ ':pi 6)))) 1)
  (check-equal? ((D floor) ':pi) 0)
  (check-message
   (string-append "floor: cannot be taken of a number-like expression\n"
                  "  argument 1: the symbol x")
   (floor 'x))
  (check-message (string-append "floor: too near to where it jumps to be told by its decimals\n"
                                "  value: (* 0.3183098861837907 :pi), a number-like expression")
                 (floor (/ ':pi pi)))
  (check-equal? ((principal-value ':pi) 4) ((principal-value pi) 4)))
