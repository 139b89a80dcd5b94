#lang racket/base
;; Hints beneath messages of Racket's own forms and procedures, at the prompt.

(require racket/file
         racket/string
         "../../support/checks.rkt" "../../support/run-text.rkt")

(define ask (open-prompt "-I" "mechanics"))

;; The last line of what each input is answered with, on the error port; whether it is ours is known
;; by its end.
(define (last-lines . inputs)
  (for/list ([input (in-list inputs)])
    (define-values (output errors) (ask input))
    (define lines (string-split errors "\n"))
    (and (pair? lines) (string-trim (car (reverse lines))))))

(define no-list
  "a tuple is no list: (ref s 0) is a component, (structure->list s) a list of them")
(define libraries
  "the libraries are mechanics, mechanics/plot, mechanics/book and mechanics/geometry")

(test-case "forms"
  (check-equal? (last-lines "(up 1,2)" "(let (x 3) (* x 2))" "(let* (x 3) x)"
                            "(for/list i 10 i)" "(require mechanics.plot)" "(f ())" "(if #t)")
                (list "no comma separates arguments, and a decimal has a point: (up 1 2.5)"
                      "it is written (let ([m 3]) (* 2 m))"
                      "it is written (let* ([m 3] [k (* 2 m)]) (+ m k))"
                      "it is written (for/list ([i 10]) (* i i))"
                      "as in (require mechanics/plot)"
                      "f() is written (f); the empty list is '()"
                      (string-append
                       "it is written (if (> x 0) x (- x)), with a value for either case; "
                       "for one, (when (> x 0) x)")))
  (check-equal?
   (last-lines (string-append "(module m racket/base (define x 1) (define x 2)) "))
   '("a module of Racket defines a name once; in #lang mechanics it may be defined again")))

(test-case "a dot in a call, and the full path of a file"
  (check-equal? (last-lines "(square . 2)" "(require \"/no/file.rkt\")")
                '("no dot stands between the parts of a call: (square 2)"
                  "a file by its full path is (require (file \"/home/me/system.rkt\"))")))

(test-case "a file that ends inside a form is told with its line"
  (define file (make-temporary-file "open~a.rkt"))
  (call-with-output-file file #:exists 'truncate
    (lambda (port) (write-string "#lang mechanics\n(square 3" port)))
  (define-values (folder name folder?) (split-path file))
  (check-equal? (last-lines (format "(require (file ~s))" (path->string file)))
                (list (format "~a, line 2: the ( there is never closed" name)))
  (delete-file file))

(test-case "values"
  (check-equal? (last-lines "(car (up 1 2))" "(length (down 1 2))" "(list-ref (up 1 2) 0)"
                            "(map sin (up 1 2))" "(set! never-defined 3)")
                (list no-list no-list no-list no-list "a definition is (define x 3)"))
  (check-equal?
   (last-lines "(begin (require racket/math) (sinh 'x))")
   '("this one is Racket's, of numbers alone; (require (except-in racket/math ...)) leaves it out"))
  (check-equal? (last-lines "(car 3)") '("given: 3"))
  (check-equal? (last-lines "(real->double-flonum (sqrt 2))"
                            "(real->decimal-string (/ (sqrt 5) 2) 3)"
                            "(real->decimal-string (sqrt 'x) 3)")
                '("it is exact; (exact->inexact x) is its decimal"
                  "it is exact; (exact->inexact x) is its decimal" "given: (sqrt x)"))
  ;; A pattern is matched by tuples, and what does not match is no list for that.
  (check-equal? (last-lines "(begin (define (f (up t (up x y))) x) (f (up 't 'x)))")
                '("in: (up t x)")))

(test-case "libraries"
  (check-equal? (last-lines "(require mechanics/books)" "(require \"mechanics\")"
                            "(require mechanics/Plot)")
                (list libraries libraries libraries))
  (check-equal?
   (last-lines "(require \"no-such-file.rkt\")")
   '("there is no such file; its place is told from that of the file that requires it")))
