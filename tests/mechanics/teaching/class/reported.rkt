#lang racket/base
;; The folder of a class and the report on it: in which order submissions stand, and what is said
;; of what went wrong.

(require mechanics/teaching/class/class-page
         mechanics/teaching/class/class-tables
         mechanics/teaching/class/collect-answers
         mechanics/teaching/class/grade
         mechanics/teaching/class/submission
         mechanics/teaching/worksheet/judge
         mechanics/teaching/worksheet/judgment
         mechanics/teaching/worksheet/make-exercise
         mechanics/teaching/worksheet/make-worksheet
         racket/file
         "../../support/checks.rkt")

(test-case "submissions stand in the order of the numbers in their names"
  (define folder (make-temporary-file "mechanics-order~a" 'directory))
  (for ([name '("s10.rkt" "s9.rkt" "ann.rkt" "s2.rkt" "s.rkt" "9-b.rkt" "10-a.rkt" "notes.txt")])
    (display-to-file "#lang mechanics\n" (build-path folder name)))
  (check-equal? (map submission-id (folder->submissions 'check folder))
                '("9-b" "10-a" "ann" "s" "s2" "s9" "s10"))
  ;; Two files of one name are told apart.
  (display-to-file "{}" (build-path folder "s2.ipynb"))
  (check-equal? (map submission-id (folder->submissions 'check folder))
                '("9-b" "10-a" "ann" "s" "s2.ipynb" "s2.rkt" "s9" "s10"))
  (define long (build-path folder "long.rkt"))
  (display-to-file (make-string 1000001 #\;) long)
  (check-equal? (submission-problem (file->submission long))
                "it has 1000001 bytes; at most 1000000 are read")
  (delete-directory/files folder))

(define e (make-exercise 'frequency 'expression "?" '((key k))))
(define w (make-worksheet "Once" #f "once" (list e)))

(test-case "after each submission it is told how many are graded"
  (define told '())
  (define (nothing i exercises s) (collected (hasheq) #f 0 #f))
  (grade-class w (for/list ([id '("a" "b" "c")]) (submission id id "" #f #f #f))
               #:strictest 'own #:collect nothing
               #:tell (lambda (n) (set! told (cons n told))))
  (check-equal? told '(3 2 1)))

;; The page of a class whose answers were these.
(define (page-of . answers)
  (class->page
   (class-report w #f
                 (for/list ([a (in-list answers)] [i (in-naturals)])
                   (define d (list 'answer a))
                   (graded (submission (format "~a" i) (format "~a" i) "" #f #f #f)
                           (list (judged e d (judge e d))) #f '() #f 1))
                 '() '())))

(test-case "what went wrong is counted, and what has no name as well"
  (define page (page-of '(* -1 k) '(* -1 k) '(* 2 k) '(expt k k) 'k))
  (for ([row '("the sign is the opposite</td><td>2 times" "2 times what it should be</td><td>once"
               "it fails in another way</td><td>once")])
    (check-regexp-match (regexp-quote row) page))
  (check-false (regexp-match? #rx"What went wrong" (page-of 'k 'k))))

(test-case "a table of the class has the problem of each submission in its column"
  (define (row-with problem)
    (class->csv (class-report w #f (list (graded (submission "a" "Ann" "" #f #f #f) '()
                                                 problem '("a note") #f 1))
                              '() '())))
  (check-regexp-match #rx"\"it does not run\",\"a note\"" (row-with "it does not run"))
  (check-regexp-match #rx"\"\",\"a note\"" (row-with #f)))

(test-case "an answer that fails is told with its reason, and not where the program is at fault"
  (define (page-with d problem)
    (class->page (class-report w #f (list (graded (submission "a" "a" "" #f #f #f)
                                                  (list (judged e d (judge e d))) problem '() #f 1))
                              '() '())))
  (check-regexp-match #rx"class=\"judged failed\".*it has no value"
                      (page-with '(failed "it has no value") "it does not run: no"))
  (check-false (regexp-match? #rx"class=\"judged" (page-with '(failed) "it does not run: no"))))
