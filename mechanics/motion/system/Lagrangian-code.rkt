#lang racket/base
;; The rates of a Lagrangian's motions, compiled from the Lagrangian itself.
;;
;; Lagrange's equations take second derivatives of L.  Run on placeholders as they are, these
;; make each part of L some n² times.  Here L is traced once, to a short list of instructions;
;; one sweep back over it gives ∂L/∂q and the momenta P = ∂L/∂v; one forwards over that, in
;; the direction (1, v, 0), the known part of dP/dt; and one in the direction of each velocity
;; a column of the mass matrix M, of which half is enough.  The rest is the system
;;
;;     M a = ∂L/∂q − ∂P/∂t − (∂P/∂q) v.
;;
;; Each scalar of q is a coordinate with its own equation, however q is made up of tuples.

(require racket/flonum
         (only-in racket/vector vector-copy)
         "check.rkt"
         "../../compile/program-builder.rkt" "../../compile/compile-function.rkt"
         "../../compile/program.rkt" "../../compile/derivative-sweep.rkt"
         "../../generic/up-down.rkt"
         "../../lagrangian/state-derivative.rkt"
         "../../numeric/flvector.rkt"
         "../../value/structure.rkt")

(provide Lagrangian-code
         ;; for those of constrained motions
         known-rates mass-matrix)

;; For less, the time saved is not worth a second way.
(define fewest-coordinates 6)

;; -> the compiled rates, or #f where the derivative is another one, or does not allow that
(define (Lagrangian-code who derivative state)
  (define y (state-vector who state))
  (and (Lagrangian-derivative? derivative)
       (local-state? state)
       (>= (flvector-length y) (+ 1 (* 2 fewest-coordinates)))
       (code-of-Lagrangian who derivative state y)))

(define (local-state? state)
  (and (structure? state)
       (= 3 (structure-length state))
       (real? (structure-ref state 0))
       (same-shape? (structure-ref state 1) (structure-ref state 2))))

(define (code-of-Lagrangian who derivative state y)
  (define L (Lagrangian-derivative-Lagrangian derivative))
  (define gradient (traced-gradient L state #:name who))
  (define q (and gradient (differentiable? gradient) (motion-program gradient)))
  (define shape (up 1 (structure-ref state 2) (structure-ref state 2)))
  (define code (and q (program->compiled-function q shape derivative)))
  (and code (flvector-finite? (code y)) code))

;; ---------------------------------------------------------------------------

;; gradient : the program of L and its derivatives by t, q and v -> that of (1, v, a)
(define (motion-program gradient)
  (define-values (b p) (reload gradient))
  (define inputs (program-inputs p))
  (define n (quotient (- inputs 1) 2))
  (define outputs (program-outputs p))
  (define (by-coordinate i) (vector-ref outputs (+ 2 i)))
  (define velocities (for/list ([i (in-range n)]) (place (+ 1 n i))))
  (define momenta (vector-copy outputs (+ 2 n)))
  (define known-rate (known-rates b p momenta))
  (define mass (mass-matrix b p momenta))
  (define (right i) (subtract! b (by-coordinate i) (known-rate (vector-ref momenta i))))
  (builder->program b inputs (cons 1 (append velocities (solve-with! b n mass right)))))

;; ---------------------------------------------------------------------------
;; Derivatives of momenta in a program of t, q and v

;; In the direction (1, v, 0): the rates of its values but for the accelerations.
;; b, p : reloaded (compile/derivative-sweep.rkt)
;; xs : vector of operands -> (one of them ↦ its rate)
(define (known-rates b p xs)
  (define inputs (program-inputs p))
  (define n (quotient (- inputs 1) 2))
  (define last (last-dependent p xs))
  (derivative-along b p
                    (lambda (k) (cond [(= k 0) 1] [(<= k n) (place (+ n k))] [else 0]))
                    (lambda (k) (>= (vector-ref last k) 0))))

;; In that of each velocity, those of the momenta: a column of the mass matrix.
;; momenta : vector of operands -> (i j ↦ entry), half of which are enough
(define (mass-matrix b p momenta)
  (define n (vector-length momenta))
  (define last (last-dependent p momenta))
  (define columns
    (for/vector #:length n ([j (in-range n)])
      (derivative-along b p
                        (lambda (k) (if (= k (+ 1 n j)) 1 0))
                        (lambda (k) (>= (vector-ref last k) j)))))
  (lambda (i j) ((vector-ref columns (min i j)) (vector-ref momenta (max i j)))))
