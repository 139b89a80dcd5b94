#lang racket/base
;; Loops over flvectors, written as the formulas they are.
;;
;; The coefficients of a method stand in the formulas as numbers; the compiler
;; keeps everything in a loop's body unboxed.  Indices are not checked: all
;; vectors of one integration are made together, of one length n.

(require racket/flonum
         racket/unsafe/ops
         "../unboxed-loop.rkt")

(provide define-vectors make-vectors define-elements
         combine! weighted-sum! weighted at advance! scale! exchange!
         store-coefficients! nested-polynomial
         root-mean-square root-mean-squares)

(define-syntax-rule (define-vectors n id ...)
  (begin (define id (make-flvector n)) ...))

;; A vector of `count` flvectors of length n; define-elements names its first elements, in order.
(define (make-vectors count n) (build-vector count (lambda (_) (make-flvector n))))

(define-syntax-rule (define-elements vectors id ...)
  (define-elements-from 0 vectors id ...))

(define-syntax define-elements-from
  (syntax-rules ()
    [(_ i vectors) (begin)]
    [(_ i vectors id . more)
     (begin (define id (unsafe-vector-ref vectors i))
            (define-elements-from (+ i 1) vectors . more))]))

;; a₁ k₁ + a₂ k₂ + ..., of the components of index i
(define-syntax-rule (weighted i [a k] ...)
  (sum (unsafe-fl* a (at k i)) ...))

;; out = y + h (a₁ k₁ + a₂ k₂ + ...)
(define-syntax-rule (combine! n out y h [a k] ...)
  (each (i 0 n)
    (put! out i (unsafe-fl+ (at y i) (unsafe-fl* h (weighted i [a k] ...))))))

;; out = a₁ k₁ + a₂ k₂ + ...
(define-syntax-rule (weighted-sum! n out [a k] ...)
  (each (i 0 n)
    (put! out i (weighted i [a k] ...))))

;; v = v + h w, from one index to before another
(define-syntax-rule (advance! v w h from to)
  (let ([step h])
    (each (i from to) (put! v i (unsafe-fl+ (at v i) (unsafe-fl* step (at w i)))))))

;; v = h v
(define (scale! v h)
  (each (i 0 (flvector-length v))
    (put! v i (unsafe-fl* h (at v i)))))

;; The root of the mean of (xᵢ / (1 + max(|yᵢ|, |zᵢ|)))²: how large x is beside
;; y and z, numbers below 1 counting as 1.
(define (root-mean-square x y z n)
  (root-mean-squares n i y z [(at x i)]))

;; The same of one or two x, whose components of index i are given by formulas, in one loop.
(define-syntax root-mean-squares
  (syntax-rules ()
    [(_ n i y z [x]) (mean-squares n i y z ([x total]) (root-of-mean total n))]
    [(_ n i y z [x0 x1])
     (mean-squares n i y z ([x0 total0] [x1 total1])
                   (values (root-of-mean total0 n) (root-of-mean total1 n)))]))

(define-syntax-rule (mean-squares n i y z ([x total] ...) result)
  (let loop ([i 0] [total 0.0] ...)
    (if (unsafe-fx< i n)
        (let ([scale (unsafe-fl+ 1.0 (unsafe-flmax (unsafe-flabs (at y i))
                                                   (unsafe-flabs (at z i))))])
          (loop (unsafe-fx+ i 1)
                (let ([q (unsafe-fl/ x scale)]) (unsafe-fl+ total (unsafe-fl* q q))) ...))
        result)))

(define-syntax-rule (root-of-mean total n) (flsqrt (fl/ total (->fl n))))

(define (exchange! v w)
  (each (i 0 (flvector-length v))
    (let ([x (at v i)])
      (put! v i (at w i))
      (put! w i x))))

;; Stores in `kept` vectors one after the other, whose components of index i are given by formulas;
;; each may use those before it.
(define-syntax-rule (store-coefficients! n i kept [c value] ...)
  (each (i 0 n)
    (let* ([c value] ...)
      (store! kept i n c ...))))

(define-syntax store!
  (syntax-rules ()
    [(_ v place n) (void)]
    [(_ v place n x . more)
     (begin (put! v place x)
            (store! v (unsafe-fx+ place n) n . more))]))

;; kept : coefficients x, c₀ ..., vectors of n components one after the other
;; -> (theta out -> void), which stores x + θ (c₀ + (1 − θ) (c₁ + θ (c₂ + ...)))
(define (nested-polynomial n kept)
  (define last (unsafe-fx- (flvector-length kept) n))
  (define last-by-theta? (even? (quotient (flvector-length kept) n)))
  (lambda (theta out)
    (define other (fl- 1.0 theta))
    (define-values (one two) (if last-by-theta? (values theta other) (values other theta)))
    (each (i 0 n)
      (put! out i (nested kept n (unsafe-fx+ i last) one two)))))

;; From the last coefficient on; factors take turns.
(define-syntax-rule (nested kept n from one two)
  (let loop ([place (unsafe-fx- from n)] [sum (at kept from)] [a one] [b two])
    (if (unsafe-fx< place 0)
        (unboxed sum)
        (loop (unsafe-fx- place n) (unsafe-fl+ (at kept place) (unsafe-fl* a sum)) b a))))
