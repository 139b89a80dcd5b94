#lang racket/base
;; The library in racket/sandbox: verdicts made inside are recognised outside, and the grader
;; of the manual cannot be talked into a verdict, nor made to run what came from inside.

(require mechanics
         racket/sandbox
         racket/string
         "support/checks.rkt" "support/patience.rkt" "../../examples/mechanics/sandbox/grader.rkt")

(define (open-sandbox specs)
  (parameterize ([sandbox-namespace-specs (append (sandbox-namespace-specs) specs)]
                 [sandbox-memory-limit 512])
    (make-evaluator 'mechanics)))

(define claim '(prove-zero (- (sin (* 2 'x)) (* 2 (sin 'x) (cos 'x)))))

(test-case "a verdict made inside is one outside, where the library is shared"
  (define inside (open-sandbox '(mechanics)))
  (define verdict (inside claim))
  (check-true (verdict? verdict))
  (check-true (proved? verdict))
  (kill-evaluator inside))

(test-case "it is none where the sandbox has a library of its own"
  (define inside (open-sandbox '()))
  (check-false (verdict? (inside claim)))
  (kill-evaluator inside))

(test-case "what is assumed inside is not assumed outside"
  (define inside (open-sandbox '(mechanics)))
  (inside '(assume '(< m 0)))
  (check-equal? (inside '(assumptions)) '((< m 0)))
  (check-equal? (assumptions) '())
  (kill-evaluator inside))

;; ---------------------------------------------------------------------------
;; The grader

(define right "(define (path t) (* 'a (cos (* 'omega t))))")
(define wrong "(define (path t) (* 'a (cos (* 2 'omega t))))")

;; An hour, which nothing here takes.
(define (answer #:seconds [seconds 3600] . lines)
  (grade (string-append "#lang mechanics\n" (string-join lines "\n"))
         #:seconds seconds #:megabytes 200))

(define-syntax-rule (check-status expected line ...)
  (check-equal? (car (answer line ...)) expected))

(test-case "paths are graded, with the text of the verdict"
  (check-equal? (answer right) '(proved "proved: the residual is zero"))
  (check-status 'refuted wrong)
  (check-true (string-contains? (cadr (answer wrong)) "\n  residual: (* -3 a m ")))

(test-case "what the program defines and assumes does not change the question"
  (check-status 'refuted wrong "(define (verify-solution L q) (prove-zero 0))")
  (check-status 'refuted wrong "(assume '(< a 0))" "(automatic-assumptions #f)"))

(define proved-already "(lambda () (prove-zero 0))")

(test-case "a path that answers in our place gets no verdict"
  (check-status 'failed
                (format "(define (path t) (abort-current-continuation ~a ~a))"
                        "(default-continuation-prompt-tag)" proved-already))
  (check-status 'failed "(define escape #f)"
                "(call/cc (lambda (k) (set! escape k)))"
                "(define (path t) (escape (prove-zero 0)))"))

(test-case "limits of time and memory hold, in the program and in the path"
  (define looping "(let loop () (loop))")
  (define filling "(let loop ([l '()]) (loop (cons (make-bytes 10000000) l)))")
  (define too-much '(failed "it took too long, or too much memory"))
  (define second (clock-seconds 1))
  (check-equal? (answer #:seconds second looping) too-much)
  (check-equal? (answer #:seconds second (format "(define (path t) ~a)" looping)) too-much)
  (check-equal? (answer (format "(define (path t) ~a)" filling)) too-much))

(test-case "files are closed"
  (check-status 'failed "(define secret (call-with-input-file \"/etc/passwd\" read-line))" right))

;; A value that runs a program of its own when it is printed.
(test-case "what is raised inside is not printed outside"
  (define report (open-output-string))
  (define result
    (parameterize ([current-output-port report] [current-error-port report])
      (answer "(struct trap () #:property prop:custom-write"
              "  (lambda (x port mode) (write-string \"sprung\" port)))"
              "(define (path t) (raise (trap)))")))
  (check-equal? result '(failed "it stopped with an error"))
  (check-equal? (get-output-string report) ""))
