#lang racket/base
;; Programs run several in a process: one that fails in some way fails alone, and what it sets
;; ends with it.

(require racket/file
         racket/path
         racket/runtime-path
         rackunit
         (only-in "support/example-programs.rkt" run-example))

(define-runtime-path helper "support/example-programs.rkt")

(define (with-tests . lines)
  (format "#lang racket/base\n(module+ test\n  (require rackunit)\n~a)\n"
          (apply string-append lines)))

;; name, text, failed and all tests, what is said of it
(define programs
  `(("good" ,(with-tests "(check-equal? 1 1) (check-equal? 2 2)") 0 2 #rx"^$")
    ("wrong" ,(with-tests "(check-equal? 1 1) (check-equal? 1 2)") 1 2
             #rx"FAILURE.*wrong.rkt.*actual: +1")
    ("raising" ,(with-tests "(check-equal? 1 1) (error \"it raises\")") 1 2
               #rx"the tests of raising.rkt.*it raises")
    ("exiting" ,(with-tests "(check-equal? 1 1) (exit 0)") 1 2
               #rx"the tests of exiting.rkt.*exited with code 0")
    ("hanging" ,(with-tests "(check-equal? 1 1)"
                            "(log-message (current-logger) 'info 'hanging \"now\" #f)"
                            "(sync never-evt)")
               1 2 #rx"the tests of hanging.rkt.*stopped, for it does not end")
    ("empty" ,(with-tests "(void)") 1 1 #rx"the tests of empty.rkt.*ran no test")
    ("untested" "#lang racket/base\n" 1 1 #rx"the tests of untested.rkt.*not declared|submod")
    ("setting" ,(with-tests "(print-graph #t) (current-command-line-arguments (vector \"a\"))"
                            "(check-equal? 1 1)")
               0 1 #rx"^$")
    ("unchanged" ,(with-tests "(check-false (print-graph))"
                              "(check-equal? (current-command-line-arguments) (vector))")
                 0 2 #rx"^$")))

;; In a namespace with a rackunit of its own, where failures count.
(define space (make-base-namespace))
(define-values (tests over-time test-log)
  (parameterize ([current-namespace space])
    (namespace-require `(file ,(path->string helper)))
    (values (eval '(lambda (name space file) (alone name (test-example space file))))
            (eval 'over-time)
            (dynamic-require 'rackunit/log 'test-log))))

(define (fresh)
  (define namespace (make-base-empty-namespace))
  (namespace-attach-module space 'rackunit namespace)
  namespace)

;; -> failed and all tests of the program, what was said
(define (tested file)
  (define said (open-output-string))
  (define before (test-log))
  (parameterize ([current-error-port said] [current-output-port said]
                 [over-time (make-log-receiver (current-logger) 'info 'hanging)]
                 [current-command-line-arguments (vector)])
    (tests (format "the tests of ~a" (file-name-from-path file)) (fresh) file))
  (define after (test-log))
  (values (- (car after) (car before)) (- (cdr after) (cdr before)) (get-output-string said)))

(define folder (make-temporary-file "programs-~a" 'directory))

(for ([program (in-list programs)])
  (define-values (name text failed all said) (apply values program))
  (define file (build-path folder (string-append name ".rkt")))
  (display-to-file text file)
  (test-case (format "~a: ~a of ~a fail" name failed all)
    (define-values (f a s) (tested file))
    (check-equal? (list f a) (list failed all))
    (check-regexp-match said s)))

(test-case "a program sees its arguments, and what it prints is given"
  (define file (build-path folder "telling.rkt"))
  (display-to-file "#lang racket/base\n(current-command-line-arguments)\n" file)
  (check-equal? (run-example (fresh) file "a" "b") "'#(\"a\" \"b\")\n"))

(delete-directory/files folder)
