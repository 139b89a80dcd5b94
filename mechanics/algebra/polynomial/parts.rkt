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
         "inspect.rkt" "monomial.rkt" "ring.rkt" "square-free.rkt")

(provide poly-parts product-parts)

;; ((part . multiplicity) ...): primitive, square-free, pairwise coprime, sorted;
;; their product is p up to a rational factor.
(define (poly-parts R p) (product-parts R (list (cons p 1))))

;; The parts of the product of ((polynomial . exponent) ...), nonzero and
;; pairwise coprime.
(define (product-parts R factors)
  (basis-sort
   (merge-parts R
                (for*/list ([f (in-list factors)]
                            [part (in-list (split-polynomial R (car f)))])
                  (cons (car part) (* (cdr f) (cdr part)))))))

(define (split-polynomial R p)
  (define m (common-monomial R p))
  (append (for/list ([v (in-list (monomial-factors R m))])
            (cons (poly-variable R (car v)) (cdr v)))
          (for*/list ([f (in-list (poly-square-free
                                   R (shift-terms (monomial- (ring-one R) m) 1 p)))]
                      [part (in-list (split-by-variables R (car f)))])
            (cons part (cdr f)))))

;; Factors of p; all irreducible factors of one have the same variables.
(define (split-by-variables R p)
  (let loop ([variables (poly-variables R p)])
    (cond [(null? variables) (list p)]
          [else
           (define content
             (poly-gcd* R (map cdr (poly-coefficients R p (car variables)))))
           (if (poly-constant? content)
               (loop (cdr variables))
               (append (split-by-variables R content)
                       (split-by-variables R (poly-divide R p content))))])))

;; Parts of the same multiplicity in the same variables multiplied together.
(define (merge-parts R parts)
  (define table (make-hash))
  (for ([part (in-list parts)])
    (define p (car part))
    (define key
      (list (cdr part) (null? (cdr p)) (poly-variables R p)))
    (hash-update! table key (lambda (q) (poly* R p q)) (poly-constant R 1)))
  (for/list ([(key p) (in-hash table)])
    (cons p (car key))))
