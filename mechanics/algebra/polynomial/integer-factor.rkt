#lang racket/base
;; Factors of univariate polynomials over the integers, by Zassenhaus.
;;
;; A factor of f has coefficients below a bound (Mignotte's), and modulo a prime
;; of more than twice that bound it is a product of some of the modular factors
;; of f.  So products of few of them are tried by division: one that divides is a
;; factor, and irreducible, since products of fewer did not.
;;
;; A polynomial is the vector of its integer coefficients by ascending degree.

(require (only-in racket/vector vector-copy)
         "dense.rkt" "modular-factor.rkt" "modular.rkt" "recombination.rkt")

(provide integer-factors square-free?)

;; Higher degrees are not tried.
(define degree-limit 50)

;; The irreducible factors of f, primitive, square-free and of positive degree;
;; f alone where they were too much work.
(define (integer-factors f)
  (if (or (<= (vector-length f) 2) (> (vector-length f) degree-limit))
      (list f)
      (let-values ([(P factors) (fewest-modular-factors f)])
        (if (and P (<= (length factors) choices-limit))
            (combine f factors P)
            (list f)))))

(define (coefficient-bound f)
  (* 2 (abs (leading f)) (expt 2 (vector-length f))
     (for/sum ([c (in-vector f)]) (abs c))))

(define (leading f) (vector-ref f (- (vector-length f) 1)))

;; -> prime and factors, of the two primes above the bound the one with fewer
;; factors; #f and #f if none will do.
(define (fewest-modular-factors f)
  (let loop ([bound (coefficient-bound f)] [tries 2] [prime #f] [best #f])
    (define P (and (> tries 0) (not (and best (null? (cdr best)))) (prime-above bound)))
    (cond [(not P) (values prime best)]
          [else
           (define monic (dense-monic (dense f P) P))
           (define factors (and (dense-square-free? monic P) (modular-factors monic P)))
           (if (and factors (or (not best) (< (length factors) (length best))))
               (loop P (- tries 1) P factors)
               (loop P (if factors (- tries 1) tries) prime best))])))

(define (dense-square-free? f P)
  (dense-one? (dense-gcd f (dense-derivative f P) P)))

;; Has f no double factors?  If modulo some prime it has none, it has none.
(define (square-free? f)
  (define P (prime-above (* 2 (abs (leading f)))))
  (and P (dense-square-free? (dense f P) P)))

(define (combine f factors P)
  (define (split f chosen others)
    (define g (candidate f chosen P))
    (define rest (divide f g))
    (if rest (values g rest) (values #f #f)))
  (recombine f factors split))

(define (candidate f chosen P)
  (define product (dense-product (vector (modulo (leading f) P)) chosen P))
  (primitive (for/vector ([c (in-vector product)]) (symmetric-residue c P))))

(define (primitive f)
  (define content (apply gcd (vector->list f)))
  (define signed (if (negative? (leading f)) (- content) content))
  (for/vector #:length (vector-length f) ([c (in-vector f)]) (quotient c signed)))

;; The quotient over the integers, or #f.
(define (divide f g)
  (define m (- (vector-length g) 1))
  (define k (- (vector-length f) 1 m))
  (define rest (vector-copy f))
  (define quotient (make-vector (+ k 1) 0))
  (and (for/and ([i (in-range k -1 -1)])
         (define c (/ (vector-ref rest (+ i m)) (leading g)))
         (and (integer? c)
              (begin
                (vector-set! quotient i c)
                (for ([b (in-vector g)] [j (in-naturals i)])
                  (vector-set! rest j (- (vector-ref rest j) (* c b))))
                #t)))
       (for/and ([c (in-vector rest)]) (eqv? c 0))
       quotient))
