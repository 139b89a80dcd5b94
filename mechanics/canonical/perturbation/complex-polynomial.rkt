#lang racket/base
;; Polynomials in the variables x and y of each of n modes in which the quadratic terms are Σ c x y:
;; of an oscillator z = q + i p and w = q − i p, of a saddle q and p themselves, and of two
;; coordinates with four complex exponents q₁ ± i q₂ and p₁ ∓ i p₂.  With κ = {x, y}, which is −2i,
;; 1 and 2,
;;
;;     {f, g} = Σ κ (∂f/∂x ∂g/∂y − ∂f/∂y ∂g/∂x),     {c x y, xᵃ yᵇ} = κ c (b − a) xᵃ yᵇ:
;;
;; monomials are the eigenvectors of the homological equation.
;;
;; A polynomial is a hash of coefficients by exponents; these are packed into one integer, 6 bits
;; for each variable, x₁ … xₙ y₁ … yₙ, so that a product of monomials is a sum of integers.

(require (only-in racket/list split-at)
         "../../generic/arithmetic.rkt" "../../generic/elementary.rkt")

(provide most-degree make-modes (struct-out modes) mode-count
         polynomial-sum polynomial-scale polynomial-product polynomial-bracket majorant-bracket
         unit-key key-exponents real-variable polynomial->expression exponent-differences)

(define bits 6)
(define most-degree 63)

;; frequencies : ω of each mode, by which {H₂, xᵃ yᵇ} = i ω (a − b) xᵃ yᵇ
;; brackets : a vector of the κ
;; complex : for each of x₁ … yₙ the alist of (index . factor) that it is in q₁ … pₙ
;; real : for each of q₁ … pₙ the same in x₁ … yₙ
(struct modes (frequencies brackets complex real) #:authentic)
(define (mode-count m) (length (modes-frequencies m)))

;; blocks : lists of the coordinates of each
(define (make-modes frequencies blocks)
  (define n (length frequencies))
  (define-values (brackets complex real)
    (values (make-vector n 0) (make-vector (* 2 n) '()) (make-vector (* 2 n) '())))
  (for ([js (in-list blocks)])
    (define-values (j k) (values (car js) (if (null? (cdr js)) #f (cadr js))))
    (define (pair! u v i* u* v*)        ; complex u, v = real u* ± i* v*
      (vector-set! complex u (list (cons u* 1) (cons v* i*)))
      (vector-set! complex v (list (cons u* 1) (cons v* (- i*))))
      (vector-set! real u* (list (cons u 1/2) (cons v 1/2)))
      (vector-set! real v* (list (cons u (/ 1/2 i*)) (cons v (/ -1/2 i*)))))
    (cond [k (pair! j k 0+1i j k)
             (pair! (+ n j) (+ n k) 0-1i (+ n j) (+ n k))
             (vector-set! brackets j 2)
             (vector-set! brackets k 2)]
          [(real? (list-ref frequencies j))
           (pair! j (+ n j) 0+1i j (+ n j))
           (vector-set! brackets j 0-2i)]
          [else
           (for* ([v (list complex real)] [u (list j (+ n j))]) (vector-set! v u (list (cons u 1))))
           (vector-set! brackets j 1)]))
  (modes frequencies brackets complex real))

;; ---------------------------------------------------------------------------
;; Arithmetic

(define (unit-key k) (arithmetic-shift 1 (* bits k)))
(define (exponent key k) (bitwise-and (arithmetic-shift key (- (* bits k))) most-degree))
(define (key-exponents key n) (for/list ([k (in-range (* 2 n))]) (exponent key k)))

(define (add-term! p key c)
  (define sum (+ c (hash-ref p key 0)))
  (if (eqv? sum 0) (hash-remove! p key) (hash-set! p key sum)))

(define (polynomial-sum f g)
  (define p (hash-copy f))
  (for ([(e c) (in-hash g)]) (add-term! p e c))
  p)

(define (polynomial-scale c f)
  (define p (make-hasheqv))
  (unless (eqv? c 0) (for ([(e d) (in-hash f)]) (hash-set! p e (* c d))))
  p)

(define (polynomial-product f g)
  (define p (make-hasheqv))
  (for* ([(d c1) (in-hash f)] [(e c2) (in-hash g)]) (add-term! p (+ d e) (* c1 c2)))
  p)

;; {f, g}
(define (polynomial-bracket m)
  (define kappas (modes-brackets m))
  (bracket-of m (lambda (j a b a1 b1) (* (vector-ref kappas j) (- (* a b1) (* b a1))))))

;; Of polynomials of magnitudes: a bound on the sum of a bracket's terms
(define (majorant-bracket m)
  (define kappas (modes-brackets m))
  (bracket-of m (lambda (j a b a1 b1)
                  (* (magnitude (vector-ref kappas j)) (+ (* a b1) (* b a1))))))

;; factor : of the mode and the exponents of x and y in both
(define ((bracket-of m factor) f g)
  (define n (mode-count m))
  (define p (make-hasheqv))
  (define lowering (for/vector ([j (in-range n)]) (+ (unit-key j) (unit-key (+ n j)))))
  (for* ([(d c1) (in-hash f)] [(e c2) (in-hash g)])
    (define c (* c1 c2))
    (for ([j (in-range n)])
      (define k (factor j (exponent d j) (exponent d (+ n j)) (exponent e j) (exponent e (+ n j))))
      (unless (eqv? k 0) (add-term! p (- (+ d e) (vector-ref lowering j)) (* k c)))))
  p)

;; a − b for the exponents a of the x and b of the y
(define (exponent-differences key n)
  (define-values (a b) (split-at (key-exponents key n) n))
  (map - a b))

;; ---------------------------------------------------------------------------
;; Real variables

;; That of index k among q₁ … pₙ
(define (real-variable m k) (linear (vector-ref (modes-real m) k)))

(define (linear terms)
  (make-hasheqv (for/list ([t (in-list terms)]) (cons (unit-key (car t)) (cdr t)))))

;; Of a real polynomial, at values of q₁ … pₙ: the coefficients that the binomial theorem gives, so
;; that nothing complex is left; rounding beside the greatest of them is dropped.
(define (polynomial->expression m f values)
  (define found (in-q-and-p m f))
  (define small (* 1e-15 (apply max 0 (map magnitude (hash-values found)))))
  (apply g:+
         (for*/list ([key (in-list (sort (hash-keys found) <))]
                     [c (in-value (real-part (hash-ref found key)))]
                     #:unless (and (inexact? c) (<= (abs c) small)))
           (for/fold ([product c])
                     ([x (in-list values)] [k (in-list (key-exponents key (mode-count m)))]
                                           #:unless (zero? k))
             (g:* product (g:expt x k))))))

(define (in-q-and-p m f)
  (define n (mode-count m))
  (for/fold ([total (make-hasheqv)]) ([(key c) (in-hash f)])
    (polynomial-sum
     total
     (for*/fold ([product (make-hasheqv (list (cons 0 c)))])
                ([(terms k) (in-parallel (modes-complex m) (key-exponents key n))] [_ (in-range k)])
       (polynomial-product product (linear terms))))))
