#lang racket/base
;; The greatest common divisor of polynomials.
;;
;; In order: numbers and monomials are split off; a variable that only one of
;; the two has, or that univariate images (univariate-images.rkt) show to be missing in the
;; gcd, is got rid of by taking coefficients, since a polynomial that divides p and is free
;; of x divides every coefficient of p in x.  Mostly nothing is left, and
;; coprimality is proved.  Otherwise a common divisor g is found by trial
;; division, heuristically or by the sparse modular method, and checked by
;; division; if its degrees attain the bounds of the images it is the greatest,
;; else gcd(p, q) = g · gcd(p/g, q/g).  Remainder sequences, which need no luck,
;; come last, so the answer is always right and always comes.

(require "arithmetic.rkt" "content.rkt" "division.rkt" "heuristic-gcd.rkt" "univariate-images.rkt"
         "modular.rkt" "polynomial-parts.rkt" "remainder-gcd.rkt" "ring.rkt" "ring-change.rkt"
         "sparse-gcd.rkt"
         "term-list.rkt")

(provide poly-gcd poly-gcd* poly-content-in)

;; The gcd over the rationals as a primitive integer polynomial with positive
;; leading coefficient; 0 when both are 0.
(define (poly-gcd R p q)
  (cond [(null? p) (poly-primitive-part R q)]
        [(null? q) (poly-primitive-part R p)]
        [(or (poly-constant? p) (poly-constant? q)) (poly-constant R 1)]
        [else
         (define m (common-monomial R p))
         (define n (common-monomial R q))
         (define (core p m) (poly-primitive-part R (divide-by-monomial R p m)))
         (define g (primitive-gcd R (core p m) (core q n)))
         (shift-terms (monomial-gcd R m n) 1 g)]))

;; The gcd of a list, small ones first.
(define (poly-gcd* R ps)
  (for/fold ([g '()]) ([p (in-list (sort ps < #:key length #:cache-keys? #t))]
                       #:break (and (pair? g) (poly-constant? g)))
    (poly-gcd R g p)))

;; The gcd of the coefficients of p in variable i.
(define (poly-content-in R p i)
  (poly-gcd* R (map slice-coefficient (poly-coefficients R p i))))

;; ---------------------------------------------------------------------------
;; Getting rid of variables.  From here on p and q are primitive, and no
;; variable divides them.

(define (primitive-gcd R p q)
  (cond [(or (poly-constant? p) (poly-constant? q)) (poly-constant R 1)]
        [(poly=? p q) p]
        [else (gcd-by-images R p q (poly-variables R p) (poly-variables R q) 0)]))

;; How often other points and primes are tried before remainder sequences.
(define attempts 4)

(define (gcd-by-images R p q p-variables q-variables seed)
  (define common (filter (lambda (i) (memv i q-variables)) p-variables))
  (define bounds (gcd-degree-bounds R p q common seed (nth-prime seed)))
  (define kept
    (for/list ([i (in-list common)] [b (in-list bounds)] #:unless (eq? b 0)) i))
  (define kept-bounds (remv* '(0) bounds))
  (define p-others (remv* kept p-variables))
  (define q-others (remv* kept q-variables))
  (cond [(null? kept) (poly-constant R 1)]
        [(whole-divisor R p q p-others q-others kept kept-bounds)]
        [(and (null? p-others) (null? q-others))
         (gcd-by-divisor R p q kept kept-bounds seed)]
        [else
         (poly-gcd* R (append (poly-coefficients-over R p p-others)
                              (poly-coefficients-over R q q-others)))]))

;; p or q, when the bounds allow it to be the gcd and it is; else #f.
(define (whole-divisor R p q p-others q-others kept bounds)
  (define (fits? p others)
    (and (null? others) (equal? bounds (degrees R p kept))))
  (cond [(and (fits? q q-others) (poly-divide-integral R p q)) q]
        [(and (fits? p p-others) (poly-divide-integral R q p)) p]
        [else #f]))

;; By a divisor found somehow; p and q have the same variables, all of which
;; their gcd may have.
(define (gcd-by-divisor R p q variables bounds seed)
  (define g (find-divisor R p q variables bounds seed))
  (cond [(and g (equal? bounds (degrees R g variables))) g]
        [(and g (not (poly-constant? g)))
         (poly* R g (poly-gcd R (poly-divide R p g) (poly-divide R q g)))]
        [(< seed attempts) (gcd-by-images R p q variables variables (+ seed 1))]
        [else (remainder-gcd R p q)]))

(define (degrees R p variables)
  (for/list ([i (in-list variables)]) (poly-degree R p i)))

;; ---------------------------------------------------------------------------
;; Finding a divisor

;; Larger integers than this many bits are left to the sparse method.
(define heuristic-limit 2500)

(define (find-divisor R p q variables bounds seed)
  (or (and (eqv? seed 0)
           (< (heuristic-size R p q variables) heuristic-limit)
           (heuristic-divisor R p q variables))
      (sparse-divisor-within R p q variables bounds seed)))

;; Scaling by leading coefficients can double the degrees.
(define (sparse-divisor-within R p q variables bounds seed)
  (define degree (* 2 (max (poly-total-degree R p) (poly-total-degree R q))))
  (define W (if (<= degree (ring-max-degree R)) R (wider-ring R degree)))
  (define g
    (sparse-divisor W (rering R W p) (rering R W q) variables bounds
                    (lambda (ps) (poly-gcd* W ps))
                    seed))
  (and g (rering W R g)))
