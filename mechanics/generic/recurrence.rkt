#lang racket/base
;; Taylor coefficients of the value of an operation from those of its arguments.
;;
;; Let a = a₀ + a₁ε + a₂ε² + …, and r = op(a).  Every operation has a rule for
;; its derivative, r' = g(a, r) a', and to compare coefficients in it gives
;; k r_k = Σ_{j=1..k} j a_j g_{k-j}: with the coefficients of g, which only need
;; those of r below k, any operation can be done to order n.  That is how it is
;; done unless it has an entry here.  An entry is worth having where r satisfies a
;; simpler equation, as the product does, or exp with g = r: order n then costs n²
;; multiplications and no more (Griewank and Walther, Evaluating Derivatives,
;; ch. 13).
;;
;; Truncated Taylor numbers and power series run the same recurrences.  Those see
;; coefficients as functions of the index, exact 0 from a length on, which is
;; +inf.0 for an endless series.

(require "kind.rkt" "arithmetic.rkt" "elementary.rkt")

(provide recurrence-of (struct-out recurrence) (struct-out partner)
         weighted-convolution)

;; reduce  : arguments -> the value by other operations, or #f
;; length  : lengths of the arguments -> length of the value
;; choose  : first coefficient and length of each argument -> step, or #f where
;;           there is no recurrence
;; partner : the operation done to the same argument alongside, on which this one
;;           depends, as cos for sin; or #f
;; A step gives coefficient k > 0 of the value r, from coefficients below k of r:
;; (step k a la r) for an operation of one argument, (step k a la b lb r) for one
;; of two, (step k a la p) for one with a partner p.
(struct recurrence (reduce length choose partner) #:authentic)
(struct partner (procedure step) #:authentic)

(define (endless . lengths) +inf.0)

(define (make-recurrence choose #:reduce [reduce #f] #:partner [partner #f]
                         #:length [length endless])
  (recurrence reduce length choose partner))

;; The recurrence of the operation of this record, or #f.
(define (recurrence-of op)
  (case (generic-op-name op)
    [(+) sum-recurrence]
    [(-) difference-recurrence]
    [(*) product-recurrence]
    [(/) quotient-recurrence]
    [(expt) power-recurrence]
    [(sqrt) root-recurrence]
    [(exp) exponential-recurrence]
    [(log) logarithm-recurrence]
    [(sin) sine-recurrence]
    [(cos) cosine-recurrence]
    [(sinh) hyperbolic-sine-recurrence]
    [(cosh) hyperbolic-cosine-recurrence]
    [else #f]))

;; ---------------------------------------------------------------------------
;; Sums of products

;; Σ a_j b_{k-j} for j from `low` to `high`, where neither is known to be 0.
(define (convolution a la b lb k [low 0] [high k])
  (define first (if (< k lb) low (max low (add1 (- k lb)))))
  (define last (if (< high la) high (sub1 la)))
  (let loop ([j first] [sum 0])
    (if (> j last)
        sum
        (let ([x (a j)] [y (b (- k j))])
          (loop (add1 j)
                (if (or (eqv? x 0) (eqv? y 0)) sum (g:+ sum (g:* x y))))))))

;; Σ_{j=1..high} j a_j b_{k-j}: for high = k it is k times coefficient k of the
;; integral of a' b.
(define (weighted-convolution a la b k [high k])
  (define last (if (< high la) high (sub1 la)))
  (let loop ([j 1] [sum 0])
    (if (> j last)
        sum
        (let ([x (a j)] [y (b (- k j))])
          (loop (add1 j)
                (if (or (eqv? x 0) (eqv? y 0))
                    sum
                    (g:+ sum (g:* (g:* j x) y))))))))

;; ---------------------------------------------------------------------------
;; The four operations

(define sum-recurrence
  (make-recurrence (lambda (a0 la b0 lb) (lambda (k a la b lb r) (g:+ (a k) (b k))))
                   #:length max))

(define difference-recurrence
  (make-recurrence (lambda (a0 la b0 lb) (lambda (k a la b lb r) (g:- (a k) (b k))))
                   #:length max))

(define product-recurrence
  (make-recurrence
   (lambda (a0 la b0 lb) (lambda (k a la b lb r) (convolution a la b lb k)))
   #:length (lambda (la lb) (+ la lb -1))))

;; r b = a
(define quotient-recurrence
  (make-recurrence
   (lambda (a0 la b0 lb)
     (lambda (k a la b lb r)
       (g:/ (g:- (a k) (convolution r +inf.0 b lb k 0 (sub1 k))) b0)))
   #:length (lambda (la lb) (if (eqv? lb 1) la +inf.0))))

;; ---------------------------------------------------------------------------
;; Powers

;; Whole powers are products, which also serves where b₀ = 0.  Otherwise
;; b r' = n b' r for a constant n, and r' = r log(b) n' for a constant b.
(define power-recurrence
  (make-recurrence
   (lambda (b0 lb n0 ln)
     (cond [(and (number? b0) (zero? b0)) #f]
           [(eqv? ln 1)
            (lambda (k b lb n ln r)
              (g:/ (g:- (g:* n0 (weighted-convolution b lb r k))
                        (weighted-convolution r +inf.0 b k (sub1 k)))
                   (g:* k b0)))]
           [(eqv? lb 1)
            (define slope (g:log b0))
            (lambda (k b lb n ln r) (g:* slope (integral n ln r k)))]
           [else #f]))
   #:reduce (lambda (b n) (and (exact-nonnegative-integer? n) (whole-power b n)))))

(define (whole-power b n)
  (cond [(eqv? n 0) 1]
        [(eqv? n 1) b]
        [(even? n) (whole-power (g:* b b) (quotient n 2))]
        [else (g:* b (whole-power b (sub1 n)))]))

;; r r = a
(define root-recurrence
  (make-recurrence
   (lambda (a0 la)
     (lambda (k a la r)
       (g:/ (g:- (a k) (convolution r +inf.0 r +inf.0 k 1 (sub1 k)))
            (g:* 2 (r 0)))))))

;; ---------------------------------------------------------------------------
;; Functions that are integrals of themselves or of one another

;; Coefficient k of the integral of a' g.
(define (integral a la g k) (g:/ (weighted-convolution a la g k) k))
(define (minus-integral a la g k) (g:negate (integral a la g k)))

;; r' = r a'
(define exponential-recurrence
  (make-recurrence (lambda (a0 la) (lambda (k a la r) (integral a la r k)))))

;; a r' = a'
(define logarithm-recurrence
  (make-recurrence
   (lambda (a0 la)
     (lambda (k a la r)
       (g:/ (g:- (a k) (g:/ (weighted-convolution r +inf.0 a k (sub1 k)) k)) a0)))))

;; r' = p a' or -p a', and p' likewise with r.
(define (paired step partner-procedure partner-step)
  (make-recurrence (lambda (a0 la) (lambda (k a la p) (step a la p k)))
                   #:partner (partner partner-procedure
                                      (lambda (k a la r) (partner-step a la r k)))))

(define sine-recurrence (paired integral g:cos minus-integral))
(define cosine-recurrence (paired minus-integral g:sin integral))
(define hyperbolic-sine-recurrence (paired integral g:cosh integral))
(define hyperbolic-cosine-recurrence (paired integral g:sinh integral))
