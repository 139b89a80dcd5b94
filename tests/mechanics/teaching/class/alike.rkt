#lang racket/base
;; Submissions that are alike: what is remarked on, and what is not.

(require (prefix-in m: mechanics)
         mechanics/teaching/class/likeness
         mechanics/teaching/worksheet/judge
         mechanics/teaching/worksheet/judgment
         mechanics/teaching/worksheet/make-exercise
         (only-in racket/list range)
         "../../support/checks.rkt")

(define motion (make-exercise 'motion 'expression "?" (list (list 'key (m:+ 'a 'b 'c)))))
(define why (make-exercise 'why 'reason "?" '()))

(define given "#lang mechanics\n;; 1. What is the motion of it?\n(define motion unanswered)\n")

(define (student person text [answer '(+ a b c)] [reason "it is so"])
  (define (on e d) (judged e d (judge e d)))
  (handed-in person (string-append given text) given
             (list (on motion (list 'answer answer)) (on why (list 'text reason)))))

;; Twenty who have nothing in common but the question
(define others
  (for/list ([k 20])
    (student (format "s~a" k) (format "(define helper~a 1)\n;; my own comment, number ~a\n" k k)
             (list '+ 'a 'b 'c k) (format "because the reason is number ~a" k))))

(define (said . students) (likenesses (append others students)))

(test-case "those who have nothing in common are not remarked on"
  (check-equal? (said) '()))

(define strange '(* a (expt b 7) (sin (* c d)) (cos (+ a e))))

(test-case "the same strange answer with the same name for a helper is"
  (check-equal? (said (student "Ann" "(define omegga 1)\n" strange)
                      (student "Bob" "(define omegga 1)\n" strange))
                (list (string-append "Ann and Bob have in common, as few others do: the name "
                                     "omegga, the same wrong motion; that may have many reasons"))))

(test-case "names that two alone have are remarked on from three on, of 60 letters as a whole"
  (define (defining . names)
    (apply string-append (for/list ([n (in-list names)]) (format "(define ~a 1)\n" n))))
  (define long (make-string 60 #\n))
  (define (both text) (said (student "Ann" text) (student "Bob" text)))
  (check-equal? (both (defining "omegga" "alfa")) '())
  (check-equal? (both (defining "omegga" "alfa" long))
                (list (string-append "Ann and Bob have in common, as few others do: the name alfa, "
                                     "the name " long ", the name omegga; that may have many "
                                     "reasons"))))

(test-case "two comments, or the words of a reason"
  (define comments ";; here I integrate by parts\n; and hten the rest\n")
  (check-equal? (length (said (student "Ann" comments) (student "Bob" comments))) 1)
  (define reason "The constraint does no work, so it drops out of it.")
  (check-equal? (length (said (student "Ann" "" '(+ a b c) reason)
                              (student "Bob" "" '(+ a b c) (string-upcase reason))))
                1))

(test-case "words of a reason tell something from 25 letters on"
  (define (remarks reason)
    (length (said (student "Ann" "" '(+ a b c) reason) (student "Bob" "" '(+ a b c) reason))))
  (check-equal? (remarks (make-string 25 #\x)) 1)
  (check-equal? (remarks (make-string 24 #\x)) 0))

(test-case "right answers, common slips, one trait alone, and what was given are no likeness"
  (check-equal? (said (student "Ann" "") (student "Bob" "")) '())
  (check-equal? (said (student "Ann" "(define omegga 1)\n" '(* -1 (+ a b c)))
                      (student "Bob" "(define omegga 1)\n" '(* -1 (+ a b c))))
                '())
  (check-equal? (said (student "Ann" ";; a comment that both have\n")
                      (student "Bob" ";; a comment that both have\n"))
                '()))

(test-case "what many share is likely"
  (define (many n)
    (for/list ([k n])
      (student (format "m~a" k) ";; what the lecture said\n;; of energies and such\n" strange)))
  (check-equal? (apply said (many 4)) '())
  (check-equal? (length (apply said (many 2))) 1)
  ;; Three are few among sixty, a pair more for each two of them.
  (define fifty-seven (map (lambda (k) (student (format "t~a" k) "")) (range 57)))
  (check-equal? (length (likenesses (append fifty-seven (many 3)))) 3)
  (check-equal? (length (likenesses (append (cdr fifty-seven) (many 3)))) 0))

(test-case "what a student wrote commands no terminal"
  (define text "(define x\u1b[2Jyz 1)\n;; look \u1b]0;here\u7 at this\n;; and \u202Eanother one\n")
  (define remarks (said (student "Ann" text) (student "Bob" text)))
  (check-equal? (length remarks) 1)
  (check-false (regexp-match? #px"\\p{Cc}|\\p{Cf}" (car remarks))))
