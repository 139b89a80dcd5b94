#lang racket/base
;; Prime fields whose products fit a fixnum, and dense univariate polynomials
;; over them.
;;
;; Primes lie below 2^30, so a product of two residues plus a third is below
;; 2^60 and never leaves the fixnums.  A univariate polynomial is a fxvector of
;; coefficients by ascending degree together with its degree, -1 for zero.

(require racket/fixnum
         "../../error/complain.rkt")

(provide
 ;; fields
 nth-prime next-prime residue symmetric-residue
 mod* mod+ mod- mod-expt mod-inverse
 sample-residue
 ;; univariate polynomials
 univariate-degree univariate-gcd! univariate-make-leading!)

;; ---------------------------------------------------------------------------
;; Primes

(define first-prime 1073741789)             ; the greatest below 2^30

;; The greatest prime below an odd number; found by trial division, some 80 µs.
(define (next-prime n)
  (let ([candidate (- n 2)])
    (if (odd-prime? candidate) candidate (next-prime candidate))))

(define (nth-prime n)
  (for/fold ([P first-prime]) ([_ (in-range n)]) (next-prime P)))

(define (odd-prime? n)
  (let loop ([d 3])
    (cond [(> (* d d) n) #t]
          [(eq? 0 (fxremainder n d)) #f]
          [else (loop (+ d 2))])))

;; ---------------------------------------------------------------------------
;; Residues, always between 0 and P - 1

(define-syntax-rule (mod* a b P) (fxremainder (fx* a b) P))

(define-syntax-rule (mod+ a b P)
  (let ([s (fx+ a b)]) (if (fx>= s P) (fx- s P) s)))

(define-syntax-rule (mod- a b P)
  (let ([d (fx- a b)]) (if (fx< d 0) (fx+ d P) d)))

;; The residue of a rational number whose denominator P does not divide.
(define (residue c P)
  (if (integer? c)
      (modulo c P)
      (mod* (modulo (numerator c) P)
            (mod-inverse (modulo (denominator c) P) P)
            P)))

;; The integer of least magnitude in the class of c; the modulus may be of any size.
(define (symmetric-residue c modulus)
  (define r (modulo c modulus))
  (if (> (* 2 r) modulus) (- r modulus) r))

(define (mod-expt base k P)
  (cond [(eq? k 1) base]
        [(eq? k 0) 1]
        [else
         (define root (mod-expt base (fxrshift k 1) P))
         (define square (mod* root root P))
         (if (eq? 1 (fxand k 1)) (mod* square base P) square)]))

;; The inverse of a nonzero residue, by Euclid's algorithm.
(define (mod-inverse a P)
  (let loop ([r P] [s a] [u 0] [v 1])
    (cond [(eq? s 1) (if (fx< v 0) (fx+ v P) v)]
          [(eq? s 0)
           (complain-showing 'mod-inverse "the residue has no inverse" "residue" a "modulus" P)]
          [else
           (define q (fxquotient r s))
           (loop s (fx- r (fx* q s)) v (fx- u (fx* q v)))])))

;; A sequence of residues that satisfy no relation a polynomial is likely to
;; state: where a proof needs a random point, any such point does, and a fixed
;; one keeps every result reproducible.
(define (sample-residue seed i P)
  (define (mix x) (fxremainder (fx+ (fx* x x) 362436069) P))
  (let ([x (fxremainder (+ (* 69069 (+ i 1)) (* 40503017 (+ seed 1))) P)])
    (fxmax 2 (mix (mix (mix x))))))

;; ---------------------------------------------------------------------------
;; Univariate polynomials

;; The degree of the polynomial at the places 0 ... top.
(define (univariate-degree v top)
  (let loop ([i top])
    (if (and (fx>= i 0) (eq? 0 (fxvector-ref v i))) (loop (fx- i 1)) i)))

;; -> g degree.  Euclid's algorithm; destroys both operands and returns one of
;; them.  A step replaces a by lc(b) a - lc(a) x^k b: two products instead of
;; one, but no inverses.
(define (univariate-gcd! a a-degree b b-degree P)
  (cond [(fx< a-degree b-degree) (univariate-gcd! b b-degree a a-degree P)]
        [(fx< b-degree 0) (values a a-degree)]
        [(eq? b-degree 0) (values b 0)]
        [else
         (define r (reduce! a a-degree b b-degree P))
         (univariate-gcd! b b-degree a r P)]))

;; a becomes a remainder by b; returns its degree.
(define (reduce! a a-degree b b-degree P)
  (define lead (fxvector-ref b b-degree))
  (let loop ([n a-degree])
    (cond [(fx< n b-degree) n]
          [else
           (define c (fx- P (fxvector-ref a n)))
           (define k (fx- n b-degree))
           (let scale ([i 0])
             (when (fx< i k)
               (fxvector-set! a i (mod* lead (fxvector-ref a i) P))
               (scale (fx+ i 1))))
           (let combine ([i k])
             (when (fx< i n)
               (fxvector-set! a i
                              (fxremainder
                               (fx+ (mod* lead (fxvector-ref a i) P)
                                    (fx* c (fxvector-ref b (fx- i k))))
                               P))
               (combine (fx+ i 1))))
           (loop (univariate-degree a (fx- n 1)))])))

;; Scale a polynomial so that its leading coefficient is `lead`.
(define (univariate-make-leading! v degree lead P)
  (define factor (mod* lead (mod-inverse (fxvector-ref v degree) P) P))
  (for ([i (in-range (fx+ degree 1))])
    (fxvector-set! v i (mod* factor (fxvector-ref v i) P))))
