#lang racket/base
;; Splitting a polynomial as far as gcds go, the same way whatever its history.
;;
;; Variables that divide p are parts of their own.  All other irreducible
;; factors of p are told apart by their multiplicity and by the set of variables
;; that occur in them; the *part* for a multiplicity and a set is the product of
;; the factors that have both.  Square-free decomposition gives multiplicities.
;; The content of p in x collects the factors free of x, so taking contents in
;; every variable separates the sets.

(require "arithmetic.rkt" "content.rkt" "coprime-basis.rkt" "division.rkt" "gcd.rkt"
         "polynomial-parts.rkt" "power.rkt" "square-free.rkt" "term-list.rkt")

(provide poly-parts product-parts)

;; Powers of parts: primitive, square-free, pairwise coprime, sorted; their product
;; is p up to a rational factor.
(define (poly-parts R p) (product-parts R (list (make-power p 1))))

;; The parts of a product of powers of polynomials, nonzero and pairwise coprime.
(define (product-parts R factors)
  (basis-sort
   (merge-parts R
                (for*/list ([f (in-list factors)]
                            [part (in-list (split-polynomial R (power-base f)))])
                  (make-power (power-base part)
                              (* (power-exponent f) (power-exponent part)))))))

(define (split-polynomial R p)
  (define-values (variables rest) (split-monomial R p))
  (append variables
          (for*/list ([f (in-list (poly-square-free R rest))]
                      [part (in-list (split-by-variables R (power-base f)))])
            (make-power part (power-exponent f)))))

;; Factors of p; all irreducible factors of one have the same variables.
(define (split-by-variables R p)
  (let loop ([variables (poly-variables R p)])
    (cond [(null? variables) (list p)]
          [else
           (define content (poly-content-in R p (car variables)))
           (if (poly-constant? content)
               (loop (cdr variables))
               (append (split-by-variables R content)
                       (split-by-variables R (poly-divide R p content))))])))

;; Parts of the same multiplicity in the same variables multiplied together.
(define (merge-parts R parts)
  (define table (make-hash))
  (for ([part (in-list parts)])
    (define p (power-base part))
    (define key (list (power-exponent part) (single-term? p) (poly-variables R p)))
    (hash-update! table key (lambda (q) (poly* R p q)) (poly-constant R 1)))
  (for/list ([(key p) (in-hash table)])
    (make-power p (car key))))
