#lang racket/base
;; Calls as in version 0.2 tell how they are written now: keywords, tolerances without one,
;; arguments in another order.

(require (for-label mechanics/plot mechanics/scmutils)
         mechanics
         (only-in mechanics/generic/former-arguments former-keywords former-counts)
         racket/file
         racket/runtime-path
         "../support/checks.rkt" "../support/messages.rkt")

(define-runtime-path conventions "../../../scribblings/mechanics/reference/conventions.scrbl")

(define (exported name)
  (for/or ([library '(mechanics mechanics/plot mechanics/scmutils)])
    (dynamic-require library name (lambda () #f))))

;; These take keywords where what they make is called.
(define makers '(state-advancer evolve linearized-flow))

(for* ([entry (in-list former-keywords)]
       [who (in-list (cddr entry))]
       #:unless (memq who makers))
  (test-case (format "~a of ~a" (car entry) who)
    (define f (exported who))
    (check-exn (lambda (e)
                 (check-regexp-match
                  (format "^~a: there is no keyword ~a here\n  its keywords: .*\n  ~a$"
                          who (regexp-quote (format "~s" (car entry)))
                          (regexp-quote (cadr entry)))
                  (exn-message e)))
               (lambda () (keyword-apply f (list (car entry)) '(0) '())))))

(test-case "what replaces a keyword is one of the procedure's"
  (for* ([entry (in-list former-keywords)]
         [new (in-list (regexp-match* #rx"#:[^ ]+" (cadr entry)))]
         #:unless (equal? new (format "~s" (car entry)))
         [who (in-list (cddr entry))]
         #:unless (memq who makers))
    (define f (exported who))
    (define known
      (with-handlers ([exn:fail? exn-message]) (keyword-apply f '(#:no-such) '(0) '())))
    (check-true (regexp-match? (regexp-quote new) known) (format "~a ~a" who new))))

(test-case "the manual's table has them all"
  (define page (file->string conventions))
  (for* ([entry (in-list former-keywords)] [word (in-list (cons (car entry) (cddr entry)))])
    (check-true (regexp-match? (regexp-quote (format "~s" word)) page) (format "~s" word)))
  (for ([entry (in-list former-counts)])
    (check-true (regexp-match? (regexp-quote (format "@racket[~s]" (car entry))) page))))

(define (oscillator) (lambda (s) (up 1 (ref s 2) (- (ref s 1)))))

(test-case "of what state-advancer and evolve make"
  (for ([ask (list (lambda () ((state-advancer oscillator) (up 0 1 0) 1 #:progress #f))
                   (lambda () ((evolve oscillator) (up 0 1 0) void 0.1 1 #:progress #f)))])
    (check-exn #rx"\n  it is called #:progress[?] now$" ask)))

(test-case "a tolerance without its keyword"
  (check-equal? (map car former-counts) '(D-numeric Hamiltonian-action))
  (check-message (string-append "D-numeric: takes 1 argument; it was given 2\n"
                                "  its keywords: (#:report #:tolerance)\n"
                                "  the tolerance is given as #:tolerance now")
                 (D-numeric exp 1e-9)
                 exn:fail:contract:arity?)
  (check-exn #rx"^Hamiltonian-action: takes 5 arguments; it was given 6\n.*#:tolerance now$"
             (lambda () (Hamiltonian-action square sin cos 0 1 1e-9))))

(test-case "the tolerance of the book's procedures, with a keyword and without"
  (define (evaluations value bound n) n)
  (define loose (definite-integral (lambda (x) (sqrt x)) 0 1 1e-3 #:report evaluations))
  (check-equal? (definite-integral (lambda (x) (sqrt x)) 0 1 #:tolerance 1e-3 #:report evaluations)
                loose)
  (check-equal? (bisect cos 1 2 1e-3) (bisect cos 1 2 #:tolerance 1e-3))
  (define (L s) (* 1/2 (square (velocity s))))
  (check-equal? (Lagrangian-action L sin 0 1 1e-3) (Lagrangian-action L sin 0 1 #:tolerance 1e-3)))

(test-case "the transformation comes before what generates it"
  (check-message (string-append "verify-generating-function: the transformation comes first, then "
                                "the generating function (F t x y)")
                 (verify-generating-function (lambda (t x y) (* x y)) (polar-canonical 'alpha)
                                             (up 't 'theta 'I))))
