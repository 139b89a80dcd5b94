#lang racket/base
;; The normal form of the quadratic part of a Hamiltonian at an equilibrium (Williamson 1936): a
;; symplectic matrix makes it a sum of
;;
;;     ω (q² + p²)/2,     λ q p,     α (q₁p₁ + q₂p₂) + β (q₁p₂ − q₂p₁)
;;
;; for exponents ±iω, ±λ and ±α ± iβ.  The sign of ω is that of the oscillator's energy.  It exists
;; if the motion is semisimple: if no two of equal exponents have but one direction together.
;;
;; Numbers are known to some rounding only.  A number as small as the tolerance, beside the entries
;; of the form in balanced units, is 0.  How far the form is from one that is not semisimple is
;; told in the same measure: up to the tolerance it counts as one, and up to the root of the
;; tolerance it is undecided, since less than half of the digits of the frequencies' difference
;; are left.

(require (only-in racket/string string-join)
         "phase-space-equilibrium.rkt" "quadratic-pair.rkt" "symplectic-modes.rkt"
         (only-in "../../algebra/expression/exact-numbers.rkt" to-digits)
         "../../error/complain.rkt"
         "../../generic/define-plain.rkt" "../../generic/describe.rkt"
         "../../generic/value-struct.rkt" "../../generic/wrong-argument.rkt"
         "../../numeric/linear-algebra/row-matrix.rkt"
         "../../value/matrix/matrix.rkt")

(provide symplectic-normal-form quadratic-normal-form?
         ;; for normal forms of higher degree
         form-of-matrix check-tolerance quadratic-normal-form-coordinates)

;; status : 'found, 'undecided or 'not-semisimple; blocks : datums such as (elliptic ω);
;; coordinates : the lists of those that a block takes; frequencies : of each coordinate;
;; matrix : old = matrix · new, or #f; distance : to the nearest form not semisimple, or #f
(value-struct quadratic-normal-form
              (status blocks coordinates frequencies matrix distance)
  #:text form->text)

(provide-parts quadratic-normal-form? "what symplectic-normal-form gives"
  quadratic-normal-form-status quadratic-normal-form-blocks quadratic-normal-form-frequencies
  quadratic-normal-form-matrix quadratic-normal-form-distance)

;; Of H at an equilibrium, or of the matrix of second derivatives by coordinates and momenta
(define-plain (symplectic-normal-form [H #f] [state #f] #:at [at #f] #:matrix [given #f]
                                      #:tolerance [tolerance 1e-12])
  (define who 'symplectic-normal-form)
  (check-tolerance who tolerance)
  (unless (if H (and state (not given)) (and given (not at)))
    (complain who (string-append "expected a Hamiltonian and a state of symbols, or the matrix of "
                                 "its second derivatives alone"
                                 "\n  (symplectic-normal-form H state #:at equilibrium)"
                                 "\n  (symplectic-normal-form #:matrix m)")))
  (form-of-matrix (if given
                      (checked-rows who given)
                      (second-derivatives who H state (equilibrium-of who H state at)))
                  tolerance))

(define (check-tolerance who tolerance)
  (unless (and (real? tolerance) (<= 1e-16 tolerance 1e-6))
    (complain-of-argument who "a tolerance from 1e-16 to 1e-6, relative to the quadratic terms"
                          tolerance)))

(define (checked-rows who m)
  (define rows (and (matrix? m) (matrix-rows m)))
  (unless (and rows (all-entries? rational? rows) (even? (vector-length rows))
               (= (vector-length rows) (row-length rows))
               (for*/and ([i (in-range (vector-length rows))] [j (in-range i)])
                 (<= (abs (- (entry rows i j) (entry rows j i)))
                     (* 1e-13 (greatest-entry rows)))))
    (complain-of-argument who (string-append "a symmetric matrix of numbers, with a row for each "
                                             "coordinate and each momentum") m))
  rows)

;; rows : of numbers
(define (form-of-matrix rows tolerance)
  (define n (quotient (vector-length rows) 2))
  (define found (let/ec stop (symplectic-modes rows tolerance stop)))
  (define (by-coordinate part)
    (for*/hasheqv ([p (in-list found)]
                   [(j x) (in-parallel (placed-coordinates p) (part (placed-block p)))])
      (values j x)))
  (define (in-order part)
    (define table (by-coordinate part))
    (for/list ([j (in-range n)]) (hash-ref table j)))
  (if (trouble? found)
      (quadratic-normal-form (trouble-status found) '() '() (trouble-frequencies found) #f
                             (trouble-distance found))
      (quadratic-normal-form
       'found
       (for/list ([p (in-list found)]) (block-datum (block-frequencies (placed-block p))))
       (map placed-coordinates found)
       (in-order block-frequencies)
       (matrix (rows-transpose (list->vector (append (in-order block-qs) (in-order block-ps)))))
       #f)))

(define (block-datum frequencies)
  (define w (car frequencies))
  (define-values (growth turn) (values (imag-part w) (- (real-part w))))
  (cond [(eqv? w 0) '(zero)]
        [(real? w) (list 'elliptic w)]
        [(null? (cdr frequencies)) (list 'hyperbolic growth)]
        [else (list 'complex growth turn)]))

;; ---------------------------------------------------------------------------
;; In words

(define (form->text f)
  (case (quadratic-normal-form-status f)
    [(found)
     (apply string-append "symplectic normal form"
            (for/list ([b (in-list (quadratic-normal-form-blocks f))]
                       [js (in-list (quadratic-normal-form-coordinates f))])
              (format "\n  ~a: ~a" (if (null? (cdr js)) (format "coordinate ~a" (car js))
                                       (format "coordinates ~a and ~a" (car js) (cadr js)))
                      (block->text b))))]
    [else (trouble->text f)]))

(define (block->text b)
  (case (car b)
    [(zero) "no energy"]
    [(elliptic) (format "elliptic, ~a (q² + p²)/2" (cadr b))]
    [(hyperbolic) (format "hyperbolic, ~a q p" (cadr b))]
    [else (format "complex, ~a (q₁p₁ + q₂p₂) + ~a (q₁p₂ − q₂p₁)" (cadr b) (caddr b))]))

(define (trouble->text f)
  (format "~a\n  frequencies: ~a\n  distance to terms that are not, beside the greatest: ~a"
          (if (eq? (quadratic-normal-form-status f) 'undecided)
              "undecided whether the quadratic terms are semisimple"
              "the quadratic terms are not semisimple, and have no normal form")
          (string-join (for/list ([w (in-list (quadratic-normal-form-frequencies f))])
                         (value->text (shortened w 9)))
                       " and ")
          (shortened (quadratic-normal-form-distance f) 2)))

(define (shortened z digits)
  (define (part x) (if (exact? x) x (to-digits x digits)))
  (if (real? z) (part z) (make-rectangular (part (real-part z)) (part (imag-part z)))))
