#lang racket/base
;; Notebooks as `make notebooks` makes them: their results are those of the programs.  Here a sample
;; is compared, there all of them.

(require (file "../../../.ci/notebook-work.rkt")
         json
         mechanics/show/notebook/notebook-file mechanics/show/notebook/program-cells
         racket/file
         racket/list
         racket/runtime-path
         "../support/checks.rkt")

(define-runtime-path examples "../../../examples/mechanics")

(define sample
  '("chapter-1/angular-momentum.rkt" "exercises/exercise-1-12.rkt" "figures/figure-2-2.rkt"
    "interactive/pendulum.rkt" "questions/triangle-points.rkt"))

(define (outputs notebook)
  (append-map (lambda (c) (hash-ref c 'outputs '())) (hash-ref (bytes->jsexpr notebook) 'cells)))

(for ([name (in-list sample)])
  (test-case (format "the notebook of ~a shows what the program gives" name)
    (define-values (notebook problem) (program-notebook (simplify-path (build-path examples name))))
    (check-equal? problem #f)
    (check-true (pair? (outputs notebook)))))

(define folder (make-temporary-file "mechanics-notebooks~a" 'directory))

(test-case "where it shows something else it is told"
  (define file (build-path folder "late.rkt"))
  (display-to-file (string-append "#lang mechanics\n\n(define (f x) (square x))\n\n"
                                  "(define (square x) 'mine)\n\n(f 2)\n")
                   file)
  (define-values (notebook problem) (program-notebook file))
  (check-equal? problem "the program gives  \"mine\"\n  the notebook  \"4\""))

(test-case "a page's cells fail where they should, and nowhere else"
  (define file (build-path folder "page.ipynb"))
  (define cells (for/list ([code '("(/ 1 0)" "(+ 1 2)")]) (cell 'code code #f #f)))
  (call-with-output-file file (lambda (out) (write-bytes (notebook->bytes usual-header cells) out)))
  (define-values (notebook problem) (page-notebook file '(0)))
  (check-equal? problem #f)
  (check-equal? (map (lambda (o) (hash-ref o 'output_type)) (outputs notebook))
                '("error" "display_data"))
  (define-values (same other-problem) (page-notebook file '(1)))
  (check-regexp-match #rx"these cells fail, or should and do not\n  [(]/ 1 0[)]\n" other-problem))

(delete-directory/files folder)
