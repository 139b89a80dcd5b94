#lang racket/base
;; Students' searches find the best page first.

(require (for-label mechanics/lang/help/search-table)
         mechanics/lang/help/cards
         mechanics/lang/help/finding
         mechanics/lang/help/finding-lines
         mechanics/lang/help/search
         mechanics/lang/help/words
         racket/list
         racket/runtime-path
         racket/string
         "../../support/checks.rkt"
         "../../support/search-queries.rkt")

(define-runtime-path programs "../../../../examples/mechanics")
(define-runtime-path compiled "../../../../mechanics/lang/help/compiled/search-table_rkt.zo")

(define (found text)
  (define-values (all fit?) (find-in-table (table-of-search) text))
  all)

;; A finding as the table of queries has it.
(define (answer f)
  (case (finding-kind f)
    [(name) (string->symbol (finding-title f))]
    [(page section) (car (string-split (finding-where f) "#"))]
    [else (finding-where f)]))

(define (first-answer text)
  (define all (found text))
  (and (pair? all) (answer (car all))))

;; ---------------------------------------------------------------------------

;; ((words . first answer) ...)
(define (wrong queries)
  (for/list ([q (in-list queries)] #:unless (member (first-answer (car q)) (cdr q)))
    (cons (car q) (first-answer (car q)))))

(test-case "of sixty queries of students at least 57 have the right answer first"
  (check-equal? (length queries) 60)
  (check-true (<= (length (wrong queries)) 3) (format "~s" (wrong queries))))

(test-case "so have at least 24 of thirty others"
  (check-equal? (length other-queries) 30)
  (check-true (<= (length (wrong other-queries)) 6) (format "~s" (wrong other-queries))))

(test-case "each exercise is found by its number, with its program"
  (for ([file (in-list (directory-list (build-path programs "exercises")))]
        #:when (regexp-match? #rx"^exercise-.*[.]rkt$" (path->string file)))
    (define number (cdr (regexp-match #rx"exercise-([0-9]+)-([0-9]+)" (path->string file))))
    (define program (format "exercises/~a" file))
    (for ([text (list (string-join number ".") (format "exercise ~a" (string-join number ".")))])
      (check-equal? (first-answer text) program text)
      (check-eq? (finding-kind (car (found text))) 'exercise))))

(test-case "those of the book's sequel come after those of the book"
  (check-equal? (finding-where (cadr (found "exercise 4.2")))
                "geometry/exercises/FDG-exercise-4-2.rkt")
  (check-equal? (first-answer "FDG exercise 4.2") "geometry/exercises/FDG-exercise-4-2.rkt")
  (check-equal? (first-answer "exercise 9.10") "geometry/exercises/FDG-exercise-9-10.rkt"))

(test-case "exercises that have no program are found as well, and figures and chapters are"
  (for ([number '("1.1" "1.2" "1.23" "2.7" "2.13" "9.2")])
    (define first-found (car (found number)))
    (check-equal? (finding-title first-found) (string-append "Exercise " number))
    (check-false (string-contains? (car (found-lines (list first-found))) "…") number))
  (check-equal? (car (found-lines (found "exercise 1.1")))
                "Exercise 1.1: No program: degrees of freedom are counted by looking.")
  (for ([chapter '(1 2 3 4 5 6 7)])
    (check-equal? (first-answer (format "chapter ~a" chapter)) (format "chapter-~a" chapter)))
  (check-equal? (first-answer "figure 4.9") "figures/figure-4-9.rkt")
  (check-equal? (first-answer "equation 7.88") "exercises/exercise-7-4.rkt")
  (check-equal? (first-answer "equation 1.150") "exercises/exercise-3-16.rkt"))

(test-case "words of students stand for those of the manual"
  (check-not-false (memq (first-answer "parallel transport")
                         '(evolve-parallel-transport parallel-transport-equation)))
  (check-equal? (first-answer "L4") "questions/triangle-points.rkt")
  (check-equal? (first-answer "Lagrange points") "questions/triangle-points.rkt")
  (check-equal? (first-answer "orbital elements") "interactive/Kepler.rkt")
  (check-eq? (first-answer "export a plot") 'graphics-save)
  (check-eq? (first-answer "substitute numbers") 'substitute)
  (check-equal? (first-answer "type a formula from paper") "guide-formulas"))

(test-case "programs that are found are there"
  (for ([f (in-vector (vector-ref (table-of-search) 0))]
        #:when (memq (finding-kind f) '(program exercise)))
    (check-true (file-exists? (build-path programs (finding-where f))) (finding-where f))))

(test-case "a name typed as it is comes first, whatever its case"
  (for ([name '(up UP evolve D Lagrange-equations Rayleigh-dissipation ->TeX)])
    (check-eq? (first-answer (symbol->string name)) name))
  (check-eq? (first-answer "lagrange-equations") 'Lagrange-equations))

(test-case "words are the same without endings and accents"
  (check-equal? (words-of "Damping, damped") '("damp" "damp"))
  (check-equal? (words-of "Lagrange’s Lagrange's") '("lagrang" "lagrang"))
  (check-equal? (words-of "Poincaré plotting 1.29") '("poincar" "plot" "1.29"))
  (check-equal? (telling-words "how do I plot the plots") '("plot"))
  (check-equal? (telling-words "what is it") '("what" "is" "it")))

(test-case "a page and its sections are one answer"
  (define pages (filter string? (map answer (found "pendulum"))))
  (check-false (check-duplicates pages)))

(test-case "a library is found once, though several pages describe it"
  (check-equal? (count (lambda (f) (eq? (finding-kind f) 'library)) (found "geometry")) 1))

(test-case "the table is of modest size"
  (check-true (< (file-size compiled) 500000)))
