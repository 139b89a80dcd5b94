#lang racket/base
;; Wrong numbers of arguments: Racket's message in fewer words, and how a procedure of the
;; reader's is called.

(require mechanics/lang/wrong-call/count-message
         racket/file
         "../../support/checks.rkt" "../../support/run-text.rkt"
         "../../support/errors-of.rkt")

(define (boilerplate name expected given)
  (string-append name (if (equal? name "") "" ": ") "arity mismatch;\n"
                 " the expected number of arguments does not match the given number\n"
                 (if expected (format "  expected: ~a\n" expected) "")
                 (format "  given: ~a" given)))

(test-case "the message in fewer words"
  (define (short name expected given) (restated (boilerplate name expected given)))
  (check-equal? (short "f" 2 1) "f: takes 2 arguments; it was given 1")
  (check-equal? (short "f" 1 0) "f: takes 1 argument; it was given none")
  (check-equal? (short "f" "at least 1" 0) "f: takes at least 1 argument; it was given none")
  (check-equal? (short "f" "1 or 2" 0) "f: takes 1 or 2 arguments; it was given none")
  (check-equal? (short "f" "3 plus an optional argument with keyword #:force" 2)
                "f: takes 3 arguments and perhaps #:force; it was given 2")
  (check-equal? (short "f" "1 plus an argument with keyword #:mass" 2)
                "f: takes 1 argument and #:mass; it was given 2")
  (check-equal? (short "f" "1 plus optional arguments with keywords #:a, #:b, and #:c" 2)
                "f: takes 1 argument and perhaps #:a, #:b, #:c; it was given 2")
  (check-equal? (short "unknown-f" #f 2)
                "unknown-f: takes another number of arguments; it was given 2")
  (check-equal? (short "" 2 1) "application: takes 2 arguments; it was given 1")
  (check-equal? (restated "car: contract violation") "car: contract violation"))

(test-case "at the prompt, word for word"
  (define-values (output errors)
    (session '("-I" "mechanics")
             "(define (energy m v) (* 1/2 m (square v)))"
             "(energy 1)"
             "(define ((L m k) (up t q v)) (- (* 1/2 m (square v)) (* 1/2 k (square q))))"
             "((L 'm 'k) 't 'q 'v)"
             "(+ 1 ((L 'm 'k)))"
             "(L 'm)"
             "(define (T local) (square (velocity local)))"
             "(T 't 'q 'v)"
             "(define f (lambda (x [y 2] #:scale [s 1]) (* s x y)))"
             "(f 1 2 3)"
             "(define (size (up x y)) (sqrt (+ (square x) (square y))))"
             "(size 3 4)"
             "((Lagrangian->energy (L 'm 'k)) 't 'q 'v)"
             "(p->r 't 'r 'v)"
             "(resonance-width 'H0 'H1 (up 't 'q 'p))"
             "(cube 1 2 3)"
             "(define (rest x . more) more)"
             "(rest)"
             "((lambda (x y) x) 1)"
             "(car 1 2)"))
  (check-equal? output '())
  (check-equal?
   errors
   (lines "energy: takes 2 arguments; it was given 1"
          "  it is called as (energy m v)"
          "  missing: v"
          "L: takes 1 argument; it was given 3"
          "  it is called as ((L m k) (up t q v))"
          "  one local tuple: ((L 'm 'k) (up 't 'q 'v))"
          "L: takes 1 argument; it was given none"
          "  it is called as ((L m k) (up t q v))"
          "  missing: (up t q v)"
          "L: takes 2 arguments; it was given 1"
          "  it is called as ((L m k) (up t q v))"
          "  missing: k"
          "T: takes 1 argument; it was given 3"
          "  it is called as (T local)"
          "  one local tuple: (T (up 't 'q 'v))"
          "f: takes 1 or 2 arguments; it was given 3"
          "  it is called as (f x [y 2] [#:scale s])"
          "size: takes 1 argument; it was given 2"
          "  it is called as (size (up x y))"
          "  one tuple: (size (up 3 4))"
          "(Lagrangian->energy L): takes 1 argument; it was given 3"
          "  one local tuple: ((Lagrangian->energy (L 'm 'k)) (up 't 'q 'v))"
          "p->r: takes 1 argument; it was given 3"
          "  it is called as (p->r local)"
          "  one local tuple: (p->r (up 't 'r 'v))"
          "resonance-width: takes 4 arguments; it was given 3"
          "  it is called as (resonance-width H0 H1 k state)"
          "  missing: state"
          "cube: expected 1 argument, given 3: 1, 2, 3"
          "  it is called as (cube x)"
          "rest: takes at least 1 argument; it was given none"
          "  it is called as (rest x more ...)"
          "  missing: x"
          "application: takes 2 arguments; it was given 1"
          "car: takes 1 argument; it was given 2")))

(test-case "in a file, of what it defines, in its own words"
  (check-equal? (errors-of "#lang mechanics"
                           "(define ((L m)"
                           "         (up t q v)) v)"
                           "(list"
                           "  ((L 2) 3 4 5))")
                '("L: takes 1 argument; it was given 3"
                  "  it is called as ((L m) (up t q v))"
                  "  one local tuple: ((L 2) (up 3 4 5))"
                  "  in: my.rkt, line 4: (list ((L 2) 3 4 5))"))
  ;; A file that cannot be read to its end by now is no further error.
  (check-equal? (errors-of "#lang mechanics"
                           "(define (energy m v) (* m v))"
                           "(with-output-to-file \"my.rkt\" #:exists 'truncate"
                           "  (lambda () (displayln \"#lang mechanics\\n(define (energy m\")))"
                           "(energy 1)")
                '("energy: takes 2 arguments; it was given 1"
                  "  in: my.rkt, line 5")))

(test-case "of a file that the prompt requires"
  (define file (make-temporary-file "mechanics-own-~a.rkt"))
  (dynamic-wind
   void
   (lambda ()
     (display-to-file (lines "#lang mechanics" "(provide kinetic)" "(define (kinetic m v) m)")
                      file #:exists 'truncate)
     (define-values (output errors)
       (session '("-I" "mechanics") (format "(require (file ~s))" (path->string file))
                "(kinetic 1)"))
     (check-equal? errors
                   (lines "kinetic: takes 2 arguments; it was given 1"
                          "  it is called as (kinetic m v)"
                          "  missing: v")))
   (lambda () (delete-file file))))
