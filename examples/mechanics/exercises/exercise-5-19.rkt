#lang mechanics
;; Exercise 5.19 (SICM 5.5): the condition on K, in extended phase space
;; Checked: that K is right if the extended transformation is symplectic
;; How: the entries of its residual, for any transformation and any K

(define (any name) (literal-function name (Hamiltonian 1)))
(define-values (A B K) (values (any 'A) (any 'B) (any 'K)))
(define (C state) (up (time state) (A state) (B state)))
(define inner (up 't 'q 'p))
(define extended (up 's (up 't 'q) (down 'p_t 'p)))

;; (t, q', p_t', p') ↦ (t, A, p_t' + K, B): the brackets of p_t with q and p vanish if K corrects
;; C, the others if C is canonical by itself.
(define M ((symplectic-transform? (extended-transformation C K)) extended))
(define excess ((canonical-K? C K) inner))
(define right
  (verify-equal (up (matrix-ref M 2 1) (matrix-ref M 2 3))
                (up (- (coordinate excess)) (- (momentum excess)))))
right
(define of-C (verify-equal (matrix-ref M 1 3) (matrix-ref ((symplectic-transform? C) inner) 0 1)))
of-C

;; A frame that turns, with its K and without.
(define F (rotating->inertial 'Omega))
(define turning (up 's (up 't (up 'x 'y)) (down 'p_t (down 'p_x 'p_y))))
(define corrected (verify-symplectic (extended-transformation (F->CH F) (F->K F)) turning))
corrected

;; The slip: K left out.
(define slip
  (verify-symplectic (extended-transformation (F->CH F) (lambda (state) 0)) turning))
(list (verdict-status slip) (verdict-conditions slip))

(module+ test
  (require rackunit)
  (test-case "the two conditions are one"
    (for ([v (list right of-C corrected)]) (check-pred proved? v)))
  (test-case "without K it is symplectic at rest alone"
    (check-pred refuted? slip)
    (check-equal? (verdict-conditions slip) '((= Omega 0)))))
