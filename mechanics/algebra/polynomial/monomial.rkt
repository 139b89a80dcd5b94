#lang racket/base
;; Packed monomials: words of bit fields, compared and added as numbers.
;;
;; A monomial is a fixnum, or a pair of a fixnum and the rest of the monomial:
;; one word, or a chain of words when the fields do not fit one.  (A bignum
;; would do instead of a chain, but measured twice as slow in products and
;; sums.)  Words are natural numbers below 2^60, the first counts most; all
;; monomials of a ring have equally many.  The meaning of the fields is the ring's
;; affair (ring.rkt); here it only matters that sums do not carry out of a
;; word, that the fields of a monomial have a spare bit, 0, and that the first
;; word is 0 for the monomial 1 alone.

(require racket/fixnum)

(provide monomial+ monomial- monomial-power
         monomial-compare monomial>? monomial=? monomial-one?
         monomial-divides? monomial-join
         monomial-head monomial-mask monomial-hash)

;; ---------------------------------------------------------------------------
;; Word by word

;; The one-word case is written out in place: products and sums of polynomials
;; spend their time here.
(define-syntax-rule (define-wordwise name word-by-word operate)
  (begin
    (define (word-by-word a b)
      (if (fixnum? a)
          (operate a b)
          (cons (operate (car a) (car b)) (word-by-word (cdr a) (cdr b)))))
    (define-syntax-rule (name x y)
      (let ([a x] [b y])
        (if (fixnum? a) (operate a b) (word-by-word a b))))))

(define-wordwise monomial+ add-words fx+)
(define-wordwise monomial- subtract-words fx-)
;; Fields of b where the fields of the mask a are all ones, else 0.
(define-wordwise monomial-mask mask-words fxand)
;; A monomial in which every variable of a or b occurs.
(define-wordwise monomial-join join-words fxior)

;; m^k; no check that it fits.
(define (monomial-power m k)
  (cond [(fixnum? m) (fx* m k)]
        [else (cons (fx* (car m) k) (monomial-power (cdr m) k))]))

;; ---------------------------------------------------------------------------
;; Comparison

;; Negative, zero or positive, as a is less than, equal to or greater than b.
(define-syntax-rule (monomial-compare x y)
  (let ([a x] [b y])
    (if (fixnum? a) (fx- a b) (compare-words a b))))

(define (compare-words a b)
  (if (fixnum? a)
      (fx- a b)
      (let ([d (fx- (car a) (car b))])
        (if (eq? d 0) (compare-words (cdr a) (cdr b)) d))))

(define (monomial>? a b) (fx> (monomial-compare a b) 0))
(define (monomial=? a b) (eq? 0 (monomial-compare a b)))

(define (monomial-one? m) (eq? 0 (monomial-head m)))

;; The first word.
(define-syntax-rule (monomial-head x)
  (let ([m x]) (if (fixnum? m) m (car m))))

;; Does b - a borrow from no field?  Then the spare bits, the guards, are 0 in
;; every word.
(define (monomial-divides? guards a b)
  (if (fixnum? a)
      (eq? 0 (fxand (fx- b a) guards))
      (and (eq? 0 (fxand (fx- (car b) (car a)) (car guards)))
           (monomial-divides? (cdr guards) (cdr a) (cdr b)))))

(define (monomial-hash m)
  (if (fixnum? m)
      m
      (fxand (fx+ (fx* 31 (fxand (monomial-hash (cdr m)) #xFFFFFFFFFFF))
                  (fxxor (fxrshift (car m) 23) (fxand (car m) #xFFFFFFFFFFF)))
             #xFFFFFFFFFFFF)))
