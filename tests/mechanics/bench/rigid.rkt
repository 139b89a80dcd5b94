#lang racket/base
;; Rigid bodies: what the book proves of them, and a motion without a pole.
;;
;; The library of the room is loaded by the task, as a reader meets it.

(require (prefix-in m: mechanics)
         (only-in "systems.rkt" Euler-path Euler-state)
         "task.rkt")

(provide rigid-tasks)

(define (symbolic-quaternion . parts) (m:make-quaternion parts))
(define (p) (symbolic-quaternion 'p_0 'p_1 'p_2 'p_3))
(define (q) (symbolic-quaternion 'q_0 'q_1 'q_2 'q_3))

;; From the matrix of three rotations along a literal path to ω on the body
(define (omega-from-matrix)
  (m:simplify (((m:M-of-q->omega-body-of-t m:Euler->M) (Euler-path)) 't)))

(define (momentum-conserved)
  (m:verify-conserved (m:T-body-Euler 'A 'B 'C) (m:L-space-Euler 'A 'B 'C) (Euler-state)))

(define (matrix-of-a-product)
  (m:verify-equal (m:quaternion->rotation-matrix (m:* (p) (q)))
                  (m:* (m:quaternion->rotation-matrix (p)) (m:quaternion->rotation-matrix (q)))))

(define (turned-quaternion)
  ((m:state-advancer m:qw-sysder 1.0 (sqrt 2.0) 2.0)
   (m:up 0.0 (m:up 1.0 0.0 0.0 0.0) (m:up 0.1 0.1 0.1)) 100.0 1e-13))

(define rigid-tasks
  (list
   (make-task 'R6 "angular velocity of a body from the matrix of its Euler angles, simplified"
              omega-from-matrix)
   (make-task 'R5 "the angular momentum of a free rigid body is conserved, proved"
              momentum-conserved #:size m:verdict-status)
   (make-task 'Q1 "the matrix of a product of quaternions is the product, proved"
              matrix-of-a-product #:size m:verdict-status)
   (make-task 'Q2 "free rigid body as a quaternion to t = 100, error 1e-13" turned-quaternion)))
