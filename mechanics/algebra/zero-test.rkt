#lang racket/base
;; Is an expression zero?  Proved, refuted, or undecided.
;;
;; *Proved* rests on the canonical form being 0, with exact input.  *Refuted*
;; rests on a point where the value is farther from zero than rounding can
;; explain: small integers for the symbols and for the literal functions
;; applied, which a person can put in by hand.  Otherwise the test is
;; *undecided* and says at how many points it found zero, and to what bound.
;; The points are always the same.
;;
;; A large graph is first judged modulo primes (fingerprint.rkt): if it is not
;; zero, a point is found for it as it stands, and it is expanded only when its
;; residual is asked for.  If it is zero there, a proof is tried; should it grow
;; past the bounds, the test is undecided, with a bound of 0 at those points.

(require "expression.rkt" "simplify.rkt" "condition.rkt" "present.rkt"
         "tape.rkt" "witness.rkt" "fingerprint.rkt" "polynomial/fraction.rkt")

(provide zero-test
         zero-test? zero-test-status zero-test-residual zero-test-witness zero-test-value
         zero-test-bound zero-test-points zero-test-factor zero-test-core
         zero-test-condition zero-test-assumptions)

;; status : 'proved, 'refuted or 'undecided
;; witness : #f or ((expression . number) ...)  value : the residual's there
;; bound : the greatest rounding error at the points tried without a decision; 0 if
;; those were points modulo primes
;; points : how many those were
;; form : box of a form, or of the expression to make it from
(struct zero-test (status witness value bound points form)
  #:name zero-test-result
  #:constructor-name make-zero-test)

;; residual : expression, simplified             factor, core : residual = factor · core
;; condition : #f or an equation, as a datum, for which core = 0
;; assumptions : datums such as (>= R 0) that the residual takes for granted
(struct form (residual factor core condition assumptions) #:authentic)

(define (zero-test-residual z) (form-residual (settled-form z)))
(define (zero-test-factor z) (form-factor (settled-form z)))
(define (zero-test-core z) (form-core (settled-form z)))
(define (zero-test-condition z) (form-condition (settled-form z)))
(define (zero-test-assumptions z) (form-assumptions (settled-form z)))

(define (settled-form z)
  (define content (unbox (zero-test-form z)))
  (cond [(form? content) content]
        [else
         (define made (make-form content))
         (set-box! (zero-test-form z) made)
         made]))

(define (make-form e)
  (if (and (number? e) (not (rational? (magnitude e))))
      (form e 1 e #f '())
      (make-form-of-finite e)))

(define (make-form-of-finite e)
  (define-values (F f assumptions) (normal-form e))
  (cond [(fraction-zero? f) (form 0 1 0 #f assumptions)]
        [else
         (define-values (factor core condition) (factor-and-core F f))
         (form (present F f) factor core condition assumptions)]))

;; ---------------------------------------------------------------------------
;; The test

(define (zero-test e)
  (cond [(and (number? e) (inexact? e) (test-flonum e))]
        [(large? e) (test-large e (expression->tape e))]
        [else (test-canonically e (expression->tape e) search-canonically)]))

;; A flonum that stands alone does not tell what it is the difference of; one
;; this small may be what rounding left of numbers about 1.  Infinity is not
;; zero, and of what is not a number nothing can be said.
;; -> a verdict, or #f for an ordinary flonum
(define (test-flonum x)
  (define size (magnitude x))
  (cond [(< size 1e-14) (make-zero-test 'undecided #f x size 1 (box x))]
        [(eqv? size +inf.0) (make-zero-test 'refuted '() x 0 0 (box x))]
        [(rational? size) #f]
        [else (make-zero-test 'undecided #f x 0 0 (box x))]))

;; search : tape form -> witness value bound points, should the form not be 0
(define (test-canonically e t search)
  (define f (make-form e))
  (define zero? (eqv? (form-residual f) 0))
  (define-values (witness value bound points)
    (if zero? (values #f 0 0 0) (search t f)))
  (make-zero-test (cond [(and zero? (not (contains-flonum? t))) 'proved]
                        [witness 'refuted]
                        [else 'undecided])
                  witness value bound points (box f)))

(define (search-canonically t f)
  (find-witness t (expression->tape (form-residual f)) (pair? (form-assumptions f))))

(define (test-large e t)
  (define print (tape-fingerprint t))
  (or (and (eq? print 'nonzero) (refute-at-once e t))
      (test-canonically e t
                        (if (eq? print 'zero)
                            (lambda (t f) (values #f 0 0 fingerprint-points))
                            search-canonically))))

;; -> a refutation, or #f
(define (refute-at-once e t)
  (define-values (witness value bound points) (find-witness t t #f))
  (and witness
       (make-zero-test 'refuted witness value bound points (box e))))

;; ---------------------------------------------------------------------------

;; Numbers under functions count: they are no better known than others.
(define (contains-flonum? t)
  (for/or ([e (in-vector (tape-items t))])
    (and (number? e) (not (exact? e)))))

;; Has the graph more nodes than this?
(define large 2000)

(define (large? e)
  (define seen (make-hasheq))
  (let walk ([e e])
    (cond [(or (not (node? e)) (hash-ref seen e #f)) #f]
          [(= (hash-count seen) large) #t]
          [else
           (hash-set! seen e #t)
           (ormap walk (node-args e))])))
