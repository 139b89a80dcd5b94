#lang racket/base
;; A minimum of a function of several variables with its gradient, by the method of
;; Broyden, Fletcher, Goldfarb and Shanno (Nocedal and Wright, Numerical
;; Optimization, 2nd ed. 2006, 6.1).
;;
;; H approximates the inverse of the matrix of second derivatives.  The step
;; p = −H g, g being the gradient, would reach the minimum of a quadratic function;
;; it is halved until the function falls by a fair part of what g promises.  The
;; change s of the point and y of the gradient then correct H:
;;
;;     H ← (1 − ρ s yᵀ) H (1 − ρ y sᵀ) + ρ s sᵀ,     ρ = 1/(y·s),
;;
;; where y·s is positive.  The search ends when p is shorter than the tolerance.  On
;; a quadratic function of n variables that takes about n steps.

(require racket/flonum
         "failure.rkt")

(provide quasi-newton)

;; value-and-gradient : x -> value, gradient; flvectors and a flonum
;; observe            : called with each point reached and the value there
;; -> point, value, steps
(define (quasi-newton value-and-gradient start
                      #:tolerance [tolerance 1e-8]
                      #:limit [limit 1000]
                      #:observe [observe void]
                      #:name [who 'minimize])
  (define n (flvector-length start))
  (let loop ([x start] [H (unit n)] [count 0] [known #f])
    (define-values (f g) (if known (values (car known) (cdr known)) (value-and-gradient x)))
    (observe x f)
    (define p (negative-product H g))
    (cond
      [(not (and (finite? f) (finite? (dot g p)))) (raise-not-found who x p count)]
      [(<= (greatest p) (* tolerance (+ 1.0 (greatest x)))) (values x f count)]
      [(>= count limit) (raise-not-found who x p count)]
      [else
       (define-values (next f* g*) (line-search value-and-gradient x f g p))
       (cond
         [next (loop next (corrected H (difference next x) (difference g* g) (= count 0))
                     (+ count 1) (cons f* g*))]
         ;; no descent: either H has gone wrong, or rounding hides what is left
         [(not (unit? H)) (loop x (unit n) (+ count 1) (cons f g))]
         [else (values x f count)])])))

(define (raise-not-found who x p count)
  (raise-not-convergent who "no minimum found" (for/list ([u (in-flvector x)]) u) (greatest p)
                        "steps" count))

;; ---------------------------------------------------------------------------
;; The line

(define fair-part 1e-4)
(define halvings 40)

;; -> point, value and gradient where f has fallen enough, or #f three times
(define (line-search value-and-gradient x f g p)
  (define slope (dot g p))
  (let loop ([a 1.0] [left halvings])
    (define next (along x a p))
    (define-values (f* g*) (value-and-gradient next))
    (cond [(and (finite? f*) (<= f* (+ f (* fair-part a slope))) (< slope 0.0))
           (values next f* g*)]
          [(= left 0) (values #f #f #f)]
          [else (loop (* 0.5 a) (- left 1))])))

;; ---------------------------------------------------------------------------
;; The matrix, as a vector of rows

(define (unit n) (scaled-unit n 1.0))

(define (scaled-unit n c)
  (for/vector #:length n ([i (in-range n)])
    (define row (make-flvector n))
    (flvector-set! row i c)
    row))

(define (unit? H)
  (for/and ([row (in-vector H)] [i (in-naturals)])
    (for/and ([x (in-flvector row)] [j (in-naturals)]) (= x (if (= i j) 1.0 0.0)))))

;; Before the first correction, H is given the size of the curvature met.
(define (corrected H s y first?)
  (define ys (dot y s))
  (define yy (dot y y))
  (if (> ys (* 1e-14 (sqrt (* yy (dot s s)))))
      (correct (if first? (scaled-unit (flvector-length s) (/ ys yy)) H) s y (/ 1.0 ys))
      H))

;; Written out, H is symmetric: H − ρ (s (Hy)ᵀ + (Hy) sᵀ) + ρ (1 + ρ y·Hy) s sᵀ.
(define (correct H s y rho)
  (define Hy (product H y))
  (define c (* rho (+ 1.0 (* rho (dot y Hy)))))
  (for/vector #:length (vector-length H)
              ([row (in-vector H)] [si (in-flvector s)] [hi (in-flvector Hy)])
    (for/flvector #:length (flvector-length s)
                  ([h (in-flvector row)] [sj (in-flvector s)] [hj (in-flvector Hy)])
      (+ (- h (* rho (+ (* si hj) (* hi sj)))) (* c si sj)))))

(define (product H v)
  (for/flvector #:length (flvector-length v) ([row (in-vector H)]) (dot row v)))
(define (negative-product H v)
  (for/flvector #:length (flvector-length v) ([x (in-flvector (product H v))]) (- x)))

;; ---------------------------------------------------------------------------
;; Vectors

(define (finite? x) (fl< (flabs x) +inf.0))
(define (dot v w)
  (for/fold ([sum 0.0]) ([x (in-flvector v)] [y (in-flvector w)]) (fl+ sum (fl* x y))))
(define (along x a p)
  (for/flvector #:length (flvector-length x) ([u (in-flvector x)] [v (in-flvector p)])
    (fl+ u (fl* a v))))
(define (difference v w) (along v -1.0 w))
(define (greatest v) (for/fold ([m 0.0]) ([x (in-flvector v)]) (max m (abs x))))
