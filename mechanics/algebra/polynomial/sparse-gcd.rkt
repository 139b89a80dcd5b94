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
;; coefficients are to be found (gcd-skeleton.rkt), and Newton's interpolation in yⱼ
;; restores it.  The work grows with the terms of h, not with the products of
;; the degrees.
;;
;; From h modulo P to h: take residues of least magnitude, over as many primes
;; as it needs.  The primitive part of h in x divides g.  Unlucky points and
;; primes make a wrong guess, so only a divisor of p and q is returned.

(require racket/fixnum
         (only-in racket/list argmin)
         "arithmetic.rkt" "content.rkt" "division.rkt" "interpolation.rkt" "polynomial-parts.rkt"
         "modular-terms.rkt" "modular.rkt" "monomial.rkt" "ring.rkt" "gcd-skeleton.rkt"
         "term-list.rkt")

(provide sparse-divisor)

;; A common divisor of p and q, primitive, likely the greatest but for factors
;; free of one variable; or #f.
;; p, q : primitive, over `variables`, each of which their gcd may contain
;; bounds : list of bounds of its degree, one a variable
;; gcd-of : list of polynomials -> their gcd
(define (sparse-divisor R p q variables bounds gcd-of seed)
  (define x (choose-main R p q variables))
  (define lead
    (integer-gcd R
                 (poly-leading-coefficient-in R p x) (poly-leading-coefficient-in R q x)
                 gcd-of))
  (define problem
    (make-problem R p q x lead variables bounds seed))
  (lift-over-primes problem
                    (nth-prime seed)
                    (lambda (h modulus) (verified R p q x (lift h modulus) gcd-of))))

;; A greater coefficient than this many primes tell is given up.
(define most-primes 400)

;; The first divisor that images of h modulo more and more primes give, tried
;; when the coefficients look small or stay the same; or #f.
(define (lift-over-primes problem P divisor)
  (let loop ([P P] [modulus 1] [h '()] [left most-primes])
    (define image (problem-image problem P h))
    (define next (and image (combine-residues h modulus image P)))
    (define product (* modulus P))
    (cond [(eqv? left 0) #f]
          [(not image)                      ; an unlucky prime, unless the first
           (and (pair? h) (loop (next-prime P) modulus h (- left 1)))]
          [(equal? next h) (divisor h modulus)]
          [(and (small? next product) (divisor next product))]
          [else (loop (next-prime P) product next (- left 1))])))

;; The variable whose leading coefficients have fewest terms.
(define (choose-main R p q variables)
  (define (cost x)
    (min (length (poly-leading-coefficient-in R p x))
         (length (poly-leading-coefficient-in R q x))))
  (argmin cost variables))

;; The gcd over the integers: numeric content included.
(define (integer-gcd R p q gcd-of)
  (poly-scale R (gcd (poly-content p) (poly-content q)) (gcd-of (list p q))))

;; ---------------------------------------------------------------------------
;; From residues to integers

(define (small? h modulus)
  (for/and ([t (in-list h)])
    (< (* 8 (abs (symmetric-residue (term-coefficient t) modulus))) modulus)))

(define (lift h modulus)
  (for/list ([t (in-list h)])
    (make-term (term-monomial t) (symmetric-residue (term-coefficient t) modulus))))

;; The residues modulo modulus · P, by the Chinese remainder theorem.
(define (combine-residues h modulus image P)
  (define inverse (mod-inverse (modulo modulus P) P))
  (define (join m c d)
    (make-term m (+ c (* modulus (mod* (mod- d (modulo c P) P) inverse P)))))
  (define (before? p q)
    (or (null? q) (and (pair? p) (monomial>? (leading-monomial p) (leading-monomial q)))))
  (let merge ([h h] [image image])
    (cond [(and (null? h) (null? image)) '()]
          [(before? h image)
           (cons (join (leading-monomial h) (leading-coefficient h) 0)
                 (merge (cdr h) image))]
          [(before? image h)
           (cons (join (leading-monomial image) 0 (leading-coefficient image))
                 (merge h (cdr image)))]
          [else
           (cons (join (leading-monomial h) (leading-coefficient h) (leading-coefficient image))
                 (merge (cdr h) (cdr image)))])))

;; The primitive part of h in x, if it divides p and q.
(define (verified R p q x h gcd-of)
  (define content (gcd-of (map slice-coefficient (poly-coefficients R h x))))
  (define g (poly-primitive-part R (poly-divide R h content)))
  (and (poly-divide-integral R p g) (poly-divide-integral R q g) g))

;; ---------------------------------------------------------------------------
;; Modulo one prime

;; x : main variable; degree : that of h in x; others : the other variables;
;; other-degrees : bounds of the degrees of h in them
(struct problem (ring p q x degree lead others other-degrees seed)
  #:authentic)

(define (make-problem R p q x lead variables bounds seed)
  (define degrees (map cons variables bounds))
  (define others (remv x variables))
  (problem R p q x (cdr (assv x degrees)) lead others
           (for/list ([i (in-list others)])
             (+ (cdr (assv i degrees)) (poly-degree R lead i)))
           seed))

;; h modulo P, or #f.  `known` is h modulo other primes, '() at first: once it
;; is there its monomials are the skeleton for all variables at once.
(define (problem-image k P known)
  (define p (terms-mod (problem-p k) P))
  (define q (terms-mod (problem-q k) P))
  (define lead (terms-mod (problem-lead k) P))
  (if (null? known)
      (restore k p q lead
               (reverse (problem-others k)) (reverse (problem-other-degrees k)) P)
      (image-over k p q lead known P)))

;; h over x and the given variables; the first is the last to be restored.
(define (restore k p q lead variables degrees P)
  (cond [(null? variables) (image-over k p q lead (all-powers k) P)]
        [else
         (define y (car variables))
         (define alpha (sample-residue (problem-seed k) y P))
         (define (put p) (put-mod (problem-ring k) p y alpha P))
         (define image
           (restore k (put p) (put q) (put lead) (cdr variables) (cdr degrees) P))
         (and image
              (restore-one k p q lead y alpha image (car degrees) P))]))

;; Terms with all powers of x that h may have.
(define (all-powers k)
  (for/list ([e (in-range (problem-degree k) -1 -1)])
    (make-term (variable-power (problem-ring k) (problem-x k) e) 1)))

;; h when its monomials are those of `known`.
(define (image-over k p q lead known P)
  (define-values (s coefficients-at) (prepare k p q lead #f known P))
  (define coefficients (coefficients-at 0))
  (and coefficients
       (sort-terms (for/list ([t (in-list (skeleton-terms s))]
                              [c (in-list coefficients)]
                              #:unless (eq? c 0))
                     (make-term (term-monomial t) c)))))

;; h with the variable y, from its image at y = alpha and more of them.
(define (restore-one k p q lead y alpha image degree P)
  (define-values (s coefficients-at) (prepare k p q lead y image P))
  (define points
    (for/list ([j (in-range degree)])
      (sample-residue (+ 1000 (problem-seed k)) (+ j (* 64 y)) P)))
  (define images
    (let/ec return
      (for/list ([y (in-list points)]) (or (coefficients-at y) (return #f)))))
  (and images
       (interpolate (problem-ring k) y (skeleton-terms s) (cons alpha points)
                    (cons (map term-coefficient (skeleton-terms s)) images)
                    P)))

;; -> skeleton, and a procedure from values of y to the coefficients there.
(define (prepare k p q lead y known P)
  (define R (problem-ring k))
  (define x (problem-x k))
  (define point (make-point k P))
  (define s (make-skeleton R x known point P))
  (define cost (+ (length p) (length q) (length lead)))
  (define (bundle p) (make-bundle R x y p point P))
  (define-values (p* q* lead*) (values (bundle p) (bundle q) (bundle lead)))
  (values s
          (lambda (value)
            (charge! R (* cost (skeleton-count s)))
            (skeleton-coefficients s p* q* lead* value (problem-degree k) P))))

;; The bases of the power points.
(define (make-point k P)
  (define point (make-fxvector (ring-size (problem-ring k)) 0))
  (for ([i (in-list (problem-others k))])
    (fxvector-set! point i (sample-residue (+ 500 (problem-seed k)) i P)))
  point)

;; Newton's interpolation in y of every coefficient.
;; images : one a point, lists of coefficients in the order of the terms
(define (interpolate R y terms points images P)
  (define coefficients-of (make-newton points P))
  (sort-terms
   (for*/list ([(t values) (in-parallel terms (apply map list images))]
               [(c e) (in-parallel (in-fxvector (coefficients-of values)) (in-naturals))]
               #:unless (eq? c 0))
     (make-term (monomial+ (term-monomial t) (variable-power R y e)) c))))

(define (sort-terms terms) (sort terms monomial>? #:key term-monomial))
