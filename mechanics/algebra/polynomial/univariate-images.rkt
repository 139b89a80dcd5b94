#lang racket/base
;; Univariate images, and their proofs about a gcd.
;;
;; Put residues α in the place of all variables but x, and reduce modulo a
;; prime P.  A common divisor g of p and q becomes a common divisor of their
;; images; and when the leading coefficient of p in x does not vanish at α, nor
;; does that of g, so
;;
;;     deg_x g  ≤  deg gcd(p(x, α), q(x, α))  mod P.
;;
;; One point gives this bound for every variable.  All bounds 0 prove p and q
;; coprime; a bound 0 for x proves their gcd free of x.  The cost is a few
;; products modulo P a term, and most pairs met in practice are settled by it.
;;
;; With v the value of a term c x^e y^f ... at α, its share in the image along x
;; is v α_x^(-e): dividing by one coordinate serves all images from one pass.

(require racket/fixnum
         "modular.rkt" "ring.rkt" "term-list.rkt")

(provide gcd-degree-bounds)

;; A list of bounds of the degrees of gcd(p, q), one a listed variable; p and q
;; may have others.
;; p, q : nonzero, with integer coefficients
(define (gcd-degree-bounds R p q variables seed P)
  (charge! R (* 2 (+ (length p) (length q))))
  (define point (sample-point R seed P))
  (define inverse (make-fxvector (ring-size R) 0))
  (for ([i (in-list variables)])
    (fxvector-set! inverse i (mod-inverse (fxvector-ref point i) P)))
  (define-values (p-images p-degrees) (images R p variables point inverse P))
  (define-values (q-images q-degrees) (images R q variables point inverse P))
  (for/list ([i (in-list variables)])
    (bound (vector-ref p-images i) (fxvector-ref p-degrees i)
           (vector-ref q-images i) (fxvector-ref q-degrees i)
           P)))

(define (sample-point R seed P)
  (for/fxvector #:length (ring-size R) ([i (in-range (ring-size R))]) (sample-residue seed i P)))

;; Images whose leading coefficients both vanished prove nothing.
(define (bound a a-top b b-top P)
  (cond [(and (eq? 0 (fxvector-ref a a-top)) (eq? 0 (fxvector-ref b b-top)))
         (min a-top b-top)]
        [else
         (define-values (g degree)
           (univariate-gcd! a (univariate-degree a a-top) b (univariate-degree b b-top) P))
         (min degree a-top b-top)]))

;; ---------------------------------------------------------------------------
;; Images

;; -> images degrees.  A vector by variable, of dense images for the listed ones
;; and #f for others; and the degrees of p, a fxvector.  A term is put at its
;; degree in the variables it has; at the end every image gets the total of all
;; terms at degree 0, so there this one is taken off.
(define (images R p variables point inverse P)
  (define degrees (make-fxvector (ring-size R) 0))
  (define images (blank-images R p variables))
  (define (multiply i e value)
    (mod* value (mod-expt (fxvector-ref point i) e P) P))
  (define (put! i e value)
    (define image (vector-ref images i))
    (when image
      (when (fx> e (fxvector-ref degrees i)) (fxvector-set! degrees i e))
      (define share (mod* value (mod-expt (fxvector-ref inverse i) e P) P))
      (add-at! image e share P)
      (add-at! image 0 (fx- P value) P))
    value)
  (define total
    (for/fold ([total 0]) ([t (in-list p)])
      (define m (term-monomial t))
      (define value (monomial-fold R m multiply (modulo (term-coefficient t) P)))
      (mod+ total (monomial-fold R m put! value) P)))
  (for ([i (in-list variables)])
    (add-at! (vector-ref images i) 0 total P))
  (values images degrees))

;; No variable has a degree above the total one.
(define (blank-images R p variables)
  (define size (+ 1 (monomial-degree R (leading-monomial p))))
  (for/vector #:length (ring-size R) ([i (in-range (ring-size R))])
    (and (memv i variables) (make-fxvector size 0))))

(define (add-at! image e value P)
  (fxvector-set! image e (mod+ (fxvector-ref image e) value P)))
