#lang racket/base
;; Operations on residues, for fingerprints: the value of an item in
;; GF(p) if those of its operands are known.  See fingerprint.rkt for the theory.
;;
;; Every procedure gives #f where there is no value: for a division by zero and
;; for the root of a number that is no square.

(require racket/fixnum
         (only-in racket/list index-of)
         "../expression/operation.rkt"
         "../polynomial/modular.rkt")

(provide make-site site-values mix exponential
         site-symbol site-pi site-number site-application site-operation)

;; prime, values : of this level, values by places on the tape
;; seed : of the random residues; squares? : are those squares?
;; exponents, angles : values at the levels below, or #f
;; exponential, circle : powers with exponents 2^k of a generator, or #f
;; order : of the exponential generator
;; turned, point : the place of the last angle, and the point of the circle for
;; it: sine and cosine mostly come together
(struct site (prime values seed squares? exponents order exponential angles circle
                    [turned #:mutable] [point #:mutable])
  #:authentic)

;; n places; q, r : primes of the levels of exponents and angles
(define (make-site p seed squares? n q exponents r angles)
  (site p (make-fxvector n 0) seed squares?
        exponents q (and q (exponential-powers p q))
        angles (and r (circle-powers p r))
        #f #f))

(define-syntax-rule (value s k) (fxvector-ref (site-values s) k))

;; ---------------------------------------------------------------------------
;; Random residues

(define modulus 1073741789)

;; A number below 2^30 that depends irregularly on both.
(define (mix state x)
  (define (scramble y)
    (define z (fxremainder (fx+ (fx* (fxremainder y modulus) 741103597) 362436069) modulus))
    (fxxor z (fxrshift z 13)))
  (scramble (fxxor (scramble (fx+ state x)) 466882153)))

;; Squares stand for positive numbers: they have roots.
(define (random-residue s x)
  (define p (site-prime s))
  (define r (fxmax 2 (fxremainder x p)))
  (if (site-squares? s) (mod* r r p) r))

(define (site-symbol s k) (random-residue s (mix (site-seed s) k)))

;; m π, for a rational m: a residue that no place has
(define (site-pi s m)
  (mod* (residue m (site-prime s)) (site-symbol s -2) (site-prime s)))

(define (site-application s head operands)
  (random-residue s (mix-values s head operands)))

(define (mix-values s head operands)
  (for/fold ([state (mix (mix (site-seed s) -1) head)]) ([k (in-list operands)])
    (mix state (value s k))))

;; ---------------------------------------------------------------------------
;; Arithmetic

(define (site-number s c)
  (define p (site-prime s))
  (cond [(fixnum? c) (fxmodulo c p)]
        [else
         (define x (inexact->exact c))
         (and (not (eqv? 0 (modulo (denominator x) p)))
              (residue x p))]))

(define (site-operation s op items operands)
  (define p (site-prime s))
  (define (one) (value s (car operands)))
  (define (two) (value s (cadr operands)))
  (cond [(eq? op op:+) (sum s p operands)]
        [(eq? op op:*) (product s p operands)]
        [(eq? op op:-) (mod- (one) (two) p)]
        [(eq? op op:/) (quotient-residue (one) (two) p)]
        [(eq? op op:expt) (general-power s p items operands)]
        [(eq? op op:sqrt) (rational-power (one) 1/2 p)]
        [(eq? op op:abs) (if (square? (one) p) (one) (mod- 0 (one) p))]
        [(memq op circular-functions) (circular-value s p op (car operands))]
        [(memq op exponential) (exponential-value s p op (car operands))]
        [else (unknown s op operands)]))

(define exponential (cons op:exp (operations-where hyperbolic)))

(define (sum s p operands)
  (for/fold ([total 0]) ([k (in-list operands)]) (mod+ total (value s k) p)))

(define (product s p operands)
  (for/fold ([total 1]) ([k (in-list operands)]) (mod* total (value s k) p)))

(define (quotient-residue x y p)
  (and (not (eqv? y 0)) (mod* x (mod-inverse y p) p)))

;; An operation taken for an unknown function.
(define (unknown s op operands)
  (fxremainder (mix-values s (operation-number op) operands) (site-prime s)))

(define (operation-number op) (index-of numbered-operations op eq?))
(define numbered-operations
  (append (list op:up op:down) operations (list op:solution op:component op:wrapped)))

;; ---------------------------------------------------------------------------
;; Powers

(define (general-power s p items operands)
  (define base (value s (car operands)))
  (define n (vector-ref items (cadr operands)))
  (cond [(number? n) (rational-power base (inexact->exact n) p)]
        [(site-order s) (symbolic-power s p base (fxvector-ref (site-exponents s) (cadr operands)))]
        [else (unknown s op:expt operands)]))

;; Defined on the subgroup whose order is the prime of the exponents.
(define (symbolic-power s p base n)
  (and (eqv? 1 (mod-expt base (site-order s) p))
       (mod-expt base n p)))

(define (rational-power x n p)
  (cond [(eqv? n 0) 1]
        [(eqv? x 0) (and (positive? n) 0)]
        [(integer? n) (mod-expt x (modulo n (- p 1)) p)]
        [(square? x p) (root-of-square x n p)]
        [(odd? (denominator n))
         (define y (root-of-square (- p x) n p))
         (and y (if (odd? (numerator n)) (- p y) y))]
        [else #f]))

;; The squares are a group of odd order.
(define (root-of-square x n p)
  (define order (quotient p 2))
  (and (eqv? 1 (gcd (denominator n) order))
       (mod-expt x (residue n order) p)))

(define (square? x p)
  (or (eqv? x 0) (eqv? 1 (mod-expt x (quotient p 2) p))))

;; ---------------------------------------------------------------------------
;; Exponentials

(define (exponential-value s p op k)
  (define up
    (if (site-exponential s)
        (power-from (site-exponential s) (fxvector-ref (site-exponents s) k) 1
                    (lambda (x y) (mod* x y p)))
        (unknown-exponential s p k)))
  (define (down) (mod-inverse up p))
  (cond [(eqv? up 0) #f]
        [(eq? op op:exp) up]
        [(eq? op op:sinh) (half (mod- up (down) p) p)]
        [(eq? op op:cosh) (half (mod+ up (down) p) p)]
        [else (quotient-residue (mod- up (down) p) (mod+ up (down) p) p)]))

(define (half x p) (if (even? x) (fxrshift x 1) (fxrshift (fx+ x p) 1)))

;; 2^(2(p-1)/q) has the order q.
(define (exponential-powers p q)
  (define g (mod-expt 4 (quotient (quotient (- p 1) 2) q) p))
  (build-powers g q (lambda (x) (mod* x x p))))

;; Powers of x with exponents 1, 2, 4 ... below q.
(define (build-powers x q square)
  (define n (integer-length q))
  (define powers (make-vector n x))
  (for ([k (in-range 1 n)])
    (vector-set! powers k (square (vector-ref powers (- k 1)))))
  powers)

;; The n-th power, from those of build-powers.
(define (power-from powers n one times)
  (let loop ([n n] [k 0] [x one])
    (cond [(fx= n 0) x]
          [(fx= 0 (fxand n 1)) (loop (fxrshift n 1) (fx+ k 1) x)]
          [else (loop (fxrshift n 1) (fx+ k 1) (times x (vector-ref powers k)))])))

;; Still exp(u) exp(-u) = 1.
(define (unknown-exponential s p k)
  (define-values (x negative?) (unknown-of-magnitude s op:exp p k))
  (cond [(eqv? (value s k) 0) 1]
        [negative? (mod-inverse x p)]
        [else x]))

;; Some residue for u and -u; is it u that counts as negative?
(define (unknown-of-magnitude s op p k)
  (define u (value s k))
  (define negative? (fx> u (fxrshift p 1)))
  (define state (mix (mix (mix (site-seed s) -1) (operation-number op))
                     (if negative? (fx- p u) u)))
  (values (fxmax 2 (fxremainder state p)) negative?))

;; ---------------------------------------------------------------------------
;; Circular functions

;; A point of the circle is (cosine . sine).
(define (circular-value s p op k)
  (unless (eqv? k (site-turned s))
    (set-site-turned! s k)
    (set-site-point! s (circle-point s p k)))
  (define point (site-point s))
  (cond [(eq? op op:sin) (cdr point)]
        [(eq? op op:cos) (car point)]
        [else (quotient-residue (cdr point) (car point) p)]))

(define (circle-point s p k)
  (if (site-circle s)
      (turn-from (site-circle s) (fxvector-ref (site-angles s) k) p)
      (unknown-turn s p k)))

(define (turn a b p)
  (cons (mod- (mod* (car a) (car b) p) (mod* (cdr a) (cdr b) p) p)
        (mod+ (mod* (car a) (cdr b) p) (mod* (cdr a) (car b) p) p)))

;; ((1 - t²)/(1 + t²), 2t/(1 + t²)); 1 + t² is not 0, for p ≡ 3 (mod 4).
(define (rational-point t p)
  (define square (mod* t t p))
  (define inverse (mod-inverse (mod+ 1 square p) p))
  (cons (mod* (mod- 1 square p) inverse p)
        (mod* (mod* 2 t p) inverse p)))

(define (circle-powers p r)
  (define (double a) (turn a a p))
  (define cofactor (quotient (+ p 1) r))
  (define g
    (for/or ([t (in-naturals 2)])
      (define a (rational-point t p))
      (define b (turn-from (build-powers a (+ cofactor 1) double) cofactor p))
      (and (not (eqv? 0 (cdr b))) b)))
  (build-powers g r double))

(define (turn-from powers n p)
  (power-from powers n '(1 . 0) (lambda (a b) (turn a b p))))

;; Still the cosine is even, the sine odd.
(define (unknown-turn s p k)
  (define-values (t negative?) (unknown-of-magnitude s op:sin p k))
  (cond [(eqv? (value s k) 0) '(1 . 0)]
        [else (rational-point (if negative? (- p t) t) p)]))
