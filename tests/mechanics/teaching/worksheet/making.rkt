#lang racket/base
;; Exercises that cannot be judged are refused when they are made.

(require (prefix-in m: mechanics)
         mechanics/teaching/worksheet/exercise
         mechanics/teaching/worksheet/make-exercise
         mechanics/teaching/worksheet/make-worksheet
         "../../support/checks.rkt" "../../support/messages.rkt")

(define (made kind . clauses) (make-exercise 'item kind "?" clauses))

(define (check-credit credit)
  (made 'number '(key 1) (list 'slip 2 "no" '#:credit credit)))

(test-case "the credit of a slip is a share of the points"
  (define (told x)
    (string-append "item: the credit of a slip is a share of the points, from 0 to 1\n  given: " x))
  (check-message (told "2") (check-credit 2))
  (check-message (told "-1") (check-credit -1))
  (check-message (told "half") (check-credit 'half))
  (for ([c '(0 1/2 0.25 1)])
    (check-equal? (slip-credit (car (exercise-slips (check-credit c)))) c)))

(define (hinted after) (made 'number '(key 1) (list 'hint "look" '#:after after)))

(test-case "a hint comes after a number of wrong answers"
  (for ([after '(b -1 3/2 2.0)])
    (check-regexp-match #rx"^item: a hint comes after a number of wrong answers, as in #:after 2"
                        (message-of (hinted after))))
  (check-regexp-match #rx"given: \"b\"" (message-of (hinted "b")))
  (for ([after '(0 2)])
    (check-equal? (hint-after (car (exercise-hints (hinted after)))) after)))

(test-case "a unit is a text, and points are told as they were given"
  (check-message "item: the unit is a text, as in (unit \"s\")\n  given: s"
                 (made 'number '(key 1) '(unit s)))
  (check-message "item: the clause `points` takes a number that is not negative\n  given: \"2\""
                 (made 'number '(key 1) '(points "2"))))

(test-case "what is given has no name of an exercise"
  (check-message "item: what is given has that name already; call the exercise otherwise"
                 (make-worksheet "W" #f "w" (list (given "(define x 1)\n(define ((item m) x) x)")
                                                  (made 'number '(key 1))))))

(test-case "no exercise is called as what is not answered"
  (check-message (string-append "unanswered: that name stands for what is not answered yet; "
                                "call the exercise otherwise")
                 (make-exercise 'unanswered 'number "?" '((key 1)))))

(test-case "a tolerance is given where something is measured"
  (for ([kind '(number expression)]) (check-true (exercise? (made kind '(key 1) '(within 1/10)))))
  (check-message (string-append
                  "item: the clause `within` takes a share of the key's value, as 1/100, or an "
                  "error in the unit, (within 5 #:absolute)\n  given: 5")
                 (made 'number '(key 1) '(within 5)))
  (check-true (exercise? (made 'number '(key 1) '(within 5 #:absolute))))
  (check-message (string-append
                  "item: the clause `within` is for numbers, and for expressions and functions "
                  "with decimals; an answer of the kind Hamiltonian is proved")
                 (made 'Hamiltonian '(coordinates q) '(key 1) '(within 1/10))))

(test-case "a key is no text"
  (check-message (string-append "item: the clause `key` is of no use: it is a text; only students "
                                "may answer with formulas as on paper")
                 (made 'expression '(key "m g x"))))

(define (canonical key) (made 'canonical '(coordinates q) (list 'key key)))

(test-case "the identity is no key of a canonical map"
  (for ([key (list values (lambda (s) (m:* 1/2 (m:+ s s))))])
    (check-regexp-match #rx"^item: the key is the identity" (message-of (canonical key))))
  (check-true
   (exercise? (canonical (lambda (s) (m:up (m:ref s 0) (m:ref s 2) (m:- (m:ref s 1))))))))
