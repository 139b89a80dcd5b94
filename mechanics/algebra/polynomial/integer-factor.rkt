#lang racket/base
;; Factors of univariate polynomials over the integers, by Zassenhaus.
;;
;; A factor of f has coefficients below a bound (Mignotte's), and modulo a prime
;; of more than twice that bound it is a product of some of the modular factors
;; of f.  So products of few of them are tried by division: what divides is a
;; factor, and irreducible, since products of fewer did not.
;;
;; A polynomial is the vector of its integer coefficients by ascending degree.

(require "dense.rkt" "modular-factor.rkt")

(provide integer-factors square-free? subsets choices-limit)

;; More modular factors than these are not combined, higher degrees not tried.
(define choices-limit 14)
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

;; Products of k modular factors are tried for k = 1, 2, ... .
(define (combine f factors P)
  (let loop ([f f] [factors factors] [k 1])
    (cond [(> (* 2 k) (length factors)) (if (> (vector-length f) 1) (list f) '())]
          [else
           (define-values (g rest used) (find-factor f factors k P))
           (if g
               (cons g (loop rest (remove-all used factors) k))
               (loop f factors (+ k 1)))])))

;; -> a factor of f, the quotient, and the modular factors of which it is made; or
;; #f thrice.
(define (find-factor f factors k P)
  (let try ([choices (subsets factors k)])
    (cond [(null? choices) (values #f #f #f)]
          [else
           (define g (candidate f (car choices) P))
           (define rest (divide f g))
           (if rest (values g rest (car choices)) (try (cdr choices)))])))

(define (candidate f chosen P)
  (define product
    (for/fold ([g (vector (modulo (leading f) P))]) ([h (in-list chosen)]) (dense* g h P)))
  (primitive (for/vector ([c (in-vector product)]) (symmetric-residue c P))))

(define (primitive f)
  (define content (for/fold ([g 0]) ([c (in-vector f)]) (gcd g c)))
  (define signed (if (negative? (leading f)) (- content) content))
  (for/vector #:length (vector-length f) ([c (in-vector f)]) (quotient c signed)))

;; The quotient over the integers, or #f.
(define (divide f g)
  (define m (- (vector-length g) 1))
  (define k (- (vector-length f) 1 m))
  (define rest (make-vector (vector-length f)))
  (vector-copy! rest 0 f)
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

;; ---------------------------------------------------------------------------
;; Choices

;; All lists of k elements of xs, in their order.
(define (subsets xs k)
  (cond [(eqv? k 0) '(())]
        [(< (length xs) k) '()]
        [else
         (append (for/list ([s (in-list (subsets (cdr xs) (- k 1)))]) (cons (car xs) s))
                 (subsets (cdr xs) k))]))

(define (remove-all used xs)
  (filter (lambda (x) (not (memq x used))) xs))
