#lang racket/base
;; The heuristic gcd of Char, Geddes and Gonnet.
;;
;; Put a large integer ξ for one variable after the other: at the end p and q
;; are integers, whose gcd is quick.  If g divides p then g(ξ) divides p(ξ), and
;; when ξ exceeds twice every coefficient of g, g is read off g(ξ) as its digits
;; to the base ξ, balanced about 0:
;;
;;     g = Σ gᵢ xⁱ,   g(ξ) mod ξ = g₀,   (g(ξ) - g₀)/ξ mod ξ = g₁,  ....
;;
;; gcd(p(ξ), q(ξ)) may have more factors than g(ξ), so the outcome is a guess
;; until it is seen to divide p and q.  The integers have some
;; log ξ · ∏ (1 + degree) digits: right for few variables, hopeless for many.

(require "arithmetic.rkt" "content.rkt" "division.rkt" "modular.rkt" "polynomial-parts.rkt"
         "ring.rkt"
         "term-list.rkt")

(provide heuristic-divisor heuristic-size)

;; A common divisor, primitive, likely the greatest; or #f.
;; p, q : primitive, over the given variables
(define (heuristic-divisor R p q variables)
  (for/or ([growth (in-list '(1 17/8 23/4))])
    (define g (poly-primitive-part R (guess R p q variables growth)))
    (and (poly-divide-integral R p g) (poly-divide-integral R q g) g)))

;; About how many bits the integers would have.
(define (heuristic-size R p q variables)
  (for/fold ([bits (integer-length (least-base p q))])
            ([i (in-list variables)])
    (* bits (+ 1 (max (poly-degree R p i) (poly-degree R q i))))))

(define (least-base p q) (+ 29 (* 2 (min (poly-height p) (poly-height q)))))

;; gcd over the integers, contents included, as the digits tell it to bases
;; `growth` times as large as they need be.
(define (guess R p q variables growth)
  (cond [(null? p) q]
        [(null? q) p]
        [(null? variables)
         (poly-constant R (gcd (poly-constant-value p) (poly-constant-value q)))]
        [else
         (define-values (p-content p*) (poly-primitive R p))
         (define-values (q-content q*) (poly-primitive R q))
         (define x (car variables))
         (define base (floor (* growth (least-base p* q*))))
         (define g
           (guess R (put R p* x base) (put R q* x base) (cdr variables) growth))
         (poly-scale R (gcd p-content q-content) (digits R g x base))]))

;; p with the integer n for variable x.
(define (put R p x n)
  (charge! R (* 2 (length p)))
  (poly-sum R
            (for/list ([c (in-list (poly-coefficients R p x))])
              (poly-scale R (expt n (slice-degree c)) (slice-coefficient c)))))

(define (digits R g x base)
  (poly-from-coefficients
   R x
   (let loop ([g g] [i 0] [coefficients '()])
     (cond [(null? g) coefficients]
           [else
            (define low (remainders g base))
            (loop (poly-scale R (/ 1 base) (poly- R g low))
                  (+ i 1)
                  (cons (make-slice i low) coefficients))]))))

(define (remainders g base)
  (for*/list ([t (in-list g)]
              [r (in-value (symmetric-residue (term-coefficient t) base))]
              #:unless (eqv? r 0))
    (make-term (term-monomial t) r)))
