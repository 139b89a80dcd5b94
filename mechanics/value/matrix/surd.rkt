#lang racket/base
;; Numbers p + q √D with rational p, q and D, to all digits.
;;
;; Where p and q √D have unlike signs, decimals of them may cancel to nothing, as those of the root
;; 10⁻⁹ of x² − 10⁹x + 1 do.  Then the number is (p² − q² D)/(p − q √D), whose numerator is exact,
;; and whose denominator is a sum of like signs.

(provide (struct-out surd) quadratic-roots surd->number)

;; D is no square of a rational number; negative for a complex number.
(struct surd (p q D) #:transparent)

;; Of x² − t x + d, that with + √ first: rational numbers or surds
(define (quadratic-roots t d)
  (define discriminant (- (* t t) (* 4 d)))
  (define-values (root exact?) (long-root discriminant))
  (for/list ([sign '(1/2 -1/2)])
    (if exact? (+ (/ t 2) (* sign root)) (surd (/ t 2) sign discriminant))))

;; An exact number beside which the surd differs by less than 2⁻¹⁰⁰ of its size
(define (surd->number s)
  (define-values (p q D) (values (surd-p s) (surd-q s) (surd-D s)))
  (define-values (root _) (long-root D))
  (define-values (sum other) (values (+ p (* q root)) (- p (* q root))))
  (if (or (< D 0) (>= (abs sum) (abs other)))
      sum
      (/ (- (* p p) (* q q D)) other)))

;; -> √D to at least 128 bits, and whether it is that exactly
(define (long-root D)
  (define-values (n d) (values (* (numerator (abs D)) (denominator D)) (denominator D)))
  (define more (max 0 (- 128 (quotient (integer-length n) 2))))
  (define-values (root rest) (integer-sqrt/remainder (arithmetic-shift n (* 2 more))))
  (values (* (if (< D 0) +i 1) (/ root (* d (expt 2 more)))) (= rest 0)))
