#lang racket/base
;; Loops over flvectors, written as the formulas they are.
;;
;; The coefficients of a method stand in the formulas as numbers; the compiler
;; keeps everything in a loop's body unboxed.  Indices are not checked: all
;; vectors of one integration are made together, of one length n.

(require racket/flonum racket/unsafe/ops)

(provide define-vectors combine! weighted-sum! advance! scale! flvector-copy! exchange!
         nested-polynomial root-mean-square flvector-finite?)

(define-syntax-rule (define-vectors n id ...)
  (begin (define id (make-flvector n)) ...))

(define-syntax-rule (for-each-index i n body)
  (let loop ([i 0])
    (when (unsafe-fx< i n)
      body
      (loop (unsafe-fx+ i 1)))))

(define-syntax sum
  (syntax-rules ()
    [(_ x) x]
    [(_ x y . more) (sum (unsafe-fl+ x y) . more)]))

;; out = y + h (a₁ k₁ + a₂ k₂ + ...)
(define-syntax-rule (combine! n out y h [a k] ...)
  (for-each-index i n
    (unsafe-flvector-set! out i
      (unsafe-fl+ (unsafe-flvector-ref y i)
                  (unsafe-fl* h (sum (unsafe-fl* a (unsafe-flvector-ref k i)) ...))))))

;; out = a₁ k₁ + a₂ k₂ + ...
(define-syntax-rule (weighted-sum! n out [a k] ...)
  (for-each-index i n
    (unsafe-flvector-set! out i (sum (unsafe-fl* a (unsafe-flvector-ref k i)) ...))))

;; v = v + h w, from one index to before another
(define (advance! v w h from to)
  (let loop ([i from])
    (when (unsafe-fx< i to)
      (unsafe-flvector-set! v i (unsafe-fl+ (unsafe-flvector-ref v i)
                                            (unsafe-fl* h (unsafe-flvector-ref w i))))
      (loop (unsafe-fx+ i 1)))))

;; v = h v
(define (scale! v h)
  (for-each-index i (flvector-length v)
    (unsafe-flvector-set! v i (unsafe-fl* h (unsafe-flvector-ref v i)))))

(define (flvector-copy! to from)
  (for-each-index i (flvector-length to)
    (unsafe-flvector-set! to i (unsafe-flvector-ref from i))))

;; The root of the mean of (xᵢ / (1 + max(|yᵢ|, |zᵢ|)))²: how large x is beside
;; y and z, numbers below 1 counting as 1.
(define (root-mean-square x y z n)
  (let loop ([i 0] [total 0.0])
    (if (unsafe-fx< i n)
        (let* ([scale (unsafe-fl+ 1.0 (unsafe-flmax (unsafe-flabs (unsafe-flvector-ref y i))
                                                    (unsafe-flabs (unsafe-flvector-ref z i))))]
               [q (unsafe-fl/ (unsafe-flvector-ref x i) scale)])
          (loop (unsafe-fx+ i 1) (unsafe-fl+ total (unsafe-fl* q q))))
        (flsqrt (fl/ total (->fl n))))))

(define (flvector-finite? v)
  (for/and ([x (in-flvector v)]) (< (abs x) +inf.0)))

(define (exchange! v w)
  (for-each-index i (flvector-length v)
    (let ([x (unsafe-flvector-ref v i)])
      (unsafe-flvector-set! v i (unsafe-flvector-ref w i))
      (unsafe-flvector-set! w i x))))

;; -> (theta out -> void), which stores y + θ (c₀ + (1 − θ) (c₁ + θ (c₂ + ...)))
(define-syntax-rule (nested-polynomial n y c ...)
  (lambda (theta out)
    (let ([rest (unsafe-fl- 1.0 theta)])
      (for-each-index i n
        (unsafe-flvector-set! out i
          (nested theta rest (unsafe-flvector-ref y i) (unsafe-flvector-ref c i) ...))))))

;; x₀ + a (x₁ + b (x₂ + a (x₃ + ...)))
(define-syntax nested
  (syntax-rules ()
    [(_ a b x) x]
    [(_ a b x . more) (unsafe-fl+ x (unsafe-fl* a (nested b a . more)))]))
