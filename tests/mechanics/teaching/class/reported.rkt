#lang racket/base
;; The folder of a class and the report on it: in which order submissions stand, and what is said
;; of what went wrong.

(require mechanics/teaching/class/class-page
         mechanics/teaching/class/class-tables
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
  (delete-directory/files folder))

(test-case "a program and a notebook of one name keep their endings; one that is too large is told"
  (define folder (make-temporary-file "mechanics-both~a" 'directory))
  (define (write-file name text) (display-to-file text (build-path folder name)))
  (write-file "ann.rkt" "#lang mechanics\n")
  (write-file "ann.ipynb" "{}")
  (write-file "bob.ipynb" "{}")
  (write-file "cy.rkt" (make-string 1000001 #\;))
  (make-directory (build-path folder "dora"))
  (write-file "dora/mine.rkt" "#lang mechanics\n")
  (define all (folder->submissions 'check folder))
  (check-equal? (map submission-id all) '("ann.ipynb" "ann.rkt" "bob" "cy" "dora"))
  (check-equal? (map submission-problem all)
                '(#f #f #f "it has 1000001 bytes; at most 1000000 are read" #f))
  (delete-directory/files folder))

(define e (make-exercise 'frequency 'expression "?" '((key k))))
(define w (make-worksheet "Once" #f "once" (list e)))

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

(test-case "the table has a problem in its column, and nothing where there is none"
  (define (row problem)
    (define g (graded (submission "a" "a" "" #f #f #f) '() problem '() #f 1))
    (cadr (regexp-match #rx"\n([^\n]*)\r\n$" (class->csv (class-report w #f (list g) '() '())))))
  (check-equal? (row "it does not run") "\"a\",\"a\",\"0\",\"0\",\"it does not run\",\"\"")
  (check-equal? (row #f) "\"a\",\"a\",\"0\",\"0\",\"\",\"\""))

(test-case "an answer that fails is told with its reason, and not where the program is at fault"
  (define (page-with d problem)
    (class->page (class-report w #f (list (graded (submission "a" "a" "" #f #f #f)
                                                  (list (judged e d (judge e d))) problem '() #f 1))
                              '() '())))
  (check-regexp-match #rx"class=\"judged failed\".*it has no value"
                      (page-with '(failed "it has no value") "it does not run: no"))
  (check-false (regexp-match? #rx"class=\"judged" (page-with '(failed) "it does not run: no"))))
