#lang racket/base
;; Factors of polynomials in several variables.
;;
;; At a point of all variables but one, x, the polynomial p has an image in x
;; alone, whose factors are known (integer-factor.rkt).  If it is irreducible, so
;; is p.  If not, each factor of p has a product of some of these factors for its
;; image, and is recovered from it by lifting (lifting.rkt); division decides.
;;
;; Lifting wants p to be monic in x: with leading coefficient l and degree n, not
;; p but l^(n-1) p(x/l) is treated.

(require (only-in racket/list argmin)
         "arithmetic.rkt" "content.rkt" "dense.rkt" "division.rkt" "gcd.rkt" "polynomial-parts.rkt"
         "integer-factor.rkt" "lifting.rkt" "recombination.rkt" "ring-change.rkt" "ring.rkt"
         "term-list.rkt")

(provide lifted-factors)

;; A polynomial of more terms than these is not lifted.
(define terms-limit 1500)

;; The irreducible factors of p, which is square-free, primitive over the integers
;; and in each of its variables; they are primitive.  (list p) where it would be
;; too much work to find them.
(define (lifted-factors R p)
  (define V (wider-ring R (* 2 (poly-total-degree R p))))
  (define-values (x reversed?) (best-view V (rering R V p)))
  (define factors (view-factors V (if reversed? (reversed V (rering R V p) x) (rering R V p)) x))
  (if (or (not factors) (null? (cdr factors)))
      (list p)
      (for/list ([g (in-list factors)])
        (rering V R (if reversed? (poly-primitive-part V (reversed V g x)) g)))))

;; The same, of p in the variable x; #f where it would be too much work.
(define (view-factors V p x)
  (define W (wider-ring V (room V p x)))
  (define l (rering V W (poly-leading-coefficient-in V p x)))
  (define q (make-monic W (rering V W p) x l))
  (define factors (and (<= (length q) terms-limit) (monic-factors W q x)))
  (and factors
       (for/list ([f (in-list factors)]) (rering W V (unmake-monic W f x l)))))

;; ---------------------------------------------------------------------------
;; The view: which variable, and whether its powers are taken in reverse order

;; -> variable and reversed?, for the simplest leading coefficient
(define (best-view R p)
  (define views
    (for*/list ([x (in-list (poly-variables R p))] [reversed? (in-list '(#f #t))])
      (cons x reversed?)))
  (define best
    (argmin (lambda (v) (view-cost R (if (cdr v) (reversed R p (car v)) p) (car v))) views))
  (values (car best) (cdr best)))

(define (view-cost R p i)
  (define l (poly-leading-coefficient-in R p i))
  (define n (poly-degree R p i))
  (+ (* 1000 (- n 1) (poly-total-degree R l)) (* 10 n) (length l)))

;; xⁿ p(1/x)
(define (reversed R p i)
  (define n (poly-degree R p i))
  (poly-from-coefficients R i
    (for/list ([s (in-list (poly-coefficients R p i))])
      (make-slice (- n (slice-degree s)) (slice-coefficient s)))))

;; Degree enough for the monic polynomial, for products of its factors while they
;; are lifted, and for the way back.
(define (room R p x)
  (define l (poly-total-degree R (poly-leading-coefficient-in R p x)))
  (define n (poly-degree R p x))
  (+ (* 2 (+ (poly-total-degree R p) (* (- n 1) l) n))
     (* n (+ l 1))))

;; l^(n-1) p(x/l)
(define (make-monic R p x l)
  (define n (poly-degree R p x))
  (poly-from-coefficients R x
    (for/list ([s (in-list (poly-coefficients R p x))])
      (define d (slice-degree s))
      (make-slice d
                  (if (eqv? d n)
                      (poly-constant R 1)
                      (poly* R (slice-coefficient s) (poly-expt R l (- n 1 d))))))))

;; The factor of p that became the monic f.
(define (unmake-monic R f x l)
  (define g (poly-substitute R f x (poly* R l (poly-variable R x))))
  (poly-primitive-part R (poly-divide R g (poly-content-in R g x))))

;; ---------------------------------------------------------------------------
;; Monic polynomials

;; The irreducible factors of q, monic in x; #f where it would be too much work.
(define (monic-factors R q x)
  (define-values (point images) (best-image R q x))
  (cond [(not images) #f]
        [(null? (cdr images)) (list q)]
        [(> (length images) choices-limit) #f]
        [else
         (define moved (translate R q point 1))
         (define P (prime-above (coefficient-bound R moved)))
         (define factors
           (and P (<= (length moved) terms-limit)
                (combine R moved x (for/list ([g (in-list images)]) (dense g P)) P)))
         (and factors
              (for/list ([f (in-list factors)]) (translate R f point -1)))]))

;; q at y + sign · point
(define (translate R q point sign)
  (for/fold ([q q]) ([c (in-list point)] #:unless (eqv? 0 (coordinate-value c)))
    (define y (coordinate-variable c))
    (define shift (poly-constant R (* sign (coordinate-value c))))
    (poly-substitute R q y (poly+ R (poly-variable R y) shift))))

;; Twice the bound on the coefficients of a factor, after Gelfond.
(define (coefficient-bound R q)
  (define degrees (for/list ([i (in-list (poly-variables R q))]) (poly-degree R q i)))
  (* 2
     (expt 2 (apply + degrees))
     (apply * (map add1 degrees))
     (poly-height q)))

;; #f as soon as lifting is too much work.
(define (combine R q x images P)
  (let/ec give-up
    (define (split q chosen others)
      (define g
        (or (lift-factor R q x (dense-product #(1) chosen P) (dense-product #(1) others P) P)
            (give-up #f)))
      (define rest (poly-divide R q g))
      (if rest (values g rest) (values #f #f)))
    (recombine q images split)))

;; ---------------------------------------------------------------------------
;; Images

;; How many images are looked at.
(define images-limit 3)

;; A point is a list of these; values are integers.
(struct coordinate (variable value) #:authentic)

;; -> point and the factors of the image there, as few as can be had; #f and #f if
;; all images have double factors.
(define (best-image R q x)
  (let loop ([points (points (remv x (poly-variables R q)))]
             [tries images-limit] [best #f] [factors #f])
    (cond [(or (null? points) (eqv? tries 0) (and factors (null? (cdr factors))))
           (values best factors)]
          [else
           (define image (image-at R q x (car points)))
           (define new (and (square-free? image) (integer-factors image)))
           (cond [(not new) (loop (cdr points) tries best factors)]
                 [(or (not factors) (< (length new) (length factors)))
                  (loop (cdr points) (- tries 1) (car points) new)]
                 [else (loop (cdr points) (- tries 1) best factors)])])))

;; Points with many zeros first: moving them to 0 keeps polynomials short.
(define (points variables)
  (define (point f) (for/list ([i (in-list variables)] [j (in-naturals)]) (coordinate i (f j))))
  (append (list (point (lambda (j) 0)))
          (for/list ([k (in-range (length variables))])
            (point (lambda (j) (if (eqv? j k) 1 0))))
          (for/list ([k (in-range 1 9)])
            (point (lambda (j)
                     (- (modulo (* (+ j 3) (+ k 1) (+ k j 5)) (+ k 4)) (quotient k 3)))))))

(define (image-at R q x point)
  (define image
    (for/fold ([q q]) ([c (in-list point)])
      (poly-substitute R q (coordinate-variable c) (poly-constant R (coordinate-value c)))))
  (poly->vector R image x))
