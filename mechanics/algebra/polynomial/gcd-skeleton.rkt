#lang racket/base
;; A gcd modulo P when its monomials are known: the heart of Zippel's method.
;;
;; Let h = Σ cₛ s over known monomials s = xⁱ z^f, with unknown residues cₛ, and
;; z all variables but x.  At the points z = (r₁ᵗ, r₂ᵗ, ...), t = 1, 2, ...,
;; Euclid gives the univariate gcd of the images of p and q; scaled to the known
;; leading coefficient γ it is the image of h.  The coefficient of xⁱ at the t-th
;; point is Σ cₛ mₛᵗ with mₛ = r^f: power sums in the unknowns of one power of x,
;; solved by interpolation.rkt.  As many points are needed as one power of x
;; has monomials, at most.
;;
;; The same is wanted for several values of one more variable y that p, q and γ
;; have.  A *bundle* makes one polynomial ready for that: its terms without y,
;; each with its power of x and its constant m = r^f, and by powers of y the
;; coefficients.  Given y, a term has a number, and from one point to the next
;; that number is multiplied by m.

(require racket/fixnum
         racket/list
         "arithmetic.rkt" "interpolation.rkt" "modular.rkt" "modular-terms.rkt"
         "polynomial-parts.rkt"
         "monomial.rkt" "ring.rkt" "term-list.rkt")

(provide make-skeleton skeleton-terms skeleton-count skeleton-coefficients
         make-bundle)

;; ---------------------------------------------------------------------------
;; Skeletons

;; terms : group after group, a term with every monomial of h
;; groups : by decreasing power of x
;; count : how many points are needed
(struct skeleton (terms groups count)
  #:authentic)

;; The monomials with one power of x; constants : fxvector of their mₛ
(struct group (power constants)
  #:authentic)

;; From terms whose monomials are those of h.
(define (make-skeleton R x terms point P)
  (define slices (poly-coefficients R terms x))
  (define groups
    (for/list ([s (in-list slices)])
      (define members (slice-coefficient s))
      (group (slice-degree s)
             (for/fxvector #:length (length members) ([t (in-list members)])
               (monomial-value R (term-monomial t) x point P)))))
  (skeleton (append* (for/list ([s (in-list slices)])
                       (shift-terms (variable-power R x (slice-degree s))
                                    1
                                    (slice-coefficient s))))
            groups
            (for/fold ([n 0]) ([g (in-list groups)])
              (max n (fxvector-length (group-constants g))))))

;; The coefficients of h at y = value, a list in the order of the terms; or #f
;; when the images do not fit: another degree in x than expected, a power of x
;; the skeleton lacks, constants that agree.
;; p, q, lead : bundles
(define (skeleton-coefficients s p q lead value expected-degree P)
  (define groups (skeleton-groups s))
  (define count (skeleton-count s))
  (define sums (for/list ([g (in-list groups)]) (make-fxvector count 0)))
  (define next-p (bundle-images p value P))
  (define next-q (bundle-images q value P))
  (define next-lead (bundle-images lead value P))
  (and (for/and ([t (in-range count)])
         (record-image! (scaled-gcd (next-p) (next-q) (next-lead) expected-degree P)
                        expected-degree groups sums t))
       (solve groups sums P)))

;; The monic gcd of two images times the constant image, if of this degree.
(define (scaled-gcd a b c expected-degree P)
  (define-values (g degree)
    (univariate-gcd! a (univariate-degree a (fx- (fxvector-length a) 1))
                     b (univariate-degree b (fx- (fxvector-length b) 1))
                     P))
  (define lead (fxvector-ref c 0))
  (and (eqv? degree expected-degree)
       (not (eq? lead 0))
       (begin (univariate-make-leading! g degree lead P) g)))

;; Store the coefficients of an image as the t-th sums; #f when it is not there
;; or has a power of x that it should not have.
(define (record-image! g degree groups sums t)
  (let loop ([e degree] [groups groups] [sums sums])
    (cond [(not g) #f]
          [(fx< e 0) #t]
          [(and (pair? groups) (eq? e (group-power (car groups))))
           (fxvector-set! (car sums) t (fxvector-ref g e))
           (loop (fx- e 1) (cdr groups) (cdr sums))]
          [else (and (eq? 0 (fxvector-ref g e))
                     (loop (fx- e 1) groups sums))])))

(define (solve groups sums P)
  (define solved
    (for/list ([g (in-list groups)] [s (in-list sums)])
      (solve-power-sums (group-constants g) s P)))
  (and (andmap values solved)
       (for*/list ([cs (in-list solved)] [c (in-fxvector cs)]) c)))

;; ---------------------------------------------------------------------------
;; Bundles

;; exponents, constants : fxvectors by term without y; degree : in x
;; parts : list of part
(struct bundle (exponents constants degree parts)
  #:authentic)

;; The coefficients at y^power; places : fxvectors of the terms they belong to
(struct part (power places coefficients)
  #:authentic)

;; y : #f for none
(define (make-bundle R x y terms point P)
  (define slices
    (if y (poly-coefficients R terms y) (list (make-slice 0 terms))))
  (define all (union-of-monomials R (map slice-coefficient slices)))
  (define n (length all))
  (define exponents
    (for/fxvector #:length n ([m (in-list all)]) (monomial-exponent R m x)))
  (bundle exponents
          (for/fxvector #:length n ([m (in-list all)]) (monomial-value R m x point P))
          (for/fold ([d 0]) ([e (in-fxvector exponents)]) (fxmax d e))
          (for/list ([s (in-list slices)])
            (make-part (slice-degree s) (slice-coefficient s) all))))

;; All monomials of several polynomials, in decreasing order.
(define (union-of-monomials R ps)
  (define (ones p) (for/list ([t (in-list p)]) (make-term (term-monomial t) 1)))
  (map term-monomial (poly-sum R (map ones ps))))

(define (make-part power terms all)
  (define n (length terms))
  (define places (make-fxvector n))
  (for/fold ([all all] [place 0] #:result (void)) ([t (in-list terms)] [i (in-naturals)])
    (define-values (rest found)
      (let find ([all all] [place place])
        (if (monomial=? (car all) (term-monomial t))
            (values all place)
            (find (cdr all) (fx+ place 1)))))
    (fxvector-set! places i found)
    (values rest found))
  (part power places
        (for/fxvector #:length n ([t (in-list terms)]) (term-coefficient t))))

;; -> a procedure that returns, call after call, the images at the next point.
;; They share one fxvector, which the caller may destroy.
(define (bundle-images b value P)
  (define exponents (bundle-exponents b))
  (define constants (bundle-constants b))
  (define numbers (bundle-numbers b value P))
  (define image (make-fxvector (fx+ 1 (bundle-degree b)) 0))
  (lambda ()
    (for ([i (in-range (fxvector-length image))]) (fxvector-set! image i 0))
    (for ([i (in-range (fxvector-length numbers))])
      (define v (mod* (fxvector-ref numbers i) (fxvector-ref constants i) P))
      (define e (fxvector-ref exponents i))
      (fxvector-set! numbers i v)
      (fxvector-set! image e (mod+ (fxvector-ref image e) v P)))
    image))

;; The terms' coefficients at y = value.
(define (bundle-numbers b value P)
  (define numbers (make-fxvector (fxvector-length (bundle-exponents b)) 0))
  (for ([k (in-list (bundle-parts b))])
    (define power (mod-expt value (part-power k) P))
    (for ([place (in-fxvector (part-places k))] [c (in-fxvector (part-coefficients k))])
      (fxvector-set! numbers place
                     (fxremainder (fx+ (fxvector-ref numbers place) (fx* c power)) P))))
  numbers)
