#lang racket/base
;; Canonical transformations, Lie series and normal forms.
;;
;; The library of the room is loaded by the task, as a reader meets it.

(require (prefix-in m: mechanics)
         (only-in mechanics/book H-central-polar H-arbitrary C-rotating)
         "task.rkt")

(provide canonical-tasks Lie-terms normal-form)

(define plane (m:up 't (m:up 'x 'y) (m:down 'p_x 'p_y)))
(define space (m:up 't (m:up 'x 'y 'z) (m:down 'p_x 'p_y 'p_z)))

;; The first n terms of the Lie series of the coordinates in a central potential, simplified
(define (Lie-terms n)
  (define H (H-central-polar 'm (m:literal-function 'U)))
  (define state (m:up 0 (m:up 'r_0 'phi_0) (m:down 'p_r_0 'p_phi_0)))
  (m:simplify (m:series:head (((m:Lie-transform H 'dt) m:coordinate) state) n)))

;; Any transformation of the coordinates of a state, extended to phase space
(define (arbitrary-symplectic names state)
  (define n (length names))
  (define signature (m:-> (apply m:X (for/list ([_ (in-range n)]) m:Real)) m:Real))
  (define fs (for/list ([name (in-list names)]) (m:literal-function name signature)))
  (define (F s)
    (define qs (m:vector->list (m:structure->vector (m:coordinate s))))
    (apply m:up (for/list ([f (in-list fs)]) (apply f qs))))
  (m:simplify ((m:symplectic-transform? (m:F->CH F)) state)))

(define (turning-frame) (m:simplify ((m:canonical-H? (C-rotating 'n) H-arbitrary) space)))

(define (Henon-Heiles s)
  (define-values (x y) (values (m:ref s 1 0) (m:ref s 1 1)))
  (m:+ (m:* 1/2 (m:+ (m:square (m:momentum s)) (m:square x) (m:square y)))
       (m:* (m:square x) y)
       (m:* -1/3 (m:cube y))))

(define (normal-form degree) (m:Birkhoff-normal-form Henon-Heiles plane #:degree degree))

(define canonical-tasks
  (list
   (make-task 'C1 "Lie series of the coordinates in a central potential, 4 terms, simplified"
              (lambda () (Lie-terms 4)))
   (make-task 'C2 "the same, 8 terms" (lambda () (Lie-terms 8)))
   (make-task 'C3 "any transformation of 2 coordinates is symplectic, simplified"
              (lambda () (arbitrary-symplectic '(f g) plane)))
   (make-task 'C4 "any transformation of 3 coordinates is symplectic, simplified"
              (lambda () (arbitrary-symplectic '(f g h) space)))
   (make-task 'C5 "a turning frame is canonical for any Hamiltonian in space, simplified"
              turning-frame)
   (make-task 'C6 "normal form of Hénon and Heiles to degree 8" (lambda () (normal-form 8)))))
