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

(require "arithmetic.rkt" "content.rkt" "dense.rkt" "division.rkt" "gcd.rkt" "inspect.rkt"
         "integer-factor.rkt" "lifting.rkt" "rering.rkt" "ring.rkt")

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
        (rering V R (if reversed? (positive V (reversed V g x)) g)))))

;; The same, of p in the variable x; #f where it would be too much work.
(define (view-factors V p x)
  (define W (wider-ring V (room V p x)))
  (define l (rering V W (leading-along V p x)))
  (define q (make-monic W (rering V W p) x l))
  (define factors (and (<= (length q) terms-limit) (monic-factors W q x)))
  (and factors
       (for/list ([f (in-list factors)]) (rering W V (unmake-monic W f x l)))))

;; ---------------------------------------------------------------------------
;; The view: which variable, and whether its powers are taken in reverse order

;; -> variable and reversed?, for the simplest leading coefficient
(define (best-view R p)
  (define-values (cost x reversed?)
    (for*/fold ([cost #f] [x #f] [reversed? #f])
               ([i (in-list (poly-variables R p))] [r? (in-list '(#f #t))])
      (define new (view-cost R (if r? (reversed R p i) p) i))
      (if (or (not cost) (< new cost)) (values new i r?) (values cost x reversed?))))
  (values x reversed?))

(define (view-cost R p i)
  (define l (leading-along R p i))
  (define n (poly-degree R p i))
  (+ (* 1000 (- n 1) (poly-total-degree R l)) (* 10 n) (length l)))

(define (leading-along R p i) (cdar (poly-coefficients R p i)))

;; xⁿ p(1/x)
(define (reversed R p i)
  (define cs (poly-coefficients R p i))
  (define n (caar cs))
  (poly-from-coefficients R i
    (for/list ([c (in-list cs)]) (cons (- n (car c)) (cdr c)))))

;; Degree enough for the monic polynomial, for products of its factors while they
;; are lifted, and for the way back.
(define (room R p x)
  (define l (poly-total-degree R (leading-along R p x)))
  (define n (poly-degree R p x))
  (+ (* 2 (+ (poly-total-degree R p) (* (- n 1) l) n))
     (* n (+ l 1))))

;; l^(n-1) p(x/l)
(define (make-monic R p x l)
  (define cs (poly-coefficients R p x))
  (define n (caar cs))
  (poly-from-coefficients R x
    (for/list ([c (in-list cs)])
      (cons (car c)
            (if (eqv? (car c) n)
                (poly-constant R 1)
                (poly* R (cdr c) (poly-expt R l (- n 1 (car c)))))))))

;; The factor of p that became the monic f.
(define (unmake-monic R f x l)
  (define g (poly-substitute R f x (poly* R l (poly-variable R x))))
  (define content (poly-gcd* R (map cdr (poly-coefficients R g x))))
  (positive R (poly-divide R g content)))

(define (positive R p)
  (define-values (content primitive) (poly-primitive R p))
  primitive)

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
  (for/fold ([q q]) ([c (in-list point)] #:unless (eqv? 0 (cdr c)))
    (poly-substitute R q (car c)
                     (poly+ R (poly-variable R (car c)) (poly-constant R (* sign (cdr c)))))))

;; Twice what the coefficients of a factor can be, after Gelfond.
(define (coefficient-bound R q)
  (define degrees (for/list ([i (in-list (poly-variables R q))]) (poly-degree R q i)))
  (* 2
     (expt 2 (apply + degrees))
     (apply * (map add1 degrees))
     (for/fold ([m 1]) ([t (in-list q)]) (max m (abs (cdr t))))))

;; Products of k images are tried for k = 1, 2, ... .
(define (combine R q x images P)
  (let loop ([q q] [images images] [k 1])
    (cond [(> (* 2 k) (length images)) (if (null? images) '() (list q))]
          [else
           (define-values (g rest used) (find-factor R q x images k P))
           (cond [(eq? g 'too-much) #f]
                 [g
                  (define others
                    (loop rest (filter (lambda (h) (not (memq h used))) images) k))
                  (and others (cons g others))]
                 [else (loop q images (+ k 1))])])))

;; -> a factor, the quotient, and the images it is made of; or #f; or 'too-much.
(define (find-factor R q x images k P)
  (let try ([choices (subsets images k)])
    (cond [(null? choices) (values #f #f #f)]
          [else
           (define chosen (car choices))
           (define others (filter (lambda (h) (not (memq h chosen))) images))
           (define g (lift-factor R q x (product chosen P) (product others P) P))
           (define rest (and g (poly-divide R q g)))
           (cond [(not g) (values 'too-much #f #f)]
                 [rest (values g rest chosen)]
                 [else (try (cdr choices))])])))

(define (product ps P)
  (for/fold ([product #(1)]) ([p (in-list ps)]) (dense* product p P)))

;; ---------------------------------------------------------------------------
;; Images

;; How many images are looked at.
(define images-limit 3)

;; -> ((variable . integer) ...) and the factors of the image there, as few as can
;; be had; #f and #f if all images have double factors.
(define (best-image R q x)
  (define others (filter (lambda (i) (not (eqv? i x))) (poly-variables R q)))
  (let loop ([points (points others)] [tries images-limit] [best #f] [factors #f])
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
  (define (point f) (for/list ([i (in-list variables)] [j (in-naturals)]) (cons i (f j))))
  (append (list (point (lambda (j) 0)))
          (for/list ([k (in-range (length variables))])
            (point (lambda (j) (if (eqv? j k) 1 0))))
          (for/list ([k (in-range 1 9)])
            (point (lambda (j)
                     (- (modulo (* (+ j 3) (+ k 1) (+ k j 5)) (+ k 4)) (quotient k 3)))))))

(define (image-at R q x point)
  (define image
    (for/fold ([q q]) ([c (in-list point)])
      (poly-substitute R q (car c) (poly-constant R (cdr c)))))
  (define v (make-vector (+ 1 (poly-degree R image x)) 0))
  (for ([c (in-list (poly-coefficients R image x))])
    (vector-set! v (car c) (poly-constant-value (cdr c))))
  v)
