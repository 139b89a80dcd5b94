#lang racket/base
;; A gcd modulo P when its monomials are known: the heart of Zippel's method.
;;
;; Let h = Σ cₛ s over known monomials s = xⁱ y^f, with unknown residues cₛ.  At
;; the points y = (r₁ᵗ, r₂ᵗ, ...), t = 1, 2, ..., Euclid gives the univariate
;; gcd of the images of p and q, and scaled to the known leading coefficient
;; γ(y) it is the image of h.  The coefficient of xⁱ at the t-th point is
;; Σ cₛ mₛᵗ with mₛ = r^f: power sums in the unknowns of one power of x, solved
;; by interpolation.rkt.  As many points are needed as one power of x has
;; monomials, at most.
;;
;; The value of a term at the next point is its value at this one times its own
;; constant: a *track* holds these two numbers for all terms of a polynomial.

(require racket/fixnum "monomial.rkt" "ring.rkt" "modular.rkt" "modular-terms.rkt" "interpolation.rkt")

(provide skeleton-gcd)

;; The polynomial h modulo P, or #f when the images do not fit: another degree
;; in x than expected, a power of x the skeleton lacks, points that agree.
;; p, q, lead : terms modulo P; monomials : those of h
(define (skeleton-gcd R x p q lead monomials expected-degree point P)
  (define powers (group-by-power R x monomials))
  (define count (for/fold ([n 0]) ([g (in-list powers)]) (max n (length (cdr g)))))
  (define p-track (make-track R x p point P))
  (define q-track (make-track R x q point P))
  (define lead-track (make-track R x lead point P))
  (define sums
    (for/list ([g (in-list powers)]) (make-fxvector count 0)))
  (and (for/and ([t (in-range count)])
         (define-values (a a-degree) (next-image! p-track P))
         (define-values (b b-degree) (next-image! q-track P))
         (define-values (c c-degree) (next-image! lead-track P))
         (define-values (g degree) (univariate-gcd! a a-degree b b-degree P))
         (and (eqv? degree expected-degree)
              (eq? c-degree 0)
              (begin (univariate-make-leading! g degree (fxvector-ref c 0) P) #t)
              (record-image! g degree powers sums t)))
       (solve R x powers sums point P)))

;; ((power of x . monomials) ...) by decreasing power
(define (group-by-power R x monomials)
  (define table (make-hasheqv))
  (for ([m (in-list monomials)])
    (define e (monomial-exponent R m x))
    (hash-set! table e (cons m (hash-ref table e '()))))
  (for/list ([e (in-list (sort (hash-keys table) >))])
    (cons e (hash-ref table e))))

;; Store the coefficients of an image as the t-th sums; #f when it has a power
;; of x that should not be there.
(define (record-image! g degree powers sums t)
  (let loop ([e degree] [powers powers] [sums sums])
    (cond [(fx< e 0) #t]
          [(and (pair? powers) (eq? e (caar powers)))
           (fxvector-set! (car sums) t (fxvector-ref g e))
           (loop (fx- e 1) (cdr powers) (cdr sums))]
          [else (and (eq? 0 (fxvector-ref g e))
                     (loop (fx- e 1) powers sums))])))

(define (solve R x powers sums point P)
  (define solved
    (for/list ([g (in-list powers)] [s (in-list sums)])
      (define ms
        (for/fxvector #:length (length (cdr g)) ([m (in-list (cdr g))])
          (monomial-value R m x point P)))
      (define cs (solve-power-sums ms s P))
      (and cs
           (for/list ([m (in-list (cdr g))] [c (in-fxvector cs)] #:unless (eq? c 0))
             (cons m c)))))
  (and (andmap values solved)
       (sort (apply append solved) monomial>? #:key car)))

;; ---------------------------------------------------------------------------
;; Tracks

;; exponents : power of x of every term; values, factors : fxvectors;
;; image : scratch as long as the degree in x asks
(struct track (exponents values factors image)
  #:authentic)

(define (make-track R x terms point P)
  (define n (length terms))
  (define exponents
    (for/fxvector #:length n ([t (in-list terms)]) (monomial-exponent R (car t) x)))
  (define factors
    (for/fxvector #:length n ([t (in-list terms)]) (monomial-value R (car t) x point P)))
  (define values
    (for/fxvector #:length n ([t (in-list terms)]) (cdr t)))
  (define degree (for/fold ([d 0]) ([e (in-fxvector exponents)]) (fxmax d e)))
  (track exponents values factors (make-fxvector (fx+ degree 1) 0)))

;; -> image degree.  Moves to the next point; the image is overwritten by the
;; next call.
(define (next-image! k P)
  (define exponents (track-exponents k))
  (define values* (track-values k))
  (define factors (track-factors k))
  (define image (track-image k))
  (for ([i (in-range (fxvector-length image))]) (fxvector-set! image i 0))
  (for ([i (in-range (fxvector-length values*))])
    (define v (mod* (fxvector-ref values* i) (fxvector-ref factors i) P))
    (define e (fxvector-ref exponents i))
    (fxvector-set! values* i v)
    (fxvector-set! image e (mod+ (fxvector-ref image e) v P)))
  (values image (univariate-degree image (fx- (fxvector-length image) 1))))
