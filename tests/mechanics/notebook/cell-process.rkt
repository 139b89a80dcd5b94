#lang racket/base
;; The process that evaluates cells: its results, streams, failures, breaks and questions.

(require (only-in racket/list count)
         racket/match
         racket/string
         "../support/cell-client.rkt" "../support/checks.rkt")

(define c (start-cells))
(define (run code [during void]) (run-cell c code during))

(define LaTeX "text/latex")
(define plain "text/plain")

;; ---------------------------------------------------------------------------
;; Results

(test-case "a formula is TeX, and the expression it prints as; what was assumed stands beneath"
  (define m (run "(sqrt (square 'y))"))
  (check-equal? (bundles m LaTeX) '("$\\displaystyle y$\n\n$\\text{assuming }y\\ge 0$"))
  (check-equal? (bundles m plain) '("y\n; assuming (>= y 0)")))

(test-case "the value of each form is shown, and definitions stay"
  (run "(define (double x) (* 2 x))")
  (check-equal? (bundles (run "(double 'a)\n(double 'b)\n(define c 1)") plain)
                '("(* 2 a)" "(* 2 b)")))

(test-case "a wide formula is broken into lines"
  (define m
    (run "(for/sum ([k 12]) (* (expt 'x k) ((literal-function 'f) k)))"))
  (check-true (string-contains? (car (bundles m LaTeX)) "\\begin{aligned}")))

(test-case "a verdict is a page's elements without scripts, with formulas in TeX"
  (define html (car (bundles (run "(verify-equal (* 'a 'b) 'c)") "text/html")))
  (check-true (string-prefix? html "<div class=\"mechanics mathjax_ignore"))
  (check-true (string-contains? html "refuted: the residual is not zero"))
  (check-true (string-contains? html "mathjax_process tex2jax_process\">\\(\\displaystyle "))
  (check-false (regexp-match? #rx"<script|<math" html)))

(test-case "strings of the reader are text"
  (check-equal? (bundles (run "\"<b>$1\"") plain) '("\"<b>$1\""))
  (check-equal? (bundles (run "\"<b>$1\"") "text/html") '(#f)))

(test-case "a table"
  (check-true (string-contains? (car (bundles (run "(list (list 1 2) (list 3 4))") "text/html"))
                                "<table>")))

(test-case "a style that the reader chose holds"
  (run ",infix")
  (check-equal? (bundles (run "(/ 'a 'b)") plain) '("a/b"))
  (check-equal? (bundles (run "(/ 'a 'b)") LaTeX) '(#f))
  (check-equal? (outcome (run "(display-style 'automatic)")) 'ok))

(test-case "names in other scripts"
  (check-equal? (bundles (run "(define (力 m) (* m 'θ))\n(力 2)") plain) '("(* 2 θ)")))

(test-case "a picture is SVG and PNG"
  (define m (run "(require mechanics/plot)\n(define f (frame 0 1 0 1))\nf"))
  (check-true (string-prefix? (car (bundles m "image/svg+xml")) "<svg"))
  (check-true (string-prefix? (car (bundles m "image/png")) "iVBOR")))

(test-case "an animation is a page in a frame that may only run its script, with a picture in it"
  (define html
    (car (bundles (run (string-append
                        "(require mechanics/animate)\n(define (spin t) (up t t 1))\n"
                        "(animate spin (draw-pendulum) #:from 0 #:to 1)"))
                  "text/html")))
  (check-true (string-prefix? html "<iframe sandbox=\"allow-scripts\""))
  (check-true (string-contains? html "<img alt=\"(animation from "))
  (check-false (regexp-match? #rx"<script" html)))

(test-case "a frame that a cell draws in is shown at its end, once, and later in its place"
  (define (displays code)
    (for/list ([m (in-list (run code))] #:when (equal? (hash-ref m 'kind) "shown"))
      (list (hash-ref m 'display #f) (hash-ref m 'update #f))))
  (run "(define g (frame 0 1 0 1))")
  (define first-time (displays "(plot-point g 0.5 0.5)\n(plot-point g 0.6 0.5)"))
  (check-equal? (map cadr first-time) '(#f))
  (define name (caar first-time))
  (check-equal? (displays "(plot-point g 0.1 0.1)") (list (list name #t)))
  (check-equal? (displays "(begin (plot-point g 0.2 0.2) g)") (list (list name #f)))
  (check-equal? (displays "(+ 1 1)") '((#f #f)))
  (run "(define (dot k) (define h (frame 0 2 0 1)) (plot-point h k 0.5) h)")
  (check-equal? (displays "(interact ([k 1 2]) (dot k))") '()))

;; ---------------------------------------------------------------------------
;; Lines of a session

(test-case "commands, and lines pasted with their prompt"
  (check-true (string-contains? (texts (run ",help") "stdout") ",more         the next screen"))
  (check-true (string-contains? (texts (run ",help Gamma") "stdout") "(Gamma q"))
  (check-equal? (bundles (run "> (+ 1 1)\n> (+ 1 2)") plain) '("2" "3")))

(define end "a notebook is left by closing it, and its kernel ended in the menu Kernel")

(test-case "bad input is answered in words, and the next cell works"
  (for ([code+message
         `(("(+ 1" "cell: the input ends inside a form, which is left out; it begins with  (+ 1" #f)
           ("x = 3" "cell: a definition is written (define x 3)" #f)
           (")" ,regexp? #f)
           ("#lang racket\n(+ 1 2)"
            ,(string-append
              "cell: a notebook has one language, this one; leave the line #lang out\n"
              "  a program of another language is a file: (require \"file.rkt\")") #f)
           ("(module+ test 1)"
            "cell: (module+ ...) is part of a file; in a cell its forms stand by themselves" 1)
           ("(exit)" ,(string-append "exit: " end) 1)
           (",quit" ,(string-append "cell: " end) #f)
           ("(raise 5)" "uncaught: 5" 1))])
    (match-define (list code message line) code+message)
    (define found (outcome (run code)))
    (with-check-info (['code code])
      (check-pred list? found)
      (check-equal? (cadr found) (or line 'null) code)
      (when (string? message) (check-equal? (car found) message)))
    (check-equal? (bundles (run "(+ 1 1)") plain) '("2"))))

(test-case "a cell that cannot be read evaluates nothing"
  (check-pred list? (outcome (run "(define not-made 1)\n(+ 1")))
  (check-true (string-prefix? (car (outcome (run "not-made"))) "not-made: undefined")))

(test-case "what came before a failing form is shown, and its line is told"
  (define m (run "(+ 'a 'a)\n(display \"so far\")\n\n(car\n  5)\n(+ 1 2)"))
  (check-equal? (bundles m plain) '("(* 2 a)"))
  (check-equal? (texts m "stdout") "so far")
  (check-equal? (outcome m) '("car: contract violation\n  expected: pair?\n  given: 5" 4)))

(test-case "an unknown name is told what may have been meant"
  (check-true (string-contains? (car (outcome (run "(Lagrange-equation 1)")))
                                "did you mean Lagrange-equations?")))

;; ---------------------------------------------------------------------------
;; Streams

(test-case "both streams, before the result that follows"
  (define m (run "(begin (display \"out\") (display \"err\" (current-error-port)) 7)"))
  (check-equal? (texts m "stdout") "out")
  (check-equal? (texts m "stderr") "err")
  (check-equal? (hash-ref (cadr (reverse m)) 'kind) "shown"))

(test-case "characters are whole, however they are cut"
  (check-equal? (texts (run "(for ([_ 50000]) (write-string \"θ力\"))") "stdout")
                (string-append* (for/list ([_ 50000]) "θ力"))))

(test-case "more than a megabyte is counted, not sent"
  (define m (run "(display (make-string 10000000 #\\a))"))
  (check-equal? (string-length (texts m "stdout")) 1000000)
  (check-equal? (texts m "stderr")
                "\n; 9000000 more bytes of output are left out; write them to a file\n"))

(test-case "a thread that writes after its cell"
  (run "(define t (thread (lambda () (sleep 0.3) (display \"late\"))))")
  (check-equal? (texts (run "(begin (thread-wait t) (sleep 0.1))") "stdout") "late"))

;; How often it asked for a line
(define (questions m) (count (lambda (x) (equal? (hash-ref x 'kind) "input")) m))

(test-case "a command of the system is not given what the reader types"
  (define m (run "(require racket/system)\n(system \"echo sub\")"))
  (check-equal? (texts m "stdout") "sub\n")
  (check-equal? (questions m) 0)
  (check-equal? (outcome m) 'ok))

(test-case "a program that waits, then reads a line, asks once"
  (define (answer m)
    (when (equal? (hash-ref m 'kind) "input")
      (sleep 0.3)
      (send-to c 'do "input" 'text "typed")))
  (define m (run "(begin (sync/timeout 0.1 (current-input-port)) (read-line))" answer))
  (check-equal? (bundles m plain) '("\"typed\""))
  (check-equal? (questions m) 1))

;; ---------------------------------------------------------------------------
;; Breaks

;; The cell is broken when it has written that it has begun.
(define (broken code)
  (outcome (run (string-append "(displayln \"begun\")\n" code)
                (lambda (m)
                  (when (equal? (hash-ref m 'text #f) "begun\n") (break-last))))))

(define (break-last) (send-to c 'do "break" 'id (cells-number c)))

(test-case "loops, flonum loops, sleep and reading are broken, and the next cell works"
  (for ([code '("(let loop () (loop))"
                "(let loop ([x 0.5]) (loop (* 4.0 x (- 1.0 x))))"
                "(sleep 1000)"
                "(read-line)"
                "(evolve-trajectory (lambda (s) (up 1 (ref s 2) (- (ref s 1)))) (up 0 1 0) 1e9)"
                "(expt 7 (expt 10 9))")])
    (with-check-info (['code code]) (check-equal? (broken code) '("interrupted" 2)))
    (check-equal? (bundles (run "(+ 1 1)") plain) '("2"))))

(test-case "a break that comes before its cell, and one that comes late"
  (send-to c 'do "break" 'id (add1 (cells-number c)))
  (check-equal? (outcome (run "(sleep 1000)")) '("interrupted" null))
  (break-last)
  (check-equal? (outcome (run "(sleep 0.2)")) 'ok))

;; ---------------------------------------------------------------------------
;; Interactions

;; -> the message that shows the value of the code
(define (interaction-of code)
  (define m (run code))
  (check-equal? (outcome m) 'ok)
  (findf (lambda (x) (equal? (hash-ref x 'kind) "interaction")) m))

;; The value in plain text, where the controls of the interaction are at the values
(define (moved-to interaction . values)
  (define a (answers-to c "frame" 'number (hash-ref interaction 'number) 'values values))
  (hash-ref (hash-ref a 'data) 'text/plain))

(test-case "an interaction tells its controls and its first value; values follow where it is moved"
  (define i
    (interaction-of
     "(interact ([k 0 1 #:step 1/2] [n (list 'a 'b) #:start 'b] [d? #t] [s \"x\"]) (list k n d? s))"))
  (check-equal? (for/list ([x (hash-ref i 'controls)]) (hash-ref x 'kind))
                '("number" "choice" "boolean" "text"))
  (check-equal? (for/list ([x (hash-ref i 'controls)]) (hash-ref x 'labels))
                '(("0" "1/2" "1") ("a" "b") ("#f" "#t") ()))
  (check-equal? (for/list ([x (hash-ref i 'controls)]) (hash-ref x 'start)) '(0 1 1 "x"))
  (check-equal? (for/list ([x (hash-ref i 'controls)]) (hash-ref x 'step)) '(0.5 null null null))
  (check-equal? (hash-ref (hash-ref i 'data) 'text/plain) "'(0 b #t \"x\")")
  (check-equal? (moved-to i 0.5 0 #f "y") "'(1/2 a #f \"y\")"))

(test-case "a value that fails is words in its place, and the next one comes"
  (define i (interaction-of "(interact ([k 0 9]) (/ 'a k))"))
  (check-equal? (hash-ref (hash-ref i 'data) 'text/plain) "/: division by zero\n  in: (/ a 0)")
  (check-equal? (moved-to i 2) "(* 1/2 a)"))

(test-case "one that takes long is broken, and the next one comes"
  (define i (interaction-of "(interact ([k 0 9]) (if (= k 3) (let loop () (loop)) k))"))
  (send-to c 'do "frame" 'id 900 'number (hash-ref i 'number) 'values '(3))
  (sleep 0.2)
  (send-to c 'do "break" 'id 900)
  (check-equal? (hash-ref (receive-from c) 'data) 'null)
  (check-equal? (moved-to i 4) "4"))

(test-case "an interaction of a process that is gone"
  (define a (answers-to c "frame" 'number 999 'values '(1)))
  (check-equal? (hash-ref (hash-ref a 'data) 'text/plain)
                "the definitions that this rests on are gone: run its cell again"))

(test-case "bad controls are answered in words"
  (check-true (string-prefix? (car (outcome (run "(interact ([k 2 2]) k)")))
                              "interact: the range of k is empty")))

;; ---------------------------------------------------------------------------
;; Maps explored

(test-case "a map is explored where its frame is shown, which then has the orbits"
  (define m (run (string-append "(require mechanics/book)\n(define win (frame 0 :2pi 0 :2pi))\n"
                                "(explore-map win (standard-map 0.6) 10)\n(+ 1 1)")))
  (check-equal? (for/list ([x (in-list m)]) (hash-ref x 'kind)) '("exploration" "shown" "done"))
  (check-equal? (hash-ref (car m) 'text) "0 orbits, 0 points")
  (define a
    (answers-to c "explore" 'number (hash-ref (car m) 'number)
                'actions '(("point" 0.5 0.5 0.5 0.5) ("point" 0.6 0.5 0.6 0.5) ("undo"))))
  (check-equal? (hash-ref a 'text) "1 orbit, 11 points")
  (check-false (hash-ref a 'more))
  (check-true (string-prefix? (hash-ref (hash-ref a 'data) 'image/svg+xml) "<svg"))
  (check-equal? (bundles (run "(length (frame-points win))") plain) '("11"))
  (check-equal? (map (lambda (x) (hash-ref x 'kind)) (run "win")) '("shown" "done")))

;; ---------------------------------------------------------------------------
;; Questions of an editor

(test-case "names are completed, the reader's own as well"
  (run "(define Lagrangian-of-mine 1)")
  (define a (answers-to c "complete" 'code "(+ (Lagrangian-o" 'cursor 16))
  (check-equal? (hash-ref a 'matches) '("Lagrangian-of-mine"))
  (check-equal? (list (hash-ref a 'start) (hash-ref a 'end)) '(4 16)))

(test-case "names come with the way they are called"
  (run "(define ((L-of-mine m) local) 1)")
  (define (signature-of code)
    (hash-ref (answers-to c "complete" 'code code 'cursor (string-length code)) 'signatures))
  (check-equal? (signature-of "L-of-m") '("((L-of-mine m) local)"))
  (check-equal? (signature-of "Gamma-ba") '("(Gamma-bar f)  → function"))
  (run "(define no-function 1)")
  (check-equal? (signature-of "no-functio") '("")))

(test-case "what is known of the name at the cursor"
  (define a (answers-to c "describe" 'code "(Gamma q)" 'cursor 3))
  (check-true (hash-ref a 'found))
  (define plain (hash-ref (hash-ref a 'data) 'text/plain))
  (check-true (string-prefix? plain "(Gamma q [n])"))
  (check-true (string-contains? plain "\n  > ((Gamma q) 't)\n  (up t (up (x t) (y t))"))
  (check-false (hash-ref (answers-to c "describe" 'code "( 1)" 'cursor 1) 'found)))

(test-case "the example of a card is typeset, strings of others are text"
  (define (markup code)
    (hash-ref (hash-ref (answers-to c "describe" 'code code 'cursor 1) 'data) 'text/html))
  (check-true (string-contains? (markup "square")
                                "&gt; (square 'x)</pre><div class=\"mathjax_process"))
  (check-true (string-contains? (markup "square") "$\\displaystyle x^{2}$</div><pre>"))
  (run "(define (<b> x) x)")
  (check-true (string-contains? (markup "<b>") "<pre>&lt;b&gt; is your own definition")))

(test-case "is a cell complete?"
  (for ([code '("(+ 1 2)" "(+ 1" ")" "\"a")]
        [status '("complete" "incomplete" "invalid" "incomplete")])
    (check-equal? (hash-ref (answers-to c "completeness" 'code code) 'status) status)))

(test-case "at end of file the process ends, whatever it is doing"
  (send-to c 'do "cell" 'id 1000 'code "(let loop () (loop))")
  (check-equal? (end-cells c) 0))
