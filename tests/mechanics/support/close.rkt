#lang racket/base
;; Numbers that are the same up to a tolerance, alone and in whatever holds them.

(require racket/flonum
         (only-in mechanics/generic/irrational irrational-as-decimal)
         mechanics/generic/up-down
         mechanics/value/bigfloat
         "checks.rkt")

(provide
 close?          ; (close? a b [tolerance]) : relative, to the greater of them and 1
 check-close     ; (check-close given expected tolerance) : absolute, of all numbers in them
 exact)          ; real number of any precision -> exact

;; |a - b| <= tolerance max(1, |a|, |b|), of finite numbers; others are close to themselves
(define (close? x y [tolerance 1e-9])
  (define-values (a b) (values (irrational-as-decimal x) (irrational-as-decimal y)))
  (or (eqv? a b)
      (and (finite? a) (finite? b)
           (<= (magnitude (- a b)) (* tolerance (max 1 (magnitude a) (magnitude b)))))))

(define (finite? z) (and (rational? (real-part z)) (rational? (imag-part z))))

(define-check (check-close given expected tolerance)
  (define xs (numbers-in given))
  (define ys (numbers-in expected))
  (unless (and (= (length xs) (length ys))
               (for/and ([x (in-list xs)] [y (in-list ys)])
                 (< (abs (- (exact x) (exact y))) tolerance)))
    (with-check-info (['given given] ['expected expected]) (fail-check))))

;; Numbers of structures, lists and flvectors, of any precision; of exact roots the decimals.
(define (numbers-in x)
  (cond [(structure? x) (numbers-in (vector->list (structure-elements x)))]
        [(list? x) (apply append (map numbers-in x))]
        [(flvector? x) (for/list ([y (in-flvector x)]) y)]
        [else (list (irrational-as-decimal x))]))

;; Infinities and what is no number stay.
(define (exact x)
  (cond [(bigfloat? x) (bigfloat->exact x)]
        [(rational? x) (inexact->exact x)]
        [else x]))
