#lang racket/base
;; Polynomials in z = q + i p and w = q − i p of each of n oscillators, with complex numbers for
;; coefficients: hashes of exponents (a₁ … aₙ b₁ … bₙ) of z₁ … zₙ w₁ … wₙ.
;;
;; Since {z, w} = −2i, brackets are {f, g} = −2i Σ ∂f/∂z ∂g/∂w − ∂f/∂w ∂g/∂z, and the energy
;; ω (q² + p²)/2 = ω z w/2 has {ω z w/2, zᵃ wᵇ} = i ω (a − b) zᵃ wᵇ: monomials are the
;; eigenvectors of the homological equation.
;;
;; A polynomial in q and p is read off an expression: exact where its numbers are.

(require racket/list
         "expression-in-ring.rkt"
         "../../generic/arithmetic.rkt" "../../generic/elementary.rkt")

(provide polynomial-sum polynomial-scale polynomial-bracket majorant-bracket
         expression->polynomial polynomial->expression exponent-differences)

(define (add-term p exponents c)
  (define sum (+ c (hash-ref p exponents 0)))
  (if (zero? sum) (hash-remove p exponents) (hash-set p exponents sum)))

(define (polynomial-sum f g)
  (for/fold ([p f]) ([(e c) (in-hash g)]) (add-term p e c)))

(define (polynomial-scale c f)
  (if (zero? c) (hash) (for/hash ([(e d) (in-hash f)]) (values e (* c d)))))

(define (polynomial-product f g)
  (for*/fold ([p (hash)]) ([(d c1) (in-hash f)] [(e c2) (in-hash g)])
    (add-term p (map + d e) (* c1 c2))))

;; n : the number of oscillators
(define (polynomial-bracket n) (bracket-of n (lambda (a b a1 b1) (* 0-2i (- (* a b1) (* b a1))))))

;; Of polynomials of magnitudes: what the terms of a bracket are together at most
(define (majorant-bracket n) (bracket-of n (lambda (a b a1 b1) (* 2 (+ (* a b1) (* b a1))))))

;; factor : of the exponents of z and w in both
(define ((bracket-of n factor) f g)
  (for*/fold ([p (hash)]) ([(d c1) (in-hash f)] [(e c2) (in-hash g)])
    (define total (map + d e))
    (for/fold ([p p]) ([j (in-range n)])
      (define-values (a b) (values (list-ref d j) (list-ref d (+ n j))))
      (define-values (a1 b1) (values (list-ref e j) (list-ref e (+ n j))))
      (define c (factor a b a1 b1))
      (if (zero? c) p (add-term p (lowered total j n) (* c c1 c2))))))

;; One less of z_j and of w_j
(define (lowered exponents j n)
  (for/list ([e (in-list exponents)] [k (in-naturals)])
    (if (or (= k j) (= k (+ n j))) (sub1 e) e)))

;; a − b for the exponents a of the z and b of the w
(define (exponent-differences exponents)
  (define-values (a b) (split-at exponents (quotient (length exponents) 2)))
  (map - a b))

;; The exponents of the variable of index k alone; of none for k = −1
(define (unit-exponents n k) (for/list ([j (in-range (* 2 n))]) (if (= j k) 1 0)))

;; ---------------------------------------------------------------------------
;; From expressions and back

;; e : in the symbols qs and ps; (fail part) for what is no polynomial with numbers
(define (expression->polynomial e qs ps fail)
  (define n (length qs))
  (define (unit k) (unit-exponents n k))
  (define (constant c) (if (zero? c) (hash) (hash (unit -1) c)))
  (define places
    (append
     (for/list ([q (in-list qs)] [j (in-naturals)])
       (cons q (hash (unit j) 1/2 (unit (+ n j)) 1/2)))
     (for/list ([p (in-list ps)] [j (in-naturals)])
       (cons p (hash (unit j) 0-1/2i (unit (+ n j)) 0+1/2i)))))
  (define (seen e)
    (cond [(number? e) (constant e)]
          [(assq e places) => cdr]
          [else #f]))
  (expression-in (ring constant polynomial-sum polynomial-product polynomial-scale)
                 e seen fail))

;; Of a real polynomial, at values of the q and p: the coefficients of q and p that the binomial
;; theorem gives, so that nothing complex is left.
(define (polynomial->expression f qs ps)
  (for/fold ([sum 0]) ([(exponents c) (in-hash (in-q-and-p f (length qs)))])
    (g:+ sum
         (for/fold ([product (real-part c)])
                   ([x (in-list (append qs ps))] [k (in-list exponents)] #:unless (zero? k))
           (g:* product (g:expt x k))))))

;; hash of the exponents of q₁ … p₁ …
(define (in-q-and-p f n)
  (define (unit k) (unit-exponents n k))
  (define variables                 ; z and w in terms of q and p
    (append (for/list ([j (in-range n)]) (hash (unit j) 1 (unit (+ n j)) 0+1i))
            (for/list ([j (in-range n)]) (hash (unit j) 1 (unit (+ n j)) 0-1i))))
  (for/fold ([total (hash)]) ([(exponents c) (in-hash f)])
    (polynomial-sum
     total
     (for*/fold ([product (hash (unit -1) c)])
                ([(v k) (in-parallel variables exponents)] [_ (in-range k)])
       (polynomial-product product v)))))
