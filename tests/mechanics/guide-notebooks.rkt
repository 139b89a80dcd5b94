#lang racket/base
;; The pages of the guide as notebooks: `make notebooks` runs them, and compares.

;; for-label: compiled with this file.
(require (for-label "../../scribblings/mechanics/guide.scrbl")
         mechanics/show/notebook/program-cells
         racket/list
         racket/runtime-path
         racket/string
         "../../scribblings/mechanics/guide-notebook.rkt"
         "support/checks.rkt")

(define-runtime-path guide "../../scribblings/mechanics/guide.scrbl")

(define pages (guide-pages guide))
(define (page name) (findf (lambda (p) (equal? name (guide-page-name p))) pages))
(define (sources p kind)
  (for/list ([c (in-list (guide-page-cells p))] #:when (eq? kind (cell-kind c))) (cell-source c)))

(test-case "every page has a title, prose, and cells that fail among its cells"
  (check-true (> (length pages) 35))
  (check-equal? (length (remove-duplicates (map guide-page-name pages))) (length pages))
  (for ([p (in-list pages)])
    (check-true (string-prefix? (cell-source (first (guide-page-cells p))) "# "))
    (check-false (ormap (lambda (s) (regexp-match? #rx"[\u0001]|#<|missing[\\]]" s))
                        (sources p 'markdown)))
    (check-equal? (remq* (guide-page-cells p) (guide-page-failing p)) '())))

(test-case "examples are cells as they are written, the session's beginning before them"
  (define chapter (page "chapter-2"))
  (check-equal? (take (sources chapter 'code) 2)
                '("(require mechanics/book)"
                  "(((M-of-q->omega-of-t Rx-matrix) (literal-function 'theta)) 't)"))
  (check-equal? (map cell-source (guide-page-failing chapter))
                '("((rigid-sysder 1 2 3) (up 0 (up 0 0 0) (up 1 1 1)))"
                  "(((M-of-q->omega-of-t stretch) (literal-function 'x)) 't)")))

(test-case "programs and pages are links to their notebooks; plain Racket is not run"
  (define prose (string-join (sources (page "chapter-2") 'markdown) "\n"))
  (check-true (string-contains? prose "](../rigid/heavy-top.ipynb)"))
  (check-true (string-contains? prose "[Exercises](guide-exercises.ipynb)"))
  (check-true (string-contains? (string-join (sources (page "questions") 'markdown) "\n")
                                "```racket\n")))
