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
;; residual is asked for.  If it is zero there, proofs are tried (proof.rkt); should
;; none be found, the test is undecided, with a bound of 0 at those points.

(require "expression.rkt" "simplify.rkt" "condition.rkt"
         "tape.rkt" "witness.rkt" "fingerprint.rkt" "proof.rkt" "bounds.rkt"
         "polynomial/fraction.rkt")

(provide zero-test
         zero-test? zero-test-status zero-test-residual zero-test-witness zero-test-value
         zero-test-bound zero-test-points zero-test-factor zero-test-core
         zero-test-condition zero-test-assumptions zero-test-left-unexpanded)

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
;; notes : datums, such as (>= R 0) for what the residual takes for granted and
;; (left-unexpanded e) for what would have grown too large
(struct form (residual factor core condition notes) #:authentic)

(define (zero-test-residual z) (form-residual (settled-form z)))
(define (zero-test-factor z) (form-factor (settled-form z)))
(define (zero-test-core z) (form-core (settled-form z)))
(define (zero-test-condition z) (form-condition (settled-form z)))
(define (zero-test-assumptions z) (filter assumption? (form-notes (settled-form z))))
(define (zero-test-left-unexpanded z)
  (for/list ([note (in-list (form-notes (settled-form z)))] #:unless (assumption? note))
    (cadr note)))

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
  (define-values (F f simple notes) (normal-form+simplified e))
  (cond [(fraction-zero? f) (form 0 1 0 #f notes)]
        [(and (readable? f) (andmap assumption? notes))
         (define-values (factor core condition) (factor-and-core F f))
         (form simple factor core condition notes)]
        [else (form simple 1 simple #f notes)]))

(define (assumption? note) (eq? (car note) '>=))

;; ---------------------------------------------------------------------------
;; The test

(define (zero-test e)
  (or (and (number? e) (inexact? e) (test-flonum e))
      (test-expression e (expression->tape e))))

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

;; More items than `middling` are judged by the fingerprint first.  No more than
;; `large` are expanded even if they do not vanish: a witness then names only what
;; the residual depends on.
(define middling 300)
(define large 2000)

(define (test-expression e t)
  (define n (tape-length t))
  (define print (if (> n middling) (tape-fingerprint t) 'unknown))
  (or (and (eq? print 'nonzero) (> n large) (refute-at-once e t))
      (and (eq? print 'zero) (prove-indirectly t))
      (test-canonically e t print)))

;; -> a refutation, or #f
(define (refute-at-once e t)
  (define-values (witness value bound points) (find-witness t t #f))
  (and witness
       (make-zero-test 'refuted witness value bound points (box e))))

;; -> a proof, or #f
(define (prove-indirectly t)
  (define assumptions (prove-vanishing t))
  (and assumptions
       (vanishing-test t (form 0 1 0 #f assumptions))))

;; Nothing is proved of flonums.
(define (vanishing-test t f)
  (make-zero-test (if (contains-flonum? t) 'undecided 'proved) #f 0 0 0 (box f)))

;; print : what the fingerprint said, if it was asked
(define (test-canonically e t print)
  (define f (make-form e))
  (cond [(eqv? (form-residual f) 0) (vanishing-test t f)]
        [(eq? print 'zero) (make-zero-test 'undecided #f 0 0 fingerprint-points (box f))]
        [else (test-by-points e t f)]))

(define (test-by-points e t f)
  (define assumptions? (ormap assumption? (form-notes f)))
  (define-values (witness value bound points)
    (find-witness t (expression->tape (form-residual f)) assumptions?))
  (cond [witness (make-zero-test 'refuted witness value bound points (box f))]
        [(and (eq? 'zero (tape-fingerprint t)) (prove-indirectly t))]
        [else (make-zero-test 'undecided #f value bound points (box f))]))

;; ---------------------------------------------------------------------------

;; Numbers under functions count: they are no better known than others.
(define (contains-flonum? t)
  (for/or ([e (in-vector (tape-items t))])
    (and (number? e) (not (exact? e)))))
