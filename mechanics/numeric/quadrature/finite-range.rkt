#lang racket/base
;; Definite integrals between numbers, of functions that may be infinite at some points.
;;
;; A function that is infinite at an end is integrated towards it: in the logarithm of the
;; distance (logarithmic-end.rkt), as a sum of powers (singular-end.rkt), as a wave that
;; becomes ever shorter (oscillating.rkt), as a power or logarithm that is barely integrable
;; (tail.rkt).  Where it is infinite between the ends, halving finds the point to within
;; rounding; there the interval is divided.

(require "gauss-kronrod.rkt" "logarithmic-end.rkt" "oscillating.rkt" "singular-end.rkt" "tail.rkt"
         "../../error/failure.rkt")

(provide (struct-out question) over-interval call-or-fail both)

;; Constants of all parts of an integral.  (search?) tells whether to look between the nodes of
;; panels; (peaks) are numbers near which to look, too.
(struct question (tolerance who search? peaks) #:authentic)

;; Two integrals and their bounds added.
(define (both one other)
  (define-values (value bound) (one))
  (define-values (value* bound*) (other))
  (values (+ value value*) (+ bound bound*)))

;; The values of (f), received by `return`, which may not be called.
(define (call-or-fail f return)
  (define-values (value bound)
    (with-handlers ([exn:fail:mechanics? (lambda (e) (values #f #f))])
      (f)))
  (when value (return value bound)))

(define most-panels-at-edge 200)
(define most-divisions 6)          ; of an interval, of its parts, of theirs ...

;; By halving panels; where they get narrow at an end, towards both ends; and if that
;; fails, or they get narrow inside, in two parts.  If none of this helps, fails as halving does.
;; place : point -> the user's variable there
(define (over-interval q f a b [place values] [divisions most-divisions])
  (define tolerance (question-tolerance q))
  (define who (question-who q))
  (define (plain edge divide)
    (quadrature/error f a b #:tolerance tolerance #:place place #:edge edge #:name who
                      #:search? (question-search? q) #:peaks (question-peaks q)
                      #:stuck (lambda (value bound x) (when x (divide x)))))
  (define (divided-at c return)
    (when (and (< a c b) (> divisions 0))
      (define (part a b) (over-interval q f a b place (- divisions 1)))
      (call-or-fail (lambda () (both (lambda () (part a c)) (lambda () (part c b)))) return)))
  (define (from-ends return)
    (define middle (+ a (* 0.5 (- b a))))
    (define-values (left left-bound) (to-end f middle a tolerance))
    (define-values (right right-bound)
      (if left (to-end f middle b tolerance) (values #f #f)))
    (when right (return (- right left) (+ left-bound right-bound)))
    (divided-at middle return)
    (quadrature/error f a b #:tolerance tolerance #:limit most-panels-at-edge
                      #:place place #:name who))
  (let/ec return
    (define (divide x) (divided-at (worst-near f x) return))
    (define (divide-at-singularity failure)
      (define c (exn:fail:mechanics:singular-where failure))
      (when (and (eq? place values) (real? c)) (divided-at c return))
      (raise failure))
    (with-handlers* ([exn:fail:mechanics:singular? divide-at-singularity])
      (let/ec at-edge
        (call-with-values (lambda () (plain (lambda () (at-edge)) divide)) return))
      (from-ends return))))

;; Of the numbers within rounding of x, the one where |f| is greatest.
(define (worst-near f x)
  (define unit (* 1e-16 (abs x)))
  (define (size y)
    (define z (abs (f y)))
    (if (< z +inf.0) z +inf.0))
  (for/fold ([best x] [most (size x)] #:result best) ([k (in-range -100 101)])
    (define y (+ x (* k unit)))
    (define here (size y))
    (if (> here most) (values y here) (values best most))))

;; ---------------------------------------------------------------------------
;; From a point to an end, in one of four ways; #f twice if none is

(define (to-end f from end tolerance)
  (let/ec return
    (for ([method (list integral-in-logarithm integral-towards shortening-waves barely-to-end)])
      (call-or-fail (lambda () (method f from end tolerance)) return))
    (values #f #f)))

;; With x = end + (from − end)/(1 + s), s from 0 to infinity
(define (shortening-waves f from end tolerance)
  (define all (- from end))
  (define (along s)
    (define d (+ 1.0 s))
    (/ (* -1.0 all (f (+ end (/ all d)))) d d))
  (oscillating-quadrature along 1.0 tolerance))

;; Powers near −1 and logarithms, in u = −log |x − end|.
(define (barely-to-end f from end tolerance)
  (define side (if (< from end) -1.0 1.0))
  (define near (min (abs (- from end)) (exp -1.0)))
  (define g (in-logarithm f end side -1.0))
  (define first-part (quadrature f from (+ end (* side near)) #:tolerance tolerance))
  (define-values (rest bound)
    (tail-integral g (- (log near)) (last-logarithm end) (abs first-part) tolerance))
  (if rest
      (values (- first-part (* side rest)) (+ bound (* tolerance (abs first-part))))
      (values #f #f)))
