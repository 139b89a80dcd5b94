#lang racket/base
;; Univariate images, and what they prove about a gcd.
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

(require racket/fixnum "ring.rkt" "modular.rkt")

(provide gcd-degree-bounds)

;; A list of bounds of the degrees of gcd(p, q), one a listed variable; p and q
;; may have others.
;; p, q : nonzero, with integer coefficients
(define (gcd-degree-bounds R p q variables seed P)
  (define point (sample-point R seed P))
  (define inverse (make-fxvector (ring-size R) 0))
  (for ([i (in-list variables)])
    (fxvector-set! inverse i (mod-inverse (fxvector-ref point i) P)))
  (define p-images (images R p variables point inverse P))
  (define q-images (images R q variables point inverse P))
  (for/list ([i (in-list variables)])
    (bound (vector-ref p-images i) (vector-ref q-images i) P)))

(define (sample-point R seed P)
  (define point (make-fxvector (ring-size R)))
  (for ([i (in-range (ring-size R))])
    (fxvector-set! point i (sample-residue seed i P)))
  point)

;; Images whose leading coefficients both vanished prove nothing.
(define (bound a b P)
  (define a-top (fx- (fxvector-length a) 1))
  (define b-top (fx- (fxvector-length b) 1))
  (cond [(and (eq? 0 (fxvector-ref a a-top)) (eq? 0 (fxvector-ref b b-top)))
         (min a-top b-top)]
        [else
         (define-values (g degree)
           (univariate-gcd! a (univariate-degree a a-top) b (univariate-degree b b-top) P))
         (min degree a-top b-top)]))

;; ---------------------------------------------------------------------------
;; Images

;; A vector by variable, of dense images for the listed ones and #f for others.
(define (images R p variables point inverse P)
  (define terms (for/list ([t (in-list p)]) (monomial-factors R (car t))))
  (define result (blank-images R terms variables))
  (define total
    (for/fold ([total 0]) ([t (in-list p)] [factors (in-list terms)])
      (define value (term-value (modulo (cdr t) P) factors point P))
      (add-term! result factors value inverse P)
      (mod+ total value P)))
  (for ([i (in-list variables)])
    (add-at! (vector-ref result i) 0 total P))
  result)

;; Zero images, as long as the degrees ask.
(define (blank-images R terms variables)
  (define degrees (make-fxvector (ring-size R) 0))
  (for* ([factors (in-list terms)] [f (in-list factors)])
    (when (fx> (cdr f) (fxvector-ref degrees (car f)))
      (fxvector-set! degrees (car f) (cdr f))))
  (define result (make-vector (ring-size R) #f))
  (for ([i (in-list variables)])
    (vector-set! result i (make-fxvector (fx+ 1 (fxvector-ref degrees i)) 0)))
  result)

;; Put a term at its degree in the variables it has.  At the end every image
;; gets the total of all terms at degree 0, so there this one is taken off.
(define (add-term! images factors value inverse P)
  (for ([f (in-list factors)])
    (define image (vector-ref images (car f)))
    (when image
      (define power (mod-expt (fxvector-ref inverse (car f)) (cdr f) P))
      (add-at! image (cdr f) (mod* value power P) P)
      (add-at! image 0 (fx- P value) P))))

(define (term-value c factors point P)
  (for/fold ([value c]) ([f (in-list factors)])
    (mod* value (mod-expt (fxvector-ref point (car f)) (cdr f) P) P)))

(define (add-at! image e value P)
  (fxvector-set! image e (fxremainder (fx+ (fxvector-ref image e) value) P)))
