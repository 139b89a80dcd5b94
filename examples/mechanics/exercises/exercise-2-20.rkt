#lang mechanics
;; Exercise 2.20 (SICM 2.12): a free body by quaternions
;; Checked: the motion of the book's body, and what it keeps
;; How: against Euler angles, and against what is proved to be conserved

;; Follow a free rigid body with a quaternion for its orientation, and compare with the motion in
;; Euler angles: where it is after 100 s, and how well energy and angular momentum are kept.

(require mechanics/book)

(define-values (A B C) (values 1. (sqrt 2.) 2.))
(define in-angles (up 0 (up 1. 0. 0.) (up 0.1 0.1 0.1)))
(define start
  (up 0
      (quaternion->vector (rotation-matrix->quaternion (Euler->M (coordinate in-angles))))
      (Euler-state->omega-body in-angles)))

(define end ((evolve qw-sysder A B C) start void 10. 100. 1e-13))
(define end-in-angles ((evolve rigid-sysder A B C) in-angles void 10. 100. 1e-13))
(define (turned-by-quaternion v) (* (quaternion->rotation-matrix (make-quaternion (ref end 1))) v))
(define (turned-by-angles v) (* (Euler->M (ref end-in-angles 1)) v))
(define (length v) (sqrt (square v)))
(define difference (length (- (turned-by-quaternion (up 1 2 3)) (turned-by-angles (up 1 2 3)))))
(< difference 1e-10)

;; Relative errors at the end.
(define energy (T-body A B C))
(define momentum (qw-state->L-space A B C))
(define errors
  (cons (relative-error (energy (ref end 2)) (energy (ref start 2)))
        (for/list ([i 3]) (relative-error (ref (momentum end) i) (ref (momentum start) i)))))
(for/and ([e errors]) (< (abs e) 1e-12))

;; They are rounding: the rates vanish.
(define state (up 't (up 'q_0 'q_1 'q_2 'q_3) (up 'omega^a 'omega^b 'omega^c)))
(define (rate f) (* ((D f) state) ((qw-sysder 'A 'B 'C) state)))
(define right (prove-zero (rate (qw-state->L-space 'A 'B 'C))))
right

;; A slip: the angular momentum as the body sees it, which turns.
(define wrong (prove-zero (rate (qw-state->L-body 'A 'B 'C))))
(verdict-status wrong)
(verdict-residual wrong)

(module+ test
  (require rackunit)
  (test-case "the same place"
    (check-= difference 0 1e-10)
    (check-= (ref end 1 0) -.9501831654548522 1e-10))
  (test-case "conserved, to rounding and by proof"
    (for ([e errors]) (check-= e 0 1e-12))
    (check-pred proved? right))
  (test-case "on the body only the length is kept"
    (check-pred refuted? wrong)
    (define (length^2 s) (square ((qw-state->L-body 'A 'B 'C) s)))
    (check-pred proved? (prove-zero (rate length^2)))))
