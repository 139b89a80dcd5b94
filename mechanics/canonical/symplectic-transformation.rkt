#lang racket/base
;; Symplectic matrices and transformations (SICM 5.2.2, 5.3).
;;
;; With the states q, p in a row, J = (0 1; −1 0); the derivatives M of a transformation by q and
;; p keep Poisson brackets if J − M J Mᵀ = 0, of which the entries are those brackets: with the
;; components z of the old state
;;
;;     (M J Mᵀ)ᵢⱼ = Σ ∂zᵢ/∂q' ∂zⱼ/∂p' − ∂zᵢ/∂p' ∂zⱼ/∂q' = {zᵢ, zⱼ}.
;;
;; J − M J Mᵀ is antisymmetric: n (2n − 1) brackets decide.

(require (only-in racket/vector vector-drop)
         "transformation.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/printed-function.rkt"
         "../generic/sums-and-products.rkt" "../generic/up-down.rkt"
         "../generic/wrong-argument.rkt"
         "../hamiltonian/H-state.rkt"
         "../lagrangian/local-tuple.rkt"
         "../value/shape.rkt"
         "../value/matrix/matrix.rkt")

(provide J-matrix symplectic-unit symplectic-matrix? symplectic? symplectic-transform?
         canonical-transform? qp-submatrix D-as-matrix symplectic-two-form
         ;; for verdicts
         matrix-residual)

;; ---------------------------------------------------------------------------
;; Matrices

;; The matrix J of a state of n coordinates, with a row and a column for the time (p. 353)
(define (J-matrix n)
  (check-count 'J-matrix n)
  (m:generate (+ n n 1) (+ n n 1) (lambda (i j) (timed-J-entry n i j))))

;; Without these: Jₙ, 2n by 2n (p. 355)
(define (symplectic-unit n)
  (check-count 'symplectic-unit n)
  (m:generate (* 2 n) (* 2 n) (lambda (i j) (J-entry n i j))))

(define (check-count who n)
  (check-argument who exact-positive-integer? n "a number of coordinates, at least 1"))

(define (J-entry n i j)
  (cond [(= j (+ i n)) 1]
        [(= i (+ j n)) -1]
        [else 0]))

;; With a row and a column of zeros before the others
(define (timed-J-entry n i j)
  (if (or (= i 0) (= j 0)) 0 (J-entry n (- i 1) (- j 1))))

;; J − M J Mᵀ, all zero if M is symplectic
(define (symplectic-matrix? M) (matrix-residual 'symplectic-matrix? M))

(define (matrix-residual who M)
  (unless (and (matrix? M) (= (m:num-rows M) (m:num-cols M)) (even? (m:num-rows M)))
    (complain who
              "a symplectic matrix is square, with an even number of rows; given ~a~a"
              (describe-with-value M)
              (if (and (pair? M) (andmap list? M))
                  "\n  rows make a matrix by matrix-by-rows: (apply matrix-by-rows rows)"
                  "")))
  (excess (matrix-rows M)))

;; rows : vector of vectors of an even number of entries -> J less their brackets
(define (excess rows)
  (define n (quotient (vector-length (vector-ref rows 0)) 2))
  (define table (bracket-table rows n))
  (m:generate (* 2 n) (* 2 n) (lambda (i j) (g:- (J-entry n i j) (entry table i j)))))

;; rows -> the brackets above the diagonal, for `entry`
(define (bracket-table rows n)
  (for/vector ([a (in-vector rows)] [i (in-naturals)])
    (for/vector ([b (in-vector rows)] [j (in-naturals)])
      (if (< i j) (bracket a b n) 0))))

(define (entry table i j)
  (cond [(< i j) (vector-ref (vector-ref table i) j)]
        [(> i j) (g:negate (vector-ref (vector-ref table j) i))]
        [else 0]))

;; a, b : derivatives by n coordinates and n momenta
(define (bracket a b n)
  (g:for/sum ([k (in-range n)])
    (g:- (g:* (vector-ref a k) (vector-ref b (+ k n)))
         (g:* (vector-ref a (+ k n)) (vector-ref b k)))))

;; ---------------------------------------------------------------------------
;; Derivatives of transformations as matrices

;; ((D-as-matrix F) state) : a row for each scalar of the value, a column for each of the state
(define-printed (D-as-matrix F)
  (check-transformation 'D-as-matrix F)
  (lambda (state)
    (apply matrix-by-rows (rows-of-derivatives F state))))

;; -> for each scalar of F(state) the list of its derivatives by the scalars of the state
(define (rows-of-derivatives F state)
  (define-values (_image slopes) (image-and-slopes F state))
  (apply map list (map scalars slopes)))

;; The matrix without the row and the column of the time.
(define (qp-submatrix M)
  (unless (and (matrix? M) (> (m:num-rows M) 1) (> (m:num-cols M) 1))
    (complain-of-argument 'qp-submatrix "a matrix with a row and a column for the time" M))
  (m:submatrix M 1 (m:num-rows M) 1 (m:num-cols M)))

;; ---------------------------------------------------------------------------
;; Transformations

;; ((symplectic-transform? C) state) : 2n by 2n, without the time
(define (symplectic-transform? C)
  (of-rows 'symplectic-transform? C (lambda (rows state) (excess (vector-drop rows 1)))))

;; ((symplectic? C) state) : the same with a row and a column for the time
(define (symplectic? C)
  (of-rows 'symplectic? C
           (lambda (rows state)
             (define n (degrees-of-freedom state))
             (define table (bracket-table rows n))
             (m:generate (+ n n 1) (+ n n 1)
                         (lambda (i j) (g:- (timed-J-entry n i j) (entry table i j)))))))

;; ((canonical-transform? C) state) : the brackets of the components of C less those of the
;; state, as a structure of structures, each of the shape of the state (p. 351)
(define (canonical-transform? C)
  (of-rows 'canonical-transform? C
           (lambda (rows state)
             (define n (degrees-of-freedom state))
             (define table (bracket-table rows n))
             (scalars->structure
              state
              (lambda (i)
                (scalars->structure
                 state
                 (lambda (j) (g:- (entry table i j) (timed-J-entry n i j)))))))))

;; (make rows state) : rows, of the scalars of C(state), of their derivatives by q and p
(define (of-rows who C make)
  (when (matrix? C)
    (complain who "expected a transformation; a matrix is asked about by (symplectic-matrix? M)"))
  (define checked (checked-transformation who C))
  (unary-function (call-datum who C) (state)
    (check-H-state who state)
    (make (for/vector ([row (in-list (rows-of-derivatives checked state))])
            (list->vector (cdr row)))
          state)))

;; ---------------------------------------------------------------------------
;; The two-form

;; ω(ζ₁, ζ₂) = p₂ q₁ − p₁ q₂ of two increments of a state
(define (symplectic-two-form zeta1 zeta2)
  (check-H-state 'symplectic-two-form zeta1)
  (check-H-state 'symplectic-two-form zeta2)
  (unless (same-shape? zeta1 zeta2)
    (complain 'symplectic-two-form "the increments are of states of different shapes: ~a and ~a"
              (describe-with-value zeta1) (describe-with-value zeta2)))
  (g:- (g:* (momentum zeta2) (coordinate zeta1))
       (g:* (momentum zeta1) (coordinate zeta2))))
