#lang racket/base
;; The sparse modular gcd of Zippel.
;;
;; Let g = gcd(p, q), x a variable of it, γ the gcd of the leading coefficients
;; of p and q in x.  Then lc(g) divides γ, and h = γ g / lc(g) is a polynomial
;; with known leading coefficient, so its images can be scaled alike.  Modulo a
;; prime P, h is built one variable at a time.  With all other variables put to
;; residues α it is a univariate gcd.  Suppose it is known with y₁ ... yⱼ₋₁
;; restored.  A monomial missing there was, almost surely, not annihilated by
;; the choice of α but is missing in h; so at some other values of yⱼ only the
;; coefficients are to be found (skeleton.rkt), and Newton's interpolation in yⱼ
;; restores it.  The work grows with the terms of h, not with the products of
;; the degrees.
;;
;; From h modulo P to h: take residues of least magnitude, over as many primes
;; as it needs.  The primitive part of h in x divides g.  Unlucky points and
;; primes make a wrong guess, so only what divides p and q is returned.

(require racket/fixnum
         "monomial.rkt" "ring.rkt" "arithmetic.rkt" "structure.rkt" "content.rkt" "division.rkt"
         "modular.rkt" "modular-terms.rkt" "interpolation.rkt" "skeleton.rkt")

(provide sparse-divisor)

;; A common divisor of p and q, primitive, likely the greatest but for factors
;; free of one variable; or #f.
;; p, q : primitive, over `variables`, each of which their gcd may contain
;; bounds : list of bounds of its degree, one a variable
;; gcd-of : list of polynomials -> their gcd
(define (sparse-divisor R p q variables bounds gcd-of seed)
  (define x (choose-main R p q variables))
  (define lead
    (integer-gcd R (leading-coefficient-in R p x) (leading-coefficient-in R q x) gcd-of))
  (define problem
    (make-problem R p q x lead variables bounds seed))
  (let loop ([P (for/fold ([P first-prime]) ([i (in-range seed)]) (next-prime P))]
             [modulus 1] [h '()] [primes-left 60])
    (define image (and (> primes-left 0) (problem-image problem P h)))
    (define next (and image (combine-residues h modulus image P)))
    (cond [(not image) #f]
          [(and (or (equal? next h) (small? next (* modulus P)))
                (verified R p q x (lift next (* modulus P)) gcd-of))]
          [else (loop (next-prime P) (* modulus P) next (- primes-left 1))])))

;; The variable whose leading coefficients have fewest terms.
(define (choose-main R p q variables)
  (define (cost x)
    (min (poly-term-count (leading-coefficient-in R p x))
         (poly-term-count (leading-coefficient-in R q x))))
  (for/fold ([best (car variables)] [least (cost (car variables))] #:result best)
            ([x (in-list (cdr variables))])
    (define c (cost x))
    (if (< c least) (values x c) (values best least))))

;; The gcd over the integers: numeric content included.
(define (integer-gcd R p q gcd-of)
  (poly-scale R (gcd (poly-content p) (poly-content q)) (gcd-of (list p q))))

(define (leading-coefficient-in R p x) (cdar (poly-coefficients R p x)))

;; ---------------------------------------------------------------------------
;; From residues to integers

(define (small? h modulus)
  (for/and ([t (in-list h)])
    (< (* 8 (abs (symmetric (cdr t) modulus))) modulus)))

(define (lift h modulus)
  (for/list ([t (in-list h)]) (cons (car t) (symmetric (cdr t) modulus))))

;; The residues modulo modulus · P, by the Chinese remainder theorem.
(define (combine-residues h modulus image P)
  (define inverse (mod-inverse (modulo modulus P) P))
  (define (join m c d)
    (cons m (+ c (* modulus (mod* (mod- d (modulo c P) P) inverse P)))))
  (let merge ([h h] [image image])
    (cond [(and (null? h) (null? image)) '()]
          [(or (null? image) (and (pair? h) (monomial>? (caar h) (caar image))))
           (cons (join (caar h) (cdar h) 0) (merge (cdr h) image))]
          [(or (null? h) (monomial>? (caar image) (caar h)))
           (cons (join (caar image) 0 (cdar image)) (merge h (cdr image)))]
          [else
           (cons (join (caar h) (cdar h) (cdar image))
                 (merge (cdr h) (cdr image)))])))

;; The primitive part of h in x, if it divides p and q.
(define (verified R p q x h gcd-of)
  (define content (gcd-of (map cdr (poly-coefficients R h x))))
  (define-values (c g) (poly-primitive R (poly-divide R h content)))
  (and (poly-divide-integral R p g) (poly-divide-integral R q g) g))

;; ---------------------------------------------------------------------------
;; Modulo one prime

;; x : main variable; degree : that of h in x; others : the other variables;
;; other-degrees : bounds of the degrees of h in them
(struct problem (ring p q x degree lead others other-degrees seed)
  #:authentic)

(define (make-problem R p q x lead variables bounds seed)
  (define degrees (map cons variables bounds))
  (define others (filter (lambda (i) (not (eqv? i x))) variables))
  (problem R p q x (cdr (assv x degrees)) lead others
           (for/list ([i (in-list others)])
             (+ (cdr (assv i degrees)) (poly-degree R lead i)))
           seed))

;; h modulo P, or #f.  `known` is h modulo other primes, '() at first: once it
;; is there its monomials are the skeleton for all variables at once.
(define (problem-image k P known)
  (define R (problem-ring k))
  (define (residues p) (terms-mod p P))
  (define p (residues (problem-p k)))
  (define q (residues (problem-q k)))
  (define lead (residues (problem-lead k)))
  (if (null? known)
      (restore k p q lead
               (reverse (problem-others k)) (reverse (problem-other-degrees k)) P)
      (skeleton-gcd R (problem-x k) p q lead (map car known) (problem-degree k)
                    (make-point k P 1) P)))

;; h over x and the given variables, last restored first in the list.
(define (restore k p q lead variables degrees P)
  (define R (problem-ring k))
  (cond [(null? variables)
         (define x (problem-x k))
         (skeleton-gcd R x p q lead
                       (for/list ([e (in-range (+ 1 (problem-degree k)))])
                         (variable-power R x e))
                       (problem-degree k) (make-point k P 1) P)]
        [else
         (define y (car variables))
         (define alpha (sample-residue (problem-seed k) y P))
         (define first-image
           (restore k (put-mod R p y alpha P) (put-mod R q y alpha P)
                    (put-mod R lead y alpha P)
                    (cdr variables) (cdr degrees) P))
         (and first-image
              (restore-one k p q lead y alpha first-image (car degrees) P))]))

;; h with the variable y, from its image at y = alpha and more of them.
(define (restore-one k p q lead y alpha first-image degree P)
  (define R (problem-ring k))
  (define monomials (map car first-image))
  (define points
    (for/fxvector #:length (+ degree 1) ([j (in-range (+ degree 1))])
      (if (eqv? j 0) alpha (sample-residue (+ 1000 (problem-seed k)) (+ j (* 64 y)) P))))
  (define images
    (let loop ([j 1] [images (list first-image)])
      (cond [(> j degree) (reverse images)]
            [else
             (define b (fxvector-ref points j))
             (define image
               (skeleton-gcd R (problem-x k)
                             (put-mod R p y b P) (put-mod R q y b P) (put-mod R lead y b P)
                             monomials (problem-degree k) (make-point k P (+ j 1)) P))
             (and image (loop (+ j 1) (cons image images)))])))
  (and images (interpolate R y monomials points images P)))

;; Newton's interpolation of every coefficient.
(define (interpolate R y monomials points images P)
  (define tables (for/list ([image (in-list images)]) (make-hash image)))
  (define terms
    (for*/list ([m (in-list monomials)]
                [coefficients
                 (in-value
                  (newton-coefficients
                   points
                   (for/fxvector #:length (length tables) ([t (in-list tables)])
                     (hash-ref t m 0))
                   P))]
                [(c e) (in-indexed-fxvector coefficients)]
                #:unless (eq? c 0))
      (cons (monomial+ m (variable-power R y e)) c)))
  (sort terms monomial>? #:key car))

(define (in-indexed-fxvector v)
  (in-parallel (in-fxvector v) (in-naturals)))

;; The bases of the power points.
(define (make-point k P salt)
  (define point (make-fxvector (ring-size (problem-ring k)) 0))
  (for ([i (in-list (problem-others k))])
    (fxvector-set! point i (sample-residue (+ (problem-seed k) (* 17 salt)) i P)))
  point)
