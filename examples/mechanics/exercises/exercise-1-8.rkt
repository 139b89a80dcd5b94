#lang mechanics
;; Exercise 1.8 (SICM 1.5.1): variations computed
;; Checked: a program for the variation of a function of paths
;; How: against delta, for an arbitrary function of local tuples

;; Write a program for the variation: the rate at which f[q + ε η] grows at ε = 0.

(define (((attempt eta) f) q)
  (define (moved epsilon) (f (+ q (* epsilon eta))))
  ((D moved) 0))

;; One that moves what f gives instead of what it is given.
(define (((slip eta) f) q)
  (define (moved epsilon) (+ (f q) (* epsilon eta)))
  ((D moved) 0))

(define F (literal-function 'F (-> (UP Real Real Real) Real)))
(define (f q) (compose F (Gamma q)))
(define eta (literal-function 'eta))
(define (at-t vary) ((((vary eta) f) (literal-function 'q)) 't))

(define right (verify-equal (at-t attempt) (at-t delta)))
right

;; The slip does not look at f at all.
(at-t slip)
(at-t delta)

(module+ test
  (require rackunit)
  (test-case "the variation is a derivative along eta"
    (check-pred proved? right))
  (test-case "the slip returns eta, whatever f is"
    (check-equal? (expression (at-t slip)) '(eta t))
    (check-pred refuted? (verify-equal (at-t slip) (at-t delta)))))
