#lang racket/base
;; Numbers that are each student's own: the same on all machines, and spread over their values; and
;; credit for common slips.

(require (prefix-in m: mechanics)
         mechanics/teaching/worksheet/exercise
         mechanics/teaching/worksheet/judge
         mechanics/teaching/worksheet/judgment
         mechanics/teaching/worksheet/make-exercise
         mechanics/teaching/worksheet/student-numbers
         "../../support/checks.rkt" "../../support/messages.rkt")

(define (chosen student [seed 2026] [name 'l])
  (parameterize ([current-student student]) (student-number name seed '(1 2 3 4 5))))

;; As Python's hashlib has it, from the first eight bytes, modulo five.
(test-case "the choice is a matter of seed, student and name, and of nothing else"
  (check-equal? (for/list ([s '("ann@uni.edu" "bob@uni.edu" "Çelik Ünal" "0012")]) (chosen s))
                '(3 3 1 4))
  (check-equal? (chosen "Ann@uni.edu") (chosen "ann@UNI.edu"))
  (check-equal? (chosen #f) 1))

(test-case "another seed and another name give other numbers; each value comes about as often"
  (define students (for/list ([k 500]) (format "s~a" k)))
  (define (same f g) (for/sum ([s students]) (if (= (f s) (g s)) 1 0)))
  (check-true (< 60 (same chosen (lambda (s) (chosen s 2027))) 140))
  (check-true (< 60 (same chosen (lambda (s) (chosen s 2026 'm))) 140))
  (for ([x '(1 2 3 4 5)])
    (check-true (< 60 (for/sum ([s students]) (if (= x (chosen s)) 1 0)) 140))))

(test-case "steps, exact and in decimals"
  (check-equal? (stepped 'l 1 3 1/2) '(1 3/2 2 5/2 3))
  (check-equal? (stepped 'l 0.1 0.5 0.1) '(0.1 0.2 0.3 0.4 0.5))
  (check-equal? (stepped 'l 0 1 2/3) '(0 2/3)))

(test-case "the student's file has them, with a name"
  (parameterize ([current-student "ann@uni.edu"])
    (check-equal? (given-source (make-numbers '(l m) '(3/2 0.1)))
                  ";; The numbers of ann@uni.edu\n(define l 3/2)\n(define m 0.1)"))
  (check-equal? (given-source (make-numbers '(l) '(1))) "(define l 1)"))

(says
 [(student-number 'l 0 '()) "parameters: l has no value, as in [l 1 2 3]"]
 [(student-number 'l 0 '(1 x)) "parameters: the values of l are numbers\n  given: x"]
 [(stepped 'l 1 3 0)
  "parameters: l goes up in steps, as in [l #:from 1 #:to 3 #:step 1/2]"]
 [(make-numbers '(l m l) '(1 2 3)) "parameters: l stands there twice"]
 [(call-for-student "ann" (lambda () (/ 1 (student-number 'l 0 '(0)))))
  "worksheet: the worksheet of ann cannot be made\n  numbers: l = 0\n  /: division by zero"])

;; ---------------------------------------------------------------------------
;; Credit

(define (share-of answer . clauses)
  (define e (make-exercise 'a 'expression "?"
                           (append (list (list 'key (m:+ 'a (m:* 'b 'c)))) clauses)))
  (define j (judge e (list 'answer answer)))
  (list (judgment-status j) (judgment-share j)))

(define credit '(credit #:sign 1/2 #:factor 1/4))

(test-case "slips of sign and factor earn what the worksheet says"
  (for ([(answer expected) (hash '(* -1 (+ a (* b c))) '(partly 1/2) '(- a (* b c)) '(partly 1/2)
                                 '(* 2 (+ a (* b c))) '(partly 1/4)
                                 '(+ a (* 2 b c)) '(partly 1/4)
                                 '(+ a b) '(wrong 0) '(+ (* c b) a) '(right 1))])
    (check-equal? (share-of answer credit) expected (format "~s" answer)))
  (check-equal? (share-of '(* -1 (+ a (* b c)))) '(wrong 0))
  (check-equal? (share-of '(* 2 (+ a (* b c))) '(credit #:sign 1/2)) '(wrong 0)))

(test-case "a slip that the teacher foresaw has the credit that the teacher says"
  (check-equal? (share-of '(- a (* b c)) credit (list 'slip (m:- 'a (m:* 'b 'c)) "no"))
                '(wrong 0)))

(test-case "credit is a share"
  (check-message
   "a: the credit of a slip is a share of the points, from 0 to 1\n  given: 2"
   (share-of 1 '(credit #:sign 2))))
