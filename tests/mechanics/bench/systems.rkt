#lang racket/base
;; The mechanical systems of the benchmarks, as a user would write them.

(require mechanics)

(provide chain-Lagrangian chain-path
         rigid-body-Lagrangian Euler-path)

(define (numbered name i) (string->symbol (format "~a~a" name i)))
(define (numbered-list name n)
  (for/list ([i (in-range 1 (+ n 1))]) (numbered name i)))

;; ---------------------------------------------------------------------------
;; A chain of n pendulums, each hanging from the one before: masses m1 ...,
;; lengths l1 ..., angles from the vertical.

(define ((L-particles masses g) local)
  (define q (coordinate local))
  (define v (velocity local))
  (apply + (for/list ([m (in-list masses)] [i (in-naturals)])
             (- (* 1/2 m (square (ref v i)))
                (* m g (ref q i 1))))))

(define ((angles->positions lengths) local)
  (define theta (coordinate local))
  (let loop ([ls lengths] [i 0] [x 0] [y 0] [positions '()])
    (if (null? ls)
        (apply up (reverse positions))
        (let ([x (+ x (* (car ls) (sin (ref theta i))))]
              [y (- y (* (car ls) (cos (ref theta i))))])
          (loop (cdr ls) (+ i 1) x y (cons (up x y) positions))))))

(define (chain-Lagrangian n)
  (compose (L-particles (numbered-list 'm n) 'g)
           (F->C (angles->positions (numbered-list 'l n)))))

(define (chain-path n)
  (apply up (map literal-function (numbered-list 'theta n))))

;; ---------------------------------------------------------------------------
;; A free rigid body with principal moments A, B, C, in Euler angles (SICM 2.8).

(define ((rigid-body-Lagrangian A B C) (up t (up theta phi psi) (up thetadot phidot psidot)))
  (define omega-a (+ (* phidot (sin theta) (sin psi)) (* thetadot (cos psi))))
  (define omega-b (- (* phidot (sin theta) (cos psi)) (* thetadot (sin psi))))
  (define omega-c (+ (* phidot (cos theta)) psidot))
  (* 1/2 (+ (* A (square omega-a)) (* B (square omega-b)) (* C (square omega-c)))))

(define (Euler-path)
  (up (literal-function 'theta) (literal-function 'phi) (literal-function 'psi)))
