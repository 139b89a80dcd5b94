#lang racket/base
;; Roots of generic functions.

(require racket/list
         rackunit
         mechanics/generic/arithmetic mechanics/generic/elementary mechanics/generic/structure
         mechanics/numeric/failure
         (only-in mechanics/value/structure ref)
         mechanics/calculus/root)

(test-case "between two numbers"
  (check-= (find-root (g:- g:cos values) 0 1) 0.7390851332151607 1e-12)
  (check-= (find-root (g:- g:cos values) 0 1 #:tolerance 1e-15) 0.7390851332151607 1e-15)
  (check-= (find-root (g:- g:square 2) 0 2) (sqrt 2.0) 1e-12)
  (check-exn #rx"the same sign" (lambda () (find-root g:cos 0 1))))

(test-case "near a number"
  (check-= (find-root (g:- g:cos values) 1) 0.7390851332151607 1e-15)
  (check-equal? (find-root (g:- g:square 9/4) 1) 1.5))

;; Two equations for a number and a pair, given in another shape.
(define (f s)
  (define x (ref s 0))
  (define y (ref s 1 0))
  (define z (ref s 1 1))
  (down (up (g:- (g:* x y z) 6) (g:- (g:+ x y z) 6)) (g:- (g:* x y) 2)))

(test-case "near a structure of any shape, by exact derivatives"
  (define root (find-root f (up 0.9 (up 2.2 3.3))))
  (check-= (ref root 0) 1 1e-10)
  (check-= (ref root 1 0) 2 1e-10)
  (check-= (ref root 1 1) 3 1e-10))

(test-case "a function that cannot be differentiated, by differences"
  (define (f x) (- (exp (if (flonum? x) x (error "a number, please"))) 2.0))
  (check-= (find-root f 1) (log 2.0) 1e-12))

(test-case "arguments are observed in their shape, and failures carry it"
  (define seen '())
  (find-root f (up 1 (up 2 3.5)) #:observe (lambda (x y) (set! seen (cons x seen))))
  (check-equal? (last seen) (up 1.0 (up 2.0 3.5)))
  (define failure
    (with-handlers ([exn:fail:mechanics:not-convergent? values])
      (find-root (lambda (x) (g:+ 1 (g:square x))) 1/3)))
  (check-true (real? (exn:fail:mechanics:not-convergent-value failure)))
  (check-equal? (exn:fail:mechanics:singular-where
                 (with-handlers ([exn:fail:mechanics:singular? values])
                   (find-root (lambda (s) (up (ref s 0) (g:* 2 (ref s 0)))) (up 1 1))))
                (up 1.0 1.0)))

(test-case "what is no question is refused"
  (check-exn #rx"^find-root: contract violation\n  expected: a function of one variable"
             (lambda () (find-root 3 1)))
  (check-exn #rx"^find-root: expected a real number; given the symbol a"
             (lambda () (find-root g:square 'a)))
  (check-exn #rx"^find-root: expected a real number; given .*a"
             (lambda () (find-root (g:* 'a values) 1)))
  (check-exn #rx"^find-root: the function must give as many numbers as it takes\n  given: 1\n  expected: 2"
             (lambda () (find-root (lambda (s) (ref s 0)) (up 1 1))))
  (check-exn #rx"positive tolerance" (lambda () (find-root g:square 1 #:tolerance -1))))
