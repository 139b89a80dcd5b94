#lang racket/base
;; Words put together, and what is raised with them.

(require mechanics/error/complain
         mechanics/error/degree-overflow
         mechanics/error/failure
         mechanics/error/hint
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

(define-syntax-rule (raised-by expression) (with-handlers ([exn:fail? values]) expression))

(test-case "a search that found nothing says who searched, and what is known"
  (define e (raised-by (raise-not-convergent 'f "no end" 1.5 0.25 "steps" 7)))
  (check-equal? (exn-message e)
                "f: no end\n  steps: 7\n  best value: 1.5\n  error estimate: 0.25")
  (check-equal? (exn-message (raised-by (raise-not-convergent 'f "no end" 1.5 #f #:show? #f)))
                "f: no end"))

(test-case "which failures say that there is no value"
  (check-true (no-value? (raised-by (raise-singular 'f "pole" 1))))
  (check-true (no-value? (raised-by (/ 1 0))))
  (check-false (no-value? (raised-by (raise-not-convergent 'f "no end" 1 2))))
  (check-false (no-value? (raised-by (car 1)))))

(test-case "a degree beyond the bound of a ring is told with both"
  (define e (raised-by (raise-degree-overflow 9 4)))
  (check-regexp-match #rx"degree: 9\n  bound: 4$" (exn-message e))
  (check-equal? (list (exn:algebra:degree-overflow-degree e) (exn:algebra:degree-overflow-bound e))
                '(9 4)))

(test-case "an integral that is none carries the best value, its error and the place of trouble"
  (for ([raise-with (list raise-divergent-integral raise-unknown-integral raise-rounded-integral)]
        [what '("does not converge" "whether it converges" "too far apart there")])
    (define e (with-handlers ([exn:fail:mechanics? values]) (raise-with 'f 1.5 0.25 3)))
    (check-regexp-match
     (string-append "^f: the integral .*" what
                    ".*\n  trouble near: 3\n  best value: 1[.]5\n  error estimate: 0[.]25$")
     (exn-message e))
    (check-equal? (list (exn:fail:mechanics:not-convergent-value e)
                        (exn:fail:mechanics:not-convergent-error-estimate e)
                        (exn:fail:mechanics:not-convergent:integral-where e))
                  '(1.5 0.25 3))))

(test-case "what to type in place of a list depends on what it looks like"
  (check-equal? (list-hint '(1 2)) "\n  a list is not a tuple; use (up x y ...)")
  (check-equal? (list-hint '() "(up t q v)") "\n  a list is not a tuple; use (up t q v)")
  (for ([x '((+ a b) (sin x) (up 1 2) (sec x))])
    (check-equal? (list-hint x) (quoted-hint x))
    (check-regexp-match #rx"read-expression makes one of it" (list-hint x)))
  (for ([x '(x 1 (+ a . b))]) (check-equal? (quoted-hint x) ""))
  (check-equal? (list-hint 'x) ""))
