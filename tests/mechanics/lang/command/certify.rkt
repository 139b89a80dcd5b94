#lang racket/base
;; `raco mechanics certify`: which verdicts of a program have certificates, their files, and what is
;; said where there is nothing to certify.

(require racket/file racket/string
         "../../support/checks.rkt"
         "../../../../mechanics/lang/command/raco.rkt")

;; for-label: compiled with this file.
(require (for-label "../../../../mechanics/lang/command/certify-program.rkt"))

(define folder (make-temporary-file "certify~a" 'directory))

(define (answer . arguments)
  (define out (open-output-string))
  (define status
    (parameterize ([current-output-port out] [current-error-port out]
                   [current-directory folder])
      (run-command-line (cons "certify" arguments))))
  (list status (get-output-string out)))

(define (program name . lines)
  (display-lines-to-file (cons "#lang mechanics" lines) (build-path folder name)
                         #:exists 'truncate)
  name)

(define (wrote? . parts) (file-exists? (apply build-path folder parts)))

(test-case "each proved verdict that is shown has a file, named by the program; others say why"
  (program "two-springs.rkt"
           "(verify-equal (* 2 'x) (+ 'x 'x))"
           "(verify-equal 'x 'y)"
           "(verify-equal (* 2 (acosh 'x)) (+ (acosh 'x) (acosh 'x)))")
  (check-equal?
   (answer "two-springs.rkt" "--write")
   (list 1
         (string-append
          "(verify-equal (* 2 (quote x)) (+ (quote x) (quote x)))\n"
          "    two-springs-certificates/two_springs_1.v: "
          "a theorem for Coq to check: both sides are equal; "
          "the derivatives are ours\n"
          "(verify-equal (quote x) (quote y))\n    refuted\n"
          "(verify-equal (* 2 (acosh (quote x))) (+ (acosh (quote x)) (acosh (quote x))))\n"
          "    no certificate yet: Coq's library has no acosh\n"
          "3 verdicts shown, 2 proved, 1 with a certificate, 1 refuted\n"
          "1 proved and not certified; above stands why\n")))
  (check-true (wrote? "two-springs-certificates" "two_springs_1.v")))

(test-case "the folder is chosen by -o; a program that shows no verdict has nothing to certify"
  (program "spring.rkt" "(verify-equal (* 2 'x) (+ 'x 'x))")
  (check-equal? (car (answer "spring.rkt" "--write" "-o" "proofs")) 0)
  (check-true (wrote? "proofs" "spring_1.v"))
  (program "none.rkt" "(+ 1 2)")
  (check-equal? (answer "none.rkt" "--write")
                (list 0 (string-append
                         "0 verdicts shown, 0 proved, 0 with a certificate\n"
                         "a verdict that is shown, as a result or by printing it, "
                         "gets a certificate\n")))
  (check-false (directory-exists? (build-path folder "none-certificates"))))

(test-case "a folder that is a file is told before the program runs"
  (program "spring.rkt" "(verify-equal (* 2 'x) (+ 'x 'x))")
  (check-equal? (answer "spring.rkt" "-o" "none.rkt")
                (list 2 (string-append "certify: certificates go into a folder, "
                                       "and there is a file of that name\n  given: none.rkt\n"))))

(test-case "the folder is made, those above it are not"
  (program "spring.rkt" "(verify-equal (* 2 'x) (+ 'x 'x))")
  (check-equal? (answer "spring.rkt" "--write" "-o" "nowhere/proofs")
                (list 2 "certify: there is no such folder\n  given: nowhere\n"))
  (check-false (directory-exists? (build-path folder "nowhere"))))

(test-case "certificates of a run before go, of that program and no other; other files stay"
  (define (lines . all) (apply program "changing.rkt" all))
  (lines "(verify-equal (* 2 'x) (+ 'x 'x))" "(verify-equal (* 3 'x) (+ 'x 'x 'x))")
  (program "changing_1.rkt" "(verify-equal (* 2 'x) (+ 'x 'x))")
  (for ([p '("changing.rkt" "changing_1.rkt")]) (answer p "--write" "-o" "changing"))
  (display-to-file "mine" (build-path folder "changing" "changing_7.v"))
  (lines "(verify-equal (* 2 'x) (+ 'x 'x))")
  (answer "changing.rkt" "--write" "-o" "changing")
  (check-equal? (map path->string (directory-list (build-path folder "changing")))
                '("changing_1.v" "changing_1_1.v" "changing_7.v")))

(test-case "verdicts that are printed, or stand in lists, are certified as well, each once"
  (program "printed.rkt"
           "(define sum (verify-equal (* 2 'x) (+ 'x 'x)))"
           "(displayln sum)"
           "(list sum (verify-equal (* 3 'x) (+ 'x 'x 'x)) (up 1 (verify-equal 'x 'y)))"
           "(printf \"~a\\n\" (verify-equal (* 4 'x) (+ (* 3 'x) 'x)))"
           "(hash 'in-a-table (verify-equal (* 5 'x) (+ (* 4 'x) 'x)))"
           "(vector (box (verify-equal (* 6 'x) (+ (* 5 'x) 'x))))")
  (define told (answer "printed.rkt" "--write"))
  (check-regexp-match #rx"^.displayln sum.\n" (cadr told))
  (check-regexp-match #rx"6 verdicts shown, 5 proved, 5 with a certificate, 1 refuted\n$"
                      (cadr told)))

(test-case "a file that is no certificate stays"
  (program "kept.rkt" "(verify-equal (* 2 'x) (+ 'x 'x))")
  (make-directory (build-path folder "notes"))
  (display-to-file "my notes" (build-path folder "notes" "kept_1.v"))
  (define told (answer "kept.rkt" "--write" "-o" "notes"))
  (check-equal? (car told) 2)
  (check-regexp-match #rx"a file of that name, which is no certificate\n  given: notes/kept_1.v"
                      (cadr told))
  (check-equal? (file->string (build-path folder "notes" "kept_1.v")) "my notes"))

(test-case "a form is told in up to 90 letters"
  (define-values (whole cut) (values (make-string 90 #\w) (make-string 91 #\c)))
  (apply program "long.rkt"
         (for/list ([name (list whole cut)] [k '(7 8)])
           (format "(define ~a (verify-equal (* ~a 'x) (+ (* ~a 'x) 'x)))\n~a"
                   name k (- k 1) name)))
  (define told (cadr (answer "long.rkt" "--write")))
  (check-true (string-contains? told (string-append whole "\n")))
  (check-true (string-contains? told (format "\n~a...\n" (make-string 87 #\c)))))

(test-case "a verdict that a required module shows is certified, with the first form"
  (program "library.rkt" "(verify-equal (* 2 'x) (+ 'x 'x))")
  (program "user.rkt" "(require \"library.rkt\")" "(verify-equal (* 3 'x) (+ 'x 'x 'x))")
  (define told (answer "user.rkt" "--write"))
  (check-equal? (car told) 0)
  (check-regexp-match #rx"^.require \"library.rkt\".\n" (cadr told))
  (check-regexp-match #rx"2 verdicts shown, 2 proved, 2 with a certificate\n" (cadr told)))

(test-case "a program that ends early is told; what it showed before has its certificates"
  (program "early.rkt" "(verify-equal (* 2 'x) (+ 'x 'x))" "(car '())")
  (define told (answer "early.rkt" "--write"))
  (check-equal? (car told) 1)
  (check-true (string-prefix? (cadr told) "certify: early.rkt did not run to its end:\ncar: ")))

(delete-directory/files folder)
