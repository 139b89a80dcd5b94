#lang racket/base
;; Words put together, and what is raised with them.

(require mechanics/error/complain
         mechanics/error/machine-limits
         mechanics/error/message-words
         "../support/checks.rkt")

(test-case "texts are joined by commas, or as one likes"
  (check-equal? (joined '()) "")
  (check-equal? (joined '("a")) "a")
  (check-equal? (joined '("a" "b" "c")) "a, b, c")
  (check-equal? (joined '("a" "b") " plus ") "a plus b"))

(test-case "one is singular"
  (check-equal? (for/list ([n '(0 1 2)]) (counted n "argument"))
                '("0 arguments" "1 argument" "2 arguments")))

;; A reader recognises a value by its beginning, and must find what is said after it.
(test-case "long lines of what is named in a message are shown by their beginning"
  (define long (make-string 1000 #\x))
  (check-equal? (message 'f "~a is no path; use ~a" (list long 'Gamma))
                (format "f: ~a ...600 more characters is no path; use Gamma"
                        (make-string 400 #\x)))
  (define lines (joined (for/list ([n 100]) (format "line ~a" n)) "\n"))
  (check-equal? (message 'f "~a" (list lines)) (string-append "f: " lines))
  (check-equal? (message 'f "~a ~a" (list (make-string 400 #\y) 7))
                (format "f: ~a 7" (make-string 400 #\y))))

(test-case "what is raised says who, and is of the kind it should be"
  (for ([raise-with (list complain complain-of-arity raise-unavailable raise-unwritable)]
        [kind? (list exn:fail:contract? exn:fail:contract:arity?
                     exn:fail:unsupported? exn:fail:filesystem?)])
    (define (check who)
      (check-exn (lambda (e) (and (kind? e) (equal? (exn-message e) "f: 1 and ~a")))
                 (lambda () (raise-with who "~a and ~a" 1 "~a"))))
    (check 'f)
    (check "f"))
  (check-exn (lambda (e) (not (exn:fail:contract? e)))
             (lambda () (raise-unavailable 'f "no"))))
