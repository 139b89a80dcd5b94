#lang racket/base
;; A worksheet as a notebook: what students get, how answers are judged in its cells, and what
;; `raco mechanics check` makes of it.

(require mechanics/notebook/run-cells
         mechanics/show/notebook/notebook-file mechanics/show/notebook/program-cells
         racket/file
         racket/list
         racket/string
         "../../support/checks.rkt"
         (only-in "../../support/worksheet-folder.rkt" command delete-folder in-folder))

(display-to-file
 #<<END
#lang mechanics/worksheet
(title "Small *steps*" #:due "Friday")
(text "A rate `(sqrt (/ k m))` of 5 $.")
(given (define (twice x) (* 2 x)))
(exercise rate expression "What is it, for `m`?" (key (sqrt (/ 'k 'm))) (points 2)
  (hint "Look at the units.") (hint "It is a root." #:after 2))
(exercise two number "One and one?" (key 2))
END
 (in-folder "small.rkt"))

(check-equal? (command "worksheet" "small.rkt")
              '(0
                "small-student.rkt\nsmall-student.ipynb\nsmall-student.html\nsmall-student.tex\n"))

(define (cells-of name)
  (define-values (header cells) (bytes->notebook 'test name (file->bytes (in-folder name))))
  cells)
(define given (cells-of "small-student.ipynb"))

;; answers : pairs of a name and what stands for unanswered
(define (answered cells . answers)
  (for/list ([c (in-list cells)])
    (for/fold ([c c]) ([a (in-list answers)])
      (struct-copy cell c
                   [source (string-replace (cell-source c) (format "(define ~a unanswered)" (car a))
                                           (format "(define ~a ~a)" (car a) (cdr a)))]))))

;; -> what the cells print, one text for each that prints
(define (printed cells)
  (define-values (outputs failed) (run-cells cells))
  (for*/list ([cell (in-list outputs)] [o (in-list cell)])
    (hash-ref o 'text (hash-ref o 'evalue #f))))

;; ---------------------------------------------------------------------------

(test-case "a check before the worksheet is open"
  (check-equal? (printed (list (cell 'code "(require mechanics/answers)\n(check two)" #f #f)))
                '("check: the worksheet is not open: run its first cell, which opens it")))

(test-case "questions are text with formulas typeset, and each has a cell for its answer"
  (check-equal? (map cell-kind given)
                '(markdown code markdown code markdown code markdown code markdown code))
  (check-equal? (map cell-source (take (drop given 2) 4))
                (list "A rate $\\sqrt{\\frac{k}{m}}$ of 5 \\$."
                      "(define (twice x) (* 2 x))"
                      (string-append "### 1. rate (2 points)\n\nWhat is it, for $m\\text{?}$\n\n"
                                     "An expression, as\n\n    (define rate ...)\n\nor as on paper, in quotation marks. Names in it: k, m")
                      "(define rate unanswered)\n\n(check rate)"))
  (check-true (string-prefix? (cell-source (first given)) "# Small \\*steps\\*\nDue: Friday\n"))
  (check-true (string-contains? (file->string (in-folder "small-student.ipynb"))
                                "\"source_hidden\":true")
              "the envelope is folded"))

(test-case "nothing is answered, and it says so"
  (check-equal? (printed given)
                '("1. rate: not answered (0 of 2 points)\n" "2. two: not answered (0 of 1 point)\n"
                  "1. rate: not answered (0 of 2 points)\n2. two: not answered (0 of 1 point)
0 of 3 points.\n")))

(test-case "answers are judged in place, and hints come with wrong ones, each counted once"
  (define cells (answered given '(rate . "(* 'k 'm)") '(two . "2")))
  (define later (list (cell 'code "(define rate 'k)\n(check rate)" #f #f)))
  (define texts (printed (append cells later)))
  (check-regexp-match #rx"^1. rate: refuted .*hint: Look at the units.\n$" (first texts))
  (check-equal? (second texts) "2. two: right (1 of 1 point)\n")
  (check-regexp-match #rx"\n1 of 3 points.\n$" (third texts))
  (check-regexp-match #rx"units.\n   hint: It is a root.\n$" (fourth texts)))

(test-case "an answer as on paper is shown typeset as it was read"
  (define cells (answered given '(rate . "\"√(k/m)\"")))
  (define-values (outputs failed) (run-cells cells))
  (define shown (append* outputs))
  (check-equal? (hash-ref (first shown) 'text)
                "1. rate: proved (2 of 2 points)\n   read as √(k/m)\n")
  (check-equal? (hash-ref (hash-ref (second shown) 'data) 'text/latex)
                "$\\displaystyle \\sqrt{\\frac{k}{m}}$")
  (check-equal? (hash-ref (hash-ref (second shown) 'data) 'text/plain) "√(k/m)"))

(test-case "check grades the notebook's cells, with its own exercises or the teacher's"
  (define (write-notebook name cells)
    (call-with-output-file (in-folder name) #:exists 'truncate
      (lambda (out) (write-bytes (notebook->bytes usual-header cells) out))))
  (write-notebook "ann.ipynb" (answered given '(rate . "(sqrt (/ 'k 'm))") '(two . "2")))
  (define right "1. rate: proved (2 of 2 points)\n2. two: right (1 of 1 point)\n3 of 3 points.\n")
  (check-equal? (command "check" "ann.ipynb") (list 0 right))
  (check-equal? (command "check" "ann.ipynb" "--worksheet" "small.rkt") (list 0 right))
  (write-notebook "empty.ipynb" (list (cell 'code "1" #f #f)))
  (check-regexp-match #rx"the file holds no worksheet" (second (command "check" "empty.ipynb")))
  (call-with-output-file (in-folder "none.ipynb") (lambda (out) (write-bytes #"{" out)))
  (check-equal? (command "check" "none.ipynb")
                '(2
                  "check: it is no notebook of Jupyter, in its format 4: its JSON has a mistake\n")))

(test-case "a name without a definition is not answered; the mistakes of a check are told"
  (define (last-of . sources)
    (last (printed (append (list (second given))
                           (for/list ([s sources]) (cell 'code s #f #f))))))
  (check-equal? (last-of "(check two)") "2. two: not answered (0 of 1 point)\n")
  (check-equal? (last-of "(check tow)") "check: there is no exercise tow; did you mean two?")
  (check-regexp-match #rx"check: expected names of exercises, as in \\(check motion\\)"
                      (last-of "(check 'two)"))
  (check-equal? (last-of "(exercises \"AAAA\")")
                "worksheet: the lines that hold its exercises were changed; take a new copy"))

(delete-folder)
