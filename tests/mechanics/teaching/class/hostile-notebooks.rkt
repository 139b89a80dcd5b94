#lang racket/base
;; Notebooks that are handed in: their cells' sources count, and nothing else; one that wishes ill,
;; or is broken, costs its own points, and the class is graded whole.

(require json
         (prefix-in m: mechanics)
         (only-in mechanics/show/typesetting/visible visible)
         mechanics/teaching/class/class-page
         mechanics/teaching/class/class-tables
         mechanics/teaching/class/grade
         mechanics/teaching/class/submission
         mechanics/teaching/worksheet/judgment
         mechanics/teaching/worksheet/make-exercise
         mechanics/teaching/worksheet/make-worksheet
         racket/file
         racket/string
         "../../support/checks.rkt" "../../support/evaluated-here.rkt" "../../support/patience.rkt")

(define folder (make-temporary-file "mechanics-notebooks~a" 'directory))
(file-or-directory-permissions folder #o755)

(define w
  (make-worksheet
   "Hostile" #f "hostile"
   (list (make-exercise 'frequency 'expression "?" (list (list 'key (m:sqrt (m:/ 'k 'm)))))
         (make-exercise 'second 'number "?" (list (list 'key 2))))))

;; ---------------------------------------------------------------------------
;; Notebooks

(define (code-of source . more)
  (apply hash-set* (hasheq 'cell_type "code" 'metadata (hasheq) 'outputs '() 'source source
                           'execution_count 'null)
         more))
(define (text-of source . more)
  (apply hash-set* (hasheq 'cell_type "markdown" 'metadata (hasheq) 'source source) more))

(define (notebook-of . cells)
  (jsexpr->bytes (hasheq 'cells cells 'metadata (hasheq) 'nbformat 4 'nbformat_minor 5)))

(define opening (code-of "(require mechanics/answers)"))
(define right (code-of "(define frequency (sqrt (/ 'k 'm)))\n\n(check frequency)"))
(define wrong "(define frequency (* 2 'k))")
(define right-second (code-of "(define second 2)"))
(define honest (notebook-of (text-of "# W\nName: Ann A.\n") opening right right-second))

(define proved (hasheq 'output_type "stream" 'name "stdout"
                       'text "1. frequency: proved (1 of 1 point)\n"))

;; name, bytes, statuses of both answers, or a regexp that the problem matches
(define notebooks
  (list
   (list "faked-outputs" (notebook-of opening (code-of wrong 'outputs (list proved)))
         '(wrong unanswered))
   (list "faked-count" (notebook-of opening (code-of wrong 'execution_count 7) right-second)
         '(wrong right))
   (list "faked-metadata"
         (notebook-of
          opening
          (code-of wrong 'metadata
                   (hasheq 'mechanics (hasheq 'text "(define frequency (sqrt (/ 'k 'm)))"
                                              'after "\n\n(define second 2)\n\n"))))
         '(wrong unanswered))
   (list "faked-header"
         (jsexpr->bytes
          (hasheq 'cells (list opening (code-of wrong)) 'nbformat 4
                  'metadata
                  (hasheq 'mechanics (hasheq 'header "#lang mechanics\n(define second 2)\n"))))
         '(wrong unanswered))
   (list "deep" (bytes-append #"{\"cells\":" (make-bytes 1000000 91) (make-bytes 1000000 93) #"}")
         #rx"nested more than 64 deep")
   (list "deep-objects" (apply bytes-append (for/list ([_ 100000]) #"{\"a\":"))
         #rx"nested more than")
   (list "key-twice"
         (bytes-append #"{\"cells\":[{\"cell_type\":\"code\",\"source\":\"(define second 2)\","
                       #"\"s\\u006furce\":\"(define second 3)\"}]}")
         #rx"the key \"source\" stands twice")
   (list "cells-twice" #"{\"cells\":[],\"cells\":[]}" #rx"the key \"cells\" stands twice")
   (list "many-values" (bytes-append #"{\"cells\":[],\"x\":["
                                     (apply bytes-append (for/list ([_ 900000]) #"{},")) #"0]}")
         #rx"more than 200000 values")
   (list "huge-number" #"{\"cells\":[],\"nbformat\":1e999999999}" #rx"too many digits")
   (list "huge-cell" (notebook-of opening right (code-of (make-string 1500000 #\;)))
         #rx"more than 1000000 characters in its cells")
   (list "huge-file" (make-bytes 5000000 32) #rx"5000000 bytes; at most 4000000 are read; Clear")
   (list "attachment"
         (notebook-of right (text-of "![x](attachment:x.png)" 'attachments
                                     (hasheq 'x.png (hasheq 'image/png "iVBORw0KGgo="))))
         #rx"a cell holds an attachment")
   (list "no-attachment" (notebook-of right (text-of "x" 'attachments (hasheq)))
         '(right unanswered))
   (list "redefines-the-judge"
         (notebook-of opening
                      (code-of "(define (check . x) \"proved\")\n(define (exercises . x) 1)")
                      (code-of "(define (unseal . x) '())") (code-of "(define unanswered 2)")
                      (code-of wrong) (code-of "(define second unanswered)"))
         '(wrong right))
   (list "redefines-the-language"
         (notebook-of opening (code-of "(define (sqrt x) 1)") right right-second) '(wrong right))
   (list "wrong-types" #"{\"cells\":[{\"cell_type\":\"code\",\"source\":17}]}"
         #rx"the source of a cell is a text")
   (list "unknown-kind" #"{\"cells\":[{\"cell_type\":[1],\"source\":\"\"}]}" #rx"unknown kind")
   (list "cells-no-list" #"{\"cells\":{\"0\":\"x\"}}" #rx"no notebook of Jupyter")
   (list "not-JSON" #"#lang mechanics\n(define second 2)\n" #rx"no notebook of Jupyter")
   (list "not-a-notebook" #"[1, 2, \"three\"]" #rx"no notebook of Jupyter")
   (list "cut-off" (subbytes honest 0 (- (bytes-length honest) 30)) #rx"its JSON has a mistake")
   (list "not-UTF-8" (bytes-append honest #"\377") #rx"UTF-8")
   (list "mark-of-UTF-8" (bytes-append #"\357\273\277" honest) '(right right))
   (list "raw-and-text"
         (notebook-of opening (hash-set (code-of "(define second 2)") 'cell_type "raw")
                      (text-of "    (define frequency (sqrt (/ 'k 'm)))"))
         '(unanswered unanswered))
   (list "magics" (notebook-of (code-of "%matplotlib inline") (code-of "!rm -rf ~") opening
                               (code-of "%%python\nfrequency = 1") right right-second)
         '(right right))
   (list "fails-and-exits"
         (notebook-of opening (code-of "(exit)") (code-of "(define second (/ 1 0))")
                      (code-of "(car 1)") right)
         '(right failed))
   (list "other-languages" (notebook-of opening (code-of "#lang racket\n(define second 2)")
                                        (code-of "#reader \"x.rkt\" y") (code-of "(") right)
         '(right failed))
   (list "many-comments"
         (notebook-of (code-of (apply string-append
                                      (for/list ([k 20000]) (format "; remark ~a\n" k))))
                      (text-of "Name: Zoë\n") opening right right-second)
         '(right right))
   (list "=cmd, \"x\" \u202Egnp"
         (notebook-of (text-of "Name: =HYPERLINK(\"http://x\",\"y\")\u001b]0;z\u0007\n")
                      opening right)
         '(right unanswered))
   (list "two-names" (notebook-of (text-of "Name: =1+1") (text-of "Name: Ann A.") opening right)
         '(right unanswered))
   (list "takes-all-time" (notebook-of opening right (code-of "(let loop () (loop))") right-second)
         #rx"took too long")
   (list "writes-lines-of-answers"
         (notebook-of opening (code-of wrong)
                      (code-of "(display \"(frequency answer (sqrt (/ k m)))\\n\")"))
         '(wrong unanswered))))

;; They could do harm to the process that reads or runs them.
(define harmful
  '("faked-outputs" "deep" "deep-objects" "many-values" "huge-number" "huge-cell"
    "redefines-the-judge" "many-comments" "fails-and-exits" "takes-all-time"
    "writes-lines-of-answers" "zzz.ipynb"))

(define (harmless? id) (not (member id harmful)))

(define class-folder (build-path folder "class"))
(make-directory class-folder)
(for ([n (in-list (append notebooks (list (list "aaa" honest) (list "zzz" honest))))])
  (call-with-output-file (build-path class-folder (string-append (car n) ".ipynb"))
    (lambda (out) (write-bytes (cadr n) out))))
(make-directory (build-path class-folder ".ipynb_checkpoints"))
(display-to-file #"x" (build-path class-folder ".ipynb_checkpoints" "a-checkpoint.ipynb"))
(display-to-file "#lang mechanics\n(define second 2)\n" (build-path class-folder "zzz.rkt"))

(define report
  (grade-class w (folder->submissions 'check class-folder) #:seconds (processor-seconds 6)
               #:collect (collect-here-if harmless?)))
(define graded-class (class-report-graded report))

(define (graded-one id)
  (findf (lambda (g) (equal? id (submission-id (graded-submission g)))) graded-class))
(define (statuses g) (map judgment-status (graded-judgments g)))

;; ---------------------------------------------------------------------------

(test-case "there are twenty and more"
  (check-true (>= (length notebooks) 20))
  (check-equal? (length graded-class) (+ 3 (length notebooks))))

(for ([n (in-list notebooks)])
  (test-case (car n)
    (define g (graded-one (visible (car n))))
    (define expected (caddr n))
    (with-check-info (['problem (graded-problem g)] ['statuses (statuses g)])
      (cond [(regexp? expected)
             (check-true (and (graded-problem g) (regexp-match? expected (graded-problem g))))]
            [else (check-equal? (graded-problem g) #f)
                  (check-equal? (statuses g) expected)]))))

(test-case "the honest are judged as ever, under the names in their notebooks"
  (for ([id '("aaa" "zzz.ipynb")])
    (define g (graded-one id))
    (check-equal? (statuses g) '(right right))
    (check-equal? (submission-person (graded-submission g)) "Ann A."))
  (check-equal? (statuses (graded-one "zzz.rkt")) '(unanswered right)))

(test-case "names from notebooks are no formula in a table, no markup on the page, no command"
  (check-equal? (submission-person (graded-submission (graded-one "many-comments"))) "Zoë")
  (define table (class->csv report))
  (check-false (regexp-match? #px"(?m:(^|,)\"\\s*[=+@|%-])" table))
  (check-true (string-contains? table "\"'=cmd, \"\"x\"\""))
  (check-false (regexp-match? #px"\\p{Cc}|\\p{Cf}" (regexp-replace* #rx"\r?\n" table "")))
  (check-false (regexp-match? #px"\u001b|\u202E" (class->page report)))
  (check-false (regexp-match? #px"\u001b|\u202E" (class->text report))))

(delete-directory/files folder)
