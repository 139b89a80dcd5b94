#lang racket/base
;; Sums of roots of rational numbers, such as 1/2 + 3 √2 - ∛12, in normal form.
;;
;; A *radical* is a product of powers of primes whose exponents lie between 0 and 1: √6 is
;; 2^(1/2) 3^(1/2).  Different radicals are linearly independent over the rational numbers
;; (Besicovitch 1940), so a sum of them is zero only if each of its coefficients is, and two
;; sums are equal only if they have the same terms.  Nothing has to be searched for.
;;
;; A sum is a hash from radicals, ((prime . exponent) ...) with ascending primes, to their
;; coefficients, which are rational and not zero.

(require "../expression/exact-numbers.rkt")

(provide rational->radicals radicals->rational root-of-term
         radicals-add radicals-subtract radicals-scale radicals-multiply radicals-invert
         radicals-primes radical-slices
         radicals->flonum radicals-small? radicals-fold)

(define (rational->radicals c) (add-term (hash) '() c))

;; -> the number that the sum is, or #f if it is irrational
(define (radicals->rational s)
  (case (hash-count s)
    [(0) 0]
    [(1) (hash-ref s '() #f)]
    [else #f]))

;; c : a positive rational;  q : rational
;; -> (c radical)^q, or #f where the prime factors of c are not known
(define (root-of-term c radical q)
  (define factors (number-factors c))
  (and (andmap (lambda (f) (<= (car f) largest-known-prime)) factors)
       (power-product (for/list ([f (in-list (merge factors radical))])
                        (cons (car f) (* q (cdr f)))))))

;; The factor that number-factors leaves is a prime up to this bound.
(define largest-known-prime 1000000)

;; powers : ((prime . rational exponent) ...) with ascending primes -> a sum of one term
(define (power-product powers)
  (define radical
    (for*/list ([f (in-list powers)]
                [e (in-value (- (cdr f) (floor (cdr f))))]
                #:unless (eqv? e 0))
      (cons (car f) e)))
  (hash radical (for/product ([f (in-list powers)]) (expt (car f) (floor (cdr f))))))

;; s, with its roots √2, ∛5 made by (root 2 1/2), (root 5 1/3), and these combined by add and
;; multiply, in an order that is always the same
(define (radicals-fold s root add multiply)
  (for/fold ([sum 0]) ([radical (in-list (sort (hash-keys s) radical<?))])
    (define product
      (for/fold ([product (hash-ref s radical)]) ([group (in-list (by-exponent radical))])
        (multiply product (root (cdr group) (car group)))))
    (add sum product)))

;; ((exponent . product of the primes with that exponent) ...)
(define (by-exponent radical)
  (for/fold ([groups '()]) ([f (in-list radical)])
    (define same (assv (cdr f) groups))
    (cons (cons (cdr f) (* (car f) (if same (cdr same) 1))) (remq same groups))))

(define (radical<? f g)
  (define (size radical) (for/sum ([f (in-list radical)]) (* (car f) (cdr f))))
  (define-values (m n) (values (size f) (size g)))
  (or (< m n) (and (= m n) (< (length f) (length g)))))

;; ---------------------------------------------------------------------------
;; Sums and products

(define (radicals-add s t)
  (for/fold ([sum s]) ([(radical c) (in-hash t)]) (add-term sum radical c)))

(define (add-term s radical c)
  (define sum (+ c (hash-ref s radical 0)))
  (if (eqv? sum 0) (hash-remove s radical) (hash-set s radical sum)))

(define (radicals-subtract s t) (radicals-add s (radicals-scale -1 t)))

(define (radicals-scale c s) (radicals-multiply (rational->radicals c) s))

(define (radicals-multiply s t)
  (for*/fold ([product (hash)]) ([(f a) (in-hash s)] [(g b) (in-hash t)])
    (for/fold ([product product]) ([(radical c) (in-hash (power-product (merge f g)))])
      (add-term product radical (* a b c)))))

;; The exponents of both, added.
(define (merge f g)
  (cond [(null? f) g]
        [(null? g) f]
        [(< (caar f) (caar g)) (cons (car f) (merge (cdr f) g))]
        [(< (caar g) (caar f)) (cons (car g) (merge f (cdr g)))]
        [else (cons (cons (caar f) (+ (cdar f) (cdar g))) (merge (cdr f) (cdr g)))]))

;; ---------------------------------------------------------------------------
;; Quotients

;; -> 1/s, or #f.  Of a single term the exponents change sign.  If a prime stands in s to one
;; fractional power only, s is a + w, where its exponent in w is a fraction with some
;; denominator m, and
;;
;;     (a + w) Σ a^(m-1-i) (-w)^i = a^m - (-w)^m
;;
;; has one prime less.  Square roots are always so; 1 + ∛2 + ∛4 is not.
(define (radicals-invert s)
  (define-values (a w m) (two-slices s))
  (cond [(= 1 (hash-count s)) (invert-term s)]
        [(and w (<= m most-factors))
         (define-values (conjugate norm) (conjugate-and-norm a (radicals-scale -1 w) m))
         (define inverse (and (radicals-small? norm) (radicals-invert norm)))
         (and inverse (radicals-multiply conjugate inverse))]
        [else #f]))

(define most-factors 8)

(define (invert-term s)
  (for/first ([(radical c) (in-hash s)])
    (radicals-scale (/ 1 c) (power-product (for/list ([f (in-list radical)])
                                             (cons (car f) (- (cdr f))))))))

;; -> a, w and m; or #f, three times
(define (two-slices s)
  (define found
    (for*/or ([p (in-list (radicals-primes s))]
              [slices (in-value (radical-slices s p))])
      (define fractional (hash-keys (hash-remove slices 0)))
      (and (null? (cdr fractional))
           (list (hash-ref slices 0 (hash)) (hash-ref slices (car fractional))
                 (denominator (car fractional))))))
  (apply values (or found '(#f #f #f))))

;; v : -w  -> Σ a^(m-1-i) v^i and a^m - v^m
(define (conjugate-and-norm a v m)
  (define one (rational->radicals 1))
  (define-values (conjugate a^m v^m)
    (for/fold ([sum (hash)] [a^i one] [v^i one]) ([_ (in-range m)])
      (values (radicals-add (radicals-multiply sum a) v^i)
              (radicals-multiply a^i a)
              (radicals-multiply v^i v))))
  (values conjugate (radicals-subtract a^m v^m)))

;; The primes under a root, ascending.
(define (radicals-primes s)
  (sort (hash-keys (for*/hash ([radical (in-hash-keys s)] [f (in-list radical)])
                     (values (car f) #t)))
        <))

;; s by the exponents of p: a hash from exponents to sums
(define (radical-slices s p)
  (for/fold ([slices (hash)]) ([(radical c) (in-hash s)])
    (define f (assv p radical))
    (hash-update slices (if f (cdr f) 0) (lambda (slice) (hash-set slice radical c)) (hash))))

;; ---------------------------------------------------------------------------
;; Size and value

;; Is the sum worth to be kept exactly?
(define (radicals-small? s)
  (<= (for/sum ([(radical c) (in-hash s)])
        (+ 1 (length radical) (quotient (rational-bits c) 16)))
      most-parts))

(define most-parts 40)

;; The decimal next to the value, or one of its neighbours.  Where terms cancel, flonums would
;; leave few digits; then integers count in units that are halved until 60 bits of the sum
;; stand.
(define (radicals->flonum s)
  (define terms (for/list ([(radical c) (in-hash s)]) (term-flonum radical c)))
  (define sum (apply + terms))
  (if (and (rational? sum) (> (abs sum) (* 1/4 (apply + (map abs terms)))))
      sum
      (let in-units ([bits 128])
        (define units (for/sum ([(radical c) (in-hash s)]) (term-in-units radical c bits)))
        (if (> (integer-length units) 64)
            (real->double-flonum (/ units (expt 2 bits)))
            (in-units (* 2 bits))))))

;; A single square root is rounded once.
(define (term-flonum radical c)
  (define q (root-degree radical))
  (define power (real->double-flonum (term-power radical c q)))
  (* (if (negative? c) -1 1) (if (eqv? q 2) (sqrt power) (expt power (/ 1.0 q)))))

(define (root-degree radical) (apply lcm (map (lambda (f) (denominator (cdr f))) radical)))

;; The q-th power of the term's magnitude.
(define (term-power radical c q)
  (for/fold ([power (expt (abs c) q)]) ([f (in-list radical)])
    (* power (expt (car f) (* q (cdr f))))))

;; The term in units of 2^-bits, truncated.
(define (term-in-units radical c bits)
  (define q (root-degree radical))
  (define n (floor (* (term-power radical c q) (expt 2 (* q bits)))))
  (* (if (negative? c) -1 1) (integer-root n q)))

;; The whole part of the q-th root of n, by Newton's method from above.
(define (integer-root n q)
  (let improve ([x (expt 2 (quotient (+ (integer-length n) q) q))])
    (define y (if (eqv? x 0) 0 (quotient (+ (* (- q 1) x) (quotient n (expt x (- q 1)))) q)))
    (if (< y x) (improve y) x)))
