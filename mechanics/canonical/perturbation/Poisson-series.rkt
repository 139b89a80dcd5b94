#lang racket/base
;; Poisson series: sums of waves in angles, with expressions in the other variables for
;; coefficients,
;;
;;     Σ  c_k cos k·θ + s_k sin k·θ,        k a list of integers,
;;
;; each wave once: the first of the k that is not 0 is positive.  They are closed under sums,
;; products, derivatives and brackets.  A term linear in the angles may be with them, by which
;; the angles themselves are series.

(require (only-in racket/list list-set make-list)
         "expression-in-ring.rkt"
         "../../algebra/expression/expression.rkt" "../../algebra/expression/operation.rkt"
         "../../algebra/expression/symbols.rkt"
         "../../calculus/expression-function.rkt"
         "../../generic/arithmetic.rkt" "../../generic/elementary.rkt"
         "../../generic/sums-and-products.rkt"
         "../../value/simplify.rkt")

(provide (struct-out wave) constant-series zero-series angle-series one-wave
         expression->Poisson-series series-sum series-scale series-bracket
         (rename-out [Poisson-series-waves series-waves]) wave-numbers series->expression)

;; waves : hash of k ↦ wave;  linear : the coefficients of the angles, numbers
(struct Poisson-series (waves linear) #:authentic)
(struct wave (cosine sine) #:authentic)

(define (zeros n) (make-list n 0))
(define (zero-series n) (Poisson-series (hash) (zeros n)))
(define (constant-series n c) (one-wave (zeros n) c 0))

;; c cos k·θ + s sin k·θ
(define (one-wave k c s) (make (list (cons k (wave c s))) (zeros (length k))))

;; The angle of index j among n
(define (angle-series n j) (Poisson-series (hash) (list-set (zeros n) j 1)))

(define (wave-numbers s) (hash-keys (Poisson-series-waves s)))

;; ---------------------------------------------------------------------------
;; Making

;; parts : ((k . wave) …), with any k, several of one
(define (make parts linear)
  (define collected
    (for/fold ([waves (hash)]) ([part (in-list parts)])
      (define-values (k w) (turned (car part) (cdr part)))
      (hash-update waves k (lambda (old) (wave (g:+ (wave-cosine old) (wave-cosine w))
                                               (g:+ (wave-sine old) (wave-sine w))))
                   (wave 0 0))))
  (Poisson-series
   (for*/hash ([(k w) (in-hash collected)]
               [simple (in-value (wave (simplify-strictly (wave-cosine w))
                                       (if (andmap zero? k)
                                           0
                                           (simplify-strictly (wave-sine w)))))]
               #:unless (no-wave? simple))
     (values k simple))
   linear))

(define (no-wave? w) (and (eqv? 0 (wave-cosine w)) (eqv? 0 (wave-sine w))))

;; cos is even, sin is odd
(define (turned k w)
  (define leading (findf (lambda (x) (not (zero? x))) k))
  (if (and leading (negative? leading))
      (values (map - k) (wave (wave-cosine w) (g:negate (wave-sine w))))
      (values k w)))

(define (parts s)
  (for/list ([(k w) (in-hash (Poisson-series-waves s))]) (cons k w)))

;; ---------------------------------------------------------------------------
;; Arithmetic

(define (series-sum a b)
  (make (append (parts a) (parts b)) (map + (Poisson-series-linear a) (Poisson-series-linear b))))

(define (series-scale c s)
  (make (scaled c (parts s)) (for/list ([x (in-list (Poisson-series-linear s))]) (* c x))))

(define (scaled c parts)
  (for/list ([p (in-list parts)])
    (cons (car p) (wave (g:* c (wave-cosine (cdr p))) (g:* c (wave-sine (cdr p)))))))

;; Of series without a linear term
(define (series-product a b)
  (make (products (parts a) (parts b)) (Poisson-series-linear a)))

(define (products as bs)
  (for*/fold ([all '()]) ([a (in-list as)] [b (in-list bs)]) (append (wave-product a b) all)))

;; Products of waves are the waves of the sum and of the difference.
(define (wave-product a b)
  (define-values (j k) (values (car a) (car b)))
  (define-values (c1 s1) (values (wave-cosine (cdr a)) (wave-sine (cdr a))))
  (define-values (c2 s2) (values (wave-cosine (cdr b)) (wave-sine (cdr b))))
  (define-values (cc ss sc cs) (values (g:* c1 c2) (g:* s1 s2) (g:* s1 c2) (g:* c1 s2)))
  (list (cons (map + j k) (wave (g:* 1/2 (g:- cc ss)) (g:* 1/2 (g:+ sc cs))))
        (cons (map - j k) (wave (g:* 1/2 (g:+ cc ss)) (g:* 1/2 (g:- sc cs))))))

;; ---------------------------------------------------------------------------
;; Derivatives and brackets

;; {a, b} = Σ ∂a/∂θ ∂b/∂I − ∂a/∂I ∂b/∂θ;  actions : the symbols of the I
(define (series-bracket a b actions)
  (define all
    (for/fold ([all '()]) ([I (in-list actions)] [j (in-naturals)])
      (append (products (by-angle a j) (by-action b I))
              (scaled -1 (products (by-action a I) (by-angle b j)))
              all)))
  (make all (zeros (length actions))))

(define (by-angle s j)
  (define slope (list-ref (Poisson-series-linear s) j))
  (define waves
    (for*/list ([p (in-list (parts s))]
                [k (in-value (list-ref (car p) j))]
                #:unless (zero? k))
      (cons (car p) (wave (g:* k (wave-sine (cdr p))) (g:* (- k) (wave-cosine (cdr p)))))))
  (if (zero? slope)
      waves
      (cons (cons (zeros (length (Poisson-series-linear s))) (wave slope 0)) waves)))

(define (by-action s I)
  (define (slope e) (if (occurs? I e) (expression-derivative e I) 0))
  (for*/list ([p (in-list (parts s))]
              [w (in-value (wave (slope (wave-cosine (cdr p))) (slope (wave-sine (cdr p)))))]
              #:unless (no-wave? w))
    (cons (car p) w)))

;; ---------------------------------------------------------------------------
;; From expressions and back

;; -> the series of e in the angles, symbols; (fail part) where a part of e has no series
(define (expression->Poisson-series e angles fail)
  (define n (length angles))
  (define (seen e)
    (cond [(not (ormap (lambda (a) (occurs? a e)) angles)) (constant-series n e)]
          [(and (node? e) (memq (node-head e) (list op:sin op:cos)))
           (walk-wave (eq? (node-head e) op:sin) (car (node-args e)) angles
                      (lambda () (fail e)))]
          [else #f]))
  (expression-in (ring (lambda (c) (constant-series n c)) series-sum series-product series-scale)
                 e seen fail))

;; sin or cos of k·θ + b
(define (walk-wave sine? argument angles fail)
  (define k
    (for/list ([a (in-list angles)])
      (whole-number (simplify-strictly (expression-derivative argument a)))))
  (cond
    [(andmap exact-integer? k)
     (define still (map (lambda (a) (cons a 0)) angles))
     (define b (simplify-strictly (evaluate-generically argument still)))
     (define-values (c s) (values (g:cos b) (g:sin b)))
     (if sine? (one-wave k s c) (one-wave k c (g:negate s)))]
    [else (fail)]))

;; x, exact if it is a whole number written as a decimal
(define (whole-number x) (if (and (real? x) (integer? x)) (inexact->exact x) x))

;; thetas : values of the angles
(define (series->expression s thetas)
  (define (combination numbers)
    (g:for/sum ([c (in-list numbers)] [theta (in-list thetas)])
      (g:* c theta)))
  (for/fold ([sum (combination (Poisson-series-linear s))])
            ([k (in-list (sort (wave-numbers s) earlier?))])
    (define w (hash-ref (Poisson-series-waves s) k))
    (define angle (combination k))
    (g:+ sum (g:* (wave-cosine w) (g:cos angle)) (g:* (wave-sine w) (g:sin angle)))))

(define (earlier? a b)
  (define (size k) (apply + (map abs k)))
  (cond [(= (size a) (size b)) (lexically-earlier? a b)]
        [else (< (size a) (size b))]))

(define (lexically-earlier? a b)
  (for/or ([x (in-list a)] [y (in-list b)] #:unless (= x y)) (> x y)))
