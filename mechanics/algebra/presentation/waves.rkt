#lang racket/base
;; Polynomials in sines and cosines as sums of waves, and back to products.
;;
;; With z = e^(iθ) a power product of cos θ and sin θ is
;;
;;     cosᵖθ sinᵗθ = (z + 1/z)ᵖ (z - 1/z)ᵗ / (2ᵖ⁺ᵗ iᵗ),
;;
;; so a product over several angles is a sum of waves cos(k·θ), or sin(k·θ) if
;; the sines are odd in number, k being integers.  Two waves of one amplitude
;; whose sum and difference can be halved are a product again,
;;
;;     cos u + cos v =  2 cos (u+v)/2 cos (u-v)/2      sin u + sin v = 2 sin (u+v)/2 cos (u-v)/2
;;     cos u - cos v = -2 sin (u+v)/2 sin (u-v)/2      sin u - sin v = 2 cos (u+v)/2 sin (u-v)/2
;;
;; and with v = 0 that finds squares: 1 - cos u = 2 sin²(u/2).  Hyperbolic
;; functions do the same without the i, so without the minus sign.
;;
;; The waves depend on the value alone, whatever the products were.

(require racket/list
         "../expression/size.rkt"
         "../kernel/kernel.rkt")

(provide (struct-out wave) power-waves pair-waves wave-size amplitude-size)

;; amplitude · ∏ function(multiples · angles), with the angles of some circles;
;; factors : ((function . multiples) ...), function ∈ sine cosine; multiples: a
;; list of integers of which the first that is not 0 is positive.
(struct wave (amplitude factors) #:authentic)

;; ---------------------------------------------------------------------------
;; From powers to waves

;; terms : ((amplitude . ((cosine-exponent . sine-exponent) ...)) ...), exponents
;; by circle; -> waves of one factor, or none for the constant.
;;
;; Multiples are packed into one integer, k₁ counting most, which has the sign of
;; the first that is not 0.  Of k and -k, whose amplitudes are equal or opposite,
;; only the positive one is followed to the end.
(define (power-waves terms circular?)
  (define count (length (cdar terms)))
  (define width (+ 2 (integer-length (highest-degree terms))))
  (define units (for/list ([i (in-range count)]) (arithmetic-shift 1 (* width (- count i 1)))))
  (define binomials (make-binomials))
  (define cosines (make-hasheqv))
  (define sines (make-hasheqv))
  (for ([t (in-list terms)])
    (define odd (apply + (map cdr (cdr t))))
    (define degree (for/sum ([e (in-list (cdr t))]) (+ (car e) (cdr e))))
    (define amplitude (/ (car t) (arithmetic-shift 1 degree)))
    (add-products! (if (even? odd) cosines sines)
                   (if (and circular? (odd? (quotient odd 2))) (- amplitude) amplitude)
                   (for/list ([e (in-list (cdr t))]) (binomials (car e) (cdr e)))
                   units))
  (append (table->waves cosines 'cosine count width) (table->waves sines 'sine count width)))

(define (highest-degree terms)
  (for*/fold ([d 1]) ([t (in-list terms)] [e (in-list (cdr t))]) (max d (+ (car e) (cdr e)))))

;; Adds amplitude · ∏ (z + 1/z)ᵖ (z - 1/z)ᵗ, expanded, by the exponents of the z.
(define (add-products! table amplitude factors units)
  (let walk ([factors factors] [units units] [amplitude amplitude] [key 0])
    (cond [(pair? factors)
           (for ([term (in-list (car factors))])
             (walk (cdr factors) (cdr units)
                   (* amplitude (cdr term)) (+ key (* (car term) (car units)))))]
          [(>= key 0)
           (hash-set! table key (+ amplitude (hash-ref table key 0)))])))

;; -> (p t -> (z + 1/z)ᵖ (z - 1/z)ᵗ as ((exponent . coefficient) ...))
(define (make-binomials)
  (define known (make-hash))
  (define (times sign sum)
    (for*/fold ([new (hasheqv)]) ([term (in-list sum)] [step (in-list (list 1 -1))])
      (define k (+ (car term) step))
      (hash-set new k (+ (hash-ref new k 0) (if (eqv? step 1) (cdr term) (* sign (cdr term)))))))
  (define (terms sum)
    (for/list ([(k x) (in-hash sum)] #:unless (eqv? x 0)) (cons k x)))
  (define (expand p t)
    (hash-ref! known (cons p t)
               (lambda ()
                 (cond [(positive? t) (terms (times -1 (expand p (- t 1))))]
                       [(positive? p) (terms (times 1 (expand (- p 1) t)))]
                       [else '((0 . 1))]))))
  expand)

(define (table->waves table function count width)
  (for/list ([key (in-list (sort (hash-keys table) >))]
             #:unless (and (eqv? key 0) (eq? function 'sine))
             [x (in-value (hash-ref table key))]
             #:unless (eqv? x 0))
    (if (eqv? key 0)
        (wave x '())
        (wave (* 2 x) (list (cons function (unpack key count width)))))))

(define (unpack key count width)
  (define base (arithmetic-shift 1 width))
  (for/fold ([multiples '()] [key key] #:result multiples) ([_ (in-range count)])
    (define low (bitwise-and key (- base 1)))
    (define k (if (>= (* 2 low) base) (- low base) low))
    (values (cons k multiples) (arithmetic-shift (- key k) (- width)))))

(define (leading-positive? multiples)
  (positive? (findf (lambda (k) (not (eqv? 0 k))) multiples)))

;; ---------------------------------------------------------------------------
;; From waves to products

;; Pairs of waves become products, and those products of more factors, as long as
;; that is shorter.
;; size : wave -> number
(define (pair-waves waves circular? size)
  (define paired (pair-once waves circular? size))
  (if (= (length paired) (length waves))
      (map halve-angle waves)
      (pair-waves paired circular? size)))

(define (pair-once waves circular? size)
  (cond [(null? waves) '()]
        [else
         (define-values (partner product) (best-partner (car waves) (cdr waves) circular? size))
         (if product
             (cons product (pair-once (remq partner (cdr waves)) circular? size))
             (cons (car waves) (pair-once (cdr waves) circular? size)))]))

(define (best-partner w others circular? size)
  (for*/fold ([partner #f] [best #f])
             ([v (in-list others)]
              [product (in-value (product-of w v circular?))]
              #:when (and product
                          (< (size product) (+ 1 (size w) (size v)))
                          (or (not best) (< (size product) (size best)))))
    (values v product)))

;; The product two waves make, whose factors are the same but for one, or #f.
(define (product-of w v circular?)
  (define x (wave-amplitude w))
  (define y (wave-amplitude v))
  (and (= (abs x) (abs y))
       (let-values ([(shared f g) (compare-factors (wave-factors w) (wave-factors v))])
         (and f
              (eq? (car f) (car g))
              (andmap (lambda (k l) (even? (+ k l))) (cdr f) (cdr g))
              (make-product x (= x y) f g shared circular?)))))

;; -> the factors that are the same, and those that are not, one of each; the
;; constant counts as the cosine of 0.
(define (compare-factors as bs)
  (define left (without bs as))
  (define right (without as bs))
  (define shared (reverse (without left as)))
  (define (nothing-but f) (cons 'cosine (map (lambda (k) 0) (cdr f))))
  (define (one? fs) (= 1 (length fs)))
  (cond [(and (one? left) (one? right)) (values shared (car left) (car right))]
        [(and (one? left) (null? right)) (values shared (car left) (nothing-but (car left)))]
        [(and (null? left) (one? right)) (values shared (nothing-but (car right)) (car right))]
        [else (values #f #f #f)]))

;; fs without the gone, each as often as it is there
(define (without gone fs)
  (for/fold ([fs fs]) ([g (in-list gone)]) (remove g fs)))

;; x (f(u) ± f(v)) times the shared factors, the sign + if same?
(define (make-product x same? u v shared circular?)
  (define-values (f g sign)
    (if (eq? (car u) 'cosine)
        (if same? (values 'cosine 'cosine 1) (values 'sine 'sine (if circular? -1 1)))
        (if same? (values 'sine 'cosine 1) (values 'cosine 'sine 1))))
  (define (half op) (map (lambda (k l) (quotient (op k l) 2)) (cdr u) (cdr v)))
  (define-values (a a-sign) (oriented f (half +)))
  (define-values (b b-sign) (oriented g (half -)))
  (wave (* 2 x sign a-sign b-sign) (list* a b shared)))

(define (oriented function multiples)
  (if (leading-positive? multiples)
      (values (cons function multiples) 1)
      (values (cons function (map - multiples)) (if (eq? function 'sine) -1 1))))

;; The sine of twice a sum is a product: its factors may be met elsewhere.
(define (halve-angle w)
  (define f (and (= 1 (length (wave-factors w))) (car (wave-factors w))))
  (define multiples (if f (cdr f) '()))
  (cond [(and f
              (eq? (car f) 'sine)
              (pair? (cdr (remv* '(0) multiples)))
              (eqv? 2 (apply gcd multiples)))
         (define half (map (lambda (k) (quotient k 2)) multiples))
         (wave (* 2 (wave-amplitude w)) (list (cons 'sine half) (cons 'cosine half)))]
        [else w]))

;; ---------------------------------------------------------------------------
;; Sizes

;; The size the wave would have, written with the angles of these circles.
(define (wave-size w circles)
  (define factors (remove-duplicates (wave-factors w)))
  (define powers (- (length (wave-factors w)) (length factors)))
  (define number (amplitude-size (wave-amplitude w)))
  (if (null? factors)
      (max 1 number)
      (+ number
         (* 2 powers)
         (if (and (null? (cdr factors)) (eqv? number 0)) 0 1)
         (for/sum ([f (in-list factors)]) (+ 1 (angle-size (cdr f) circles))))))

(define (amplitude-size x)
  (+ (if (negative? x) 1 0) (if (eqv? 1 (abs x)) 0 1)))

(define (angle-size multiples circles)
  (define terms
    (for/list ([k (in-list multiples)] [o (in-list circles)] #:unless (eqv? k 0))
      (+ (expression-size (circle-expression o)) (if (eqv? 1 (abs k)) 0 2))))
  (+ (apply + terms) (if (> (length terms) 1) 1 0)))
