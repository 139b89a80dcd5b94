#lang racket/base
;; Kinds of results of find-minimum.

(require mechanics/error/failure
         mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/search/minimize
         mechanics/search/minimum
         mechanics/value/structure
         "../support/checks.rkt" "../support/notes.rkt")

(define (kind f . where) (minimum-kind (apply find-minimum f where)))
(define (place f . where) (minimum-argument (apply find-minimum f where)))

;; As a measurement: it takes flonums alone.
(define ((measured f) x) (f (if (flonum? x) x (raise-argument-error 'f "flonum?" x))))

(define (quartic x) (g:expt (g:- x 1) 4))
(define (saddle v)
  (g:+ (g:square (ref v 0)) (g:* -1 (g:square (ref v 1))) (g:expt (ref v 1) 4)))
(define (monkey-saddle v)
  (g:- (g:expt (ref v 0) 3) (g:* 3 (ref v 0) (g:square (ref v 1)))))
(define (well x) (g:- (g:exp (g:- (g:square (g:- x 10))))))

(test-case "in one variable: each kind"
  (for ([f (list (lambda (x) (g:square (g:- x 1))) quartic (lambda (x) 3)
                 (lambda (x) (g:abs (g:- x 1))) values
                 (measured (lambda (x) (* x x))) (measured abs))]
        [expected '(minimum degenerate flat kink end minimum kink)])
    (check-equal? (kind f -1 2.5) expected)))

(test-case "no minimum: a pole on the right of a slope, found from its side"
  (define (falling x) (if (> x 0.9985) (/ -1.0 (- x 0.9985)) (- 1.9985 x)))
  (check-exn #rx"the function falls without bound, at a pole" (lambda () (kind falling 0 1))))

(test-case "no minimum: a pole between ends that are equally far from 0"
  (check-exn #rx"the function falls without bound, at a pole"
             (lambda () (kind (lambda (x) (g:log (g:abs (g:- x 0.3001)))) -1 1))))

(test-case "an end where there is no value is no minimum"
  (define m (find-minimum (lambda (x) (g:+ 1 (g:/ x (g:sin x)))) 0 1))
  (check-= (minimum-value m) 2 1e-9))

(test-case "where there is no value a function is not lower"
  (define m (find-minimum (lambda (x) (g:- 6 (g:sqrt (g:- 1 (g:expt x 4))))) 0.3))
  (check-eq? (minimum-kind m) 'degenerate)
  (check-= (minimum-value m) 5 1e-12))

(test-case "what is lower far outside of an interval does not make a minimum in it flat"
  (define (f x) (g:- (g:expt x 4) (g:/ (g:expt x 6) 3.6e-7)))
  (check-equal? (kind f -5e-4 5e-4) 'degenerate))

(test-case "a narrow well is found to rounding by a search of a wide tolerance"
  (define m (find-minimum (lambda (x) (well (g:+ 10 (g:/ (g:- x 0.3) 0.1)))) -1 1 #:tolerance 0.15))
  (check-eq? (minimum-kind m) 'minimum)
  (check-= (minimum-argument m) 0.3 1e-12))

(test-case "samples are doubled until shallow wells of a hundredth of the interval are seen"
  (for ([center '(0.31 0.49 0.55 0.7 0.85)])
    (define (f x) (g:+ (g:square x) (g:* 0.05 (well (g:+ 10 (g:/ (g:- x center) 0.008))))))
    (check-equal? (length (minima f -1 1)) 2))
  (define runs 0)
  (minima (lambda (x) (set! runs (+ runs 1)) (g:square x)) -1 1)
  (check-true (< (+ 64 128 256) runs 550)))

(test-case "near a start: each kind"
  (for ([f (list g:cos quartic (lambda (x) 3) (lambda (x) (g:abs (g:- x 1)))
                 (measured (lambda (x) (* x x))) (measured abs))]
        [expected '(minimum degenerate flat kink minimum kink)])
    (check-equal? (kind f 0.5) expected))
  (define (valley v) (g:square (ref v 0)))
  (check-equal? (kind valley (up 1 5)) 'flat)
  (check-equal? (minimum-kind (find-minimum valley (up 1 1) #:method 'nelder-mead)) 'flat))

(test-case "the size of the gradient, the least curvature, the evaluations"
  (define m (find-minimum (lambda (v) (g:+ (g:square (ref v 0)) (g:* 3 (g:square (ref v 1)))))
                          (up 1 2)))
  (check-= (minimum-gradient m) 0 1e-12)
  (check-= (minimum-curvature m) 2 1e-12)
  (check-true (< 2 (minimum-evaluations m) 12))
  (define end (find-minimum g:exp 0 1))
  (check-equal? (minimum-argument end) 0.0)
  (check-equal? (minimum-gradient end) 1.0)
  (check-equal? (minimum-gradient (find-minimum (lambda (x) (g:* -3 x)) 0 1)) 3.0)
  (check-false (minimum-curvature end))
  (check-false (minimum-gradient (find-minimum g:abs -1 2))))

(test-case "it prints as what it is"
  (check-equal? (format "~a" (find-minimum (lambda (x) (g:square (g:- x 1))) 0))
                (string-append "minimum at 1.0, where the value is 0.0\n"
                               "  size of the gradient: 0.0\n  least curvature: 2.0\n"
                               "  evaluations: 3"))
  (for ([f (list quartic (lambda (x) (g:abs (g:- x 1))) g:exp (lambda (x) 3))]
        [title '("degenerate minimum at" "minimum at a kink" "least at the end" "flat, and")])
    (check-regexp-match (string-append "^" title) (format "~a" (find-minimum f 0 3)))))

(test-case "a smooth minimum is right to rounding"
  (check-= (place g:cos 2 4) (acos -1.0) 1e-15)
  (check-= (place g:cos 0.1) (acos -1.0) 1e-15))

;; Three of Newton's steps on from x = 1e-3 the curvature of x⁴ + c x² is a tenth for c = 0.5e-6,
;; and three tenths for c = 1.4e-6.
(test-case "a search goes on where most of the curvature is gone within Newton's reach"
  (define (more-than-one-evaluation? c)
    (define (f x) (g:+ (g:expt x 4) (g:* c (g:square x))))
    (> (minimum-evaluations (find-minimum f 1e-3)) 1))
  (check-true (more-than-one-evaluation? 0.5e-6))
  (check-false (more-than-one-evaluation? 1.4e-6)))

(test-case "a saddle is left"
  (for ([start (list (up 1 0) (up 0 0))])
    (define m (find-minimum saddle start))
    (check-eq? (minimum-kind m) 'minimum)
    (check-= (abs (ref (minimum-argument m) 1)) (sqrt 1/2) 1e-12)
    (check-= (minimum-value m) -1/4 1e-15))
  ;; where all second derivatives vanish, and the function falls without end
  (for ([f (list monkey-saddle (lambda (v) (g:expt (ref v 0) 3)))])
    (check-exn exn:fail:mechanics:not-convergent? (lambda () (find-minimum f (up 0 0))))
    (check-exn exn:fail:mechanics:not-convergent?
               (lambda () (multidimensional-minimize f (up 0 0))))))

(test-case "a saddle at which nothing lower is seen is told, with its curvature"
  (define failure
    (with-handlers ([exn:fail:mechanics:not-convergent? values])
      (multidimensional-minimize (lambda (x) (g:- 1 (g:* 1e-9 x x))) 0 #:method 'quasi-newton)))
  (check-equal? (exn-message failure)
                (string-append "multidimensional-minimize: no minimum found: the search ended at a "
                               "saddle\n  at: 0.0\n  size of the gradient there: 0.0\n"
                               "  least curvature there: -2e-9"))
  (check-equal? (exn:fail:mechanics:not-convergent-value failure) 0.0)
  (check-false (exn:fail:mechanics:not-convergent-error-estimate failure)))

(test-case "by its values alone a function is not differentiated"
  (define (f v)
    (check-pred flonum? (ref v 0))
    (saddle v))
  (define m (find-minimum f (up 1.0 0.1) #:method 'nelder-mead))
  (check-eq? (minimum-kind m) 'minimum)
  (check-false (minimum-gradient m))
  (check-= (minimum-curvature m) 2 1e-2))

(test-case "a slope that is hardly any is followed"
  ;; at 0 the gradient is 7e-43
  (check-= (place well 0) 10 1e-12)
  (check-= (multidimensional-minimize well 0) 10 1e-7)
  (define v (place (lambda (v) (g:* (well (ref v 0)) (g:exp (g:- (g:square (ref v 1)))))) (up 0 1)))
  (check-= (ref v 0) 10 1e-9)
  (check-= (ref v 1) 0 1e-9))

(test-case "a plateau is left where samples are lower"
  (define (narrow x) (g:- (g:exp (g:* -50 (g:square (g:- x 9))))))
  (check-= (place narrow 0 100) 9 1e-9)
  (check-= (car (minimize narrow 0 100)) 9 1e-7)
  ;; a step down elsewhere, and level on both sides
  (define (step x) (if (> x 4) -1.0 0.0))
  (check-true (> (place step 0 5) 4)))

(test-case "the ends, as they are given"
  (check-equal? (car (minimize g:exp 1 2)) 1.0)
  (check-equal? (car (minimize (g:* -1 g:exp) 1 2)) 2.0)
  (check-equal? (car (minimize g:exp 2 1)) 1.0)
  ;; at an end without a value the nearest point is taken
  (define (minus-sinc x) (g:- (g:/ (g:sin x) x)))
  (check-= (car (minimize minus-sinc 0 1)) 0 1e-6)
  ;; where a function falls without bound there is none
  (check-exn #rx"minimize: no minimum found: the function falls without bound, at a pole"
             (lambda () (minimize g:log 0 1))))

;; ---------------------------------------------------------------------------
;; All of them

(define (places f low high) (map minimum-argument (minima f low high)))

(define (check-places found expected)
  (check-equal? (length found) (length expected) (format "~a" found))
  (for ([x found] [y expected]) (check-= x y 1e-7)))

(test-case "all minima, from left to right, ends among them"
  (define pi (acos -1.0))
  (check-places (places g:cos 0 20) (list pi (* 3 pi) (* 5 pi) 20))
  (check-places (places (lambda (x) (g:square (g:- (g:square x) 1))) -2 2) '(-1 1))
  (check-places (places g:abs -1 2) '(0))
  (check-equal? (length (places (lambda (x) (g:sin (g:* 100 x))) 0 (* 2 pi))) 101)
  (check-equal? (map minimum-kind (minima (lambda (x) (g:square x)) -1 2)) '(minimum)))

(test-case "a note counts them, and says how close the samples were"
  (for ([f (list g:square g:cos)] [count '("one minimum" "8 minima")] [high '(2 40)])
    (define pattern "^; minima: ~a found; the samples it went by are [0-9.]+ apart")
    (check-regexp-match (format pattern count) (told (minima f -1 high)))))

(test-case "no grid hides what is in step with it"
  (define pi (acos -1.0))
  (check-equal? (length (places (lambda (x) (g:cos (g:* 128 pi x))) 0.001 0.999)) 64))

;; One so narrow that neither 64 nor 128 samples meet it: that these agree is not enough.
(test-case "samples are doubled until twice in a row nothing new comes"
  (define (f x) (g:- (g:square (g:- x 1/2)) (g:exp (g:negate (g:square (g:/ (g:- x c) 0.0012))))))
  (define c 0.3466)
  (define found (places f 0 1))
  (check-equal? (length found) 2)
  (check-= (car found) c 1e-3))

(test-case "a plateau is one of them, once"
  (define (basin x) (if (< 1 x 2) 0.0 1.0))
  (check-equal? (length (places basin 0 3)) 1)
  (check-equal? (length (places (lambda (x) 1.0) 0 3)) 1))

;; ---------------------------------------------------------------------------
;; Mistakes

(test-case "what is no question is refused"
  (check-exn #rx"^minima: takes 3 arguments; it was given 2\n" (lambda () (minima g:cos 1)))
  (check-exn #rx"^find-minimum: expected a function of one variable"
             (lambda () (find-minimum 3 1)))
  (check-exn #rx"^find-minimum: expected a positive tolerance"
             (lambda () (find-minimum g:cos 1 #:tolerance 0)))
  (check-exn #rx"^find-minimum: expected 'quasi-newton or 'nelder-mead"
             (lambda () (find-minimum g:cos 1 #:method 'newton)))
  (check-exn #rx"^find-minimum: expected a real number\n  given: \"no\", a string"
             (lambda () (find-minimum (lambda (x) "no") 1 2)))
  (check-exn #rx"^find-minimum: expected real numbers to start from.*the symbol x"
             (lambda () (find-minimum g:cos 'x)))
  (check-exn #rx"^minima: expected a finite real number as end"
             (lambda () (minima g:cos 0 +inf.0)))
  (check-exn #rx"^minimum-kind: expected a minimum, such as find-minimum gives\n  given: "
             (lambda () (minimum-kind 3))))

(test-case "an error of the function's own, beside what is asked about, is the user's to see"
  (define (f x) (if (and (real? x) (> x 1.2)) (error 'f "no value beyond") (g:square x)))
  (check-exn #rx"^f: no value beyond$" (lambda () (find-minimum f 0 2)))
  (check-exn #rx"^f: no value beyond$" (lambda () (minima f -1 2))))
