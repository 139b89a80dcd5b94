#lang racket/base
;; Modes of M ẍ + G ẋ + K x = 0 for matrices of numbers.
;;
;; Without G the pencil is symmetric: with M = L Lᵀ (Cholesky) the squares of the
;; frequencies are the eigenvalues of L⁻¹ K L⁻ᵀ, and L⁻ᵀ turns its eigenvectors into shapes.
;; With G the equation is made one of
;; first order in (x, ẋ), whose eigenvalues λ = iω come in pairs of opposite ones; of
;; each pair the one with ω to the right is taken, and its shape is a null vector.

(require racket/flonum
         racket/list
         "definiteness.rkt" "flonum-systems.rkt" "general-eigenvalues.rkt" "row-matrix.rkt"
         "symmetric-eigenvalues.rkt"
         "../flvector.rkt")

(provide symmetric-modes gyroscopic-modes
         ;; for modes that are refined
         (struct-out mode) pencil-modes mode-terms frequency+shape)

;; M, K : vectors of rows of real numbers; M positive definite
;; -> a list of (frequency component ...), from slow to fast, or #f if M is not;
;;    frequencies that are imaginary grow and decay
(define (symmetric-modes M K)
  (define modes (pencil-modes M K))
  (and modes (map (lambda (m) (frequency+shape (mode-square m) (mode-within m) (mode-shape m)))
                  modes)))

;; ω², its error by rounding, and the shape x, a list, with x·M x = 1
(struct mode (square within shape) #:authentic)

;; Zero frequencies are found but for rounding.
(define (frequency+shape square within shape)
  (cons (sqrt (if (<= (abs square) within) 0.0 square)) (first-one shape)))

;; -> a list of modes, from slow to fast, or #f if M is not positive definite
(define (pencil-modes M K)
  (define n (vector-length M))
  (define L (Cholesky M))
  (and L
       (let*-values ([(G) (triangular-inverse (rows-transpose L))]
                     [(C) (rows->flvector
                           (symmetric-rows (product (rows-transpose G) (product K G))))]
                     [(squares vectors) (symmetric-eigenvalues C n)])
         (for/list ([square (in-flvector squares)] [v (in-list vectors)])
           (define shape
             (for/list ([row (in-vector G)])
               (for/fold ([s 0.0]) ([x (in-vector row)] [y (in-flvector v)]) (+ s (* x y)))))
           (mode square (* 1e-14 n (mode-terms M K square shape)) shape)))))

;; ω² is x·K x with the shape x: the sizes of its terms, and of those that M contributes.
(define (mode-terms M K square shape)
  (define (terms rows)
    (for*/sum ([(row x) (in-parallel (in-vector rows) (in-list shape))]
               [(k y) (in-parallel (in-vector row) (in-list shape))])
      (abs (* x k y))))
  (+ (terms K) (* (abs square) (terms M))))

;; The multiple with first component 1; components that are but rounding beside it become 0.
(define (first-one components)
  (define greatest (apply max (map magnitude components)))
  (define head (findf (lambda (x) (> (magnitude x) (* 1e-12 greatest))) components))
  (define limit (* 1e-12 (/ greatest (magnitude head))))
  (for/list ([x (in-list components)]) (without-rounding (/ x head) limit)))

(define (without-rounding z limit)
  (define (part x) (if (<= (abs x) limit) 0.0 (real->double-flonum x)))
  (define-values (re im) (values (part (real-part z)) (part (imag-part z))))
  (if (= im 0.0) re (make-rectangular re im)))

;; ---------------------------------------------------------------------------

(define (gyroscopic-modes M K G)
  (define n (vector-length M))
  (and (Cholesky M)
       (let ([exponents (real-matrix-eigenvalues (first-order M K G n) (* 2 n))])
         (and exponents
              (let ([omegas (frequencies exponents n (singular? K))])
                (for/list ([omega (in-list omegas)] [before (in-list (repetitions omegas))])
                  (define A (at-frequency M K G omega n))
                  (define small (* 1e-12 (frequency-scale M K G omega)))
                  (cons omega (first-one (null-vector-of A n small before)))))))))

;; For each omega, how many before it are equal but for rounding.
(define (repetitions omegas)
  (for/list ([w (in-list omegas)] [k (in-naturals)])
    (for/sum ([u (in-list omegas)] [_ (in-range k)])
      (if (<= (magnitude (- w u)) (* 1e-9 (magnitude w))) 1 0))))

;; The size of the greatest term in K − ω²M + iωG.
(define (frequency-scale M K G omega)
  (define w (magnitude omega))
  (max (greatest-entry K) (* w w (greatest-entry M)) (* w (greatest-entry G))))

;; (x, ẋ)' = (ẋ, −M⁻¹(K x + G ẋ))
(define (first-order M K G n)
  (define right (floating-solutions M (beside K G)))
  (for*/flvector #:length (* 4 n n) ([i (in-range (* 2 n))] [j (in-range (* 2 n))])
    (cond [(< i n) (if (= j (+ i n)) 1.0 0.0)]
          [else (- (real->double-flonum (entry right (- i n) j)))])))

;; K x = 0 has solutions: there are frequencies 0.
(define (singular? K)
  (eq? 'singular (floating-solutions K (unit-rows (vector-length K) 1.0 0.0))))

;; One of each pair λ, −λ, as ω = −iλ, the real ones without the rounding beside them, which
;; frequencies 0 are altogether.
(define (frequencies exponents n zeros?)
  (define greatest (apply max 1e-300 (map magnitude exponents)))
  (define omegas
    (for/list ([z (in-list exponents)])
      (define size (if zeros? greatest (magnitude z)))
      (define (clean x) (if (<= (abs x) (* 1e-9 size)) 0.0 x))
      (make-rectangular (clean (imag-part z)) (clean (- (real-part z))))))
  (define moving (filter (lambda (w) (> (real-part w) 0.0)) omegas))
  (define still (sort (filter (lambda (w) (= (real-part w) 0.0)) omegas) > #:key imag-part))
  (define chosen (append (take still (- n (length moving))) moving))
  (sort (for/list ([w (in-list chosen)]) (if (= (imag-part w) 0.0) (real-part w) w))
        < #:key real-part))

(define (at-frequency M K G omega n)
  (for/vector #:length n ([i (in-range n)])
    (for/vector #:length n ([j (in-range n)])
      (+ (entry K i j) (* -1 omega omega (entry M i j)) (* +i omega (entry G i j))))))

;; Elimination with the greatest of all remaining entries as pivot leaves the least for the end,
;; where it counts as zero, as all do that are `small`.
;; -> the null vector number `before` from 0, a list
(define (null-vector-of A n small before)
  (define-values (rank columns) (eliminate-fully! A (- n 1) small))
  (vector->list (null-vector A columns rank (+ rank (modulo before (- n rank))))))
