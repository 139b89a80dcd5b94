#lang racket/base
;; Rotations, and frames that turn or accelerate.

(require mechanics
         mechanics/scmutils
         (only-in mechanics/book L-free-particle)
         "../support/checks.rkt" "../support/random.rkt" "../support/session.rkt")

(define plane (up 't (up 'x 'y) (up 'vx 'vy)))
(define space (up 't (up 'x 'y 'z) (up 'vx 'vy 'vz)))

;; ---------------------------------------------------------------------------
;; Rotations

(test-case "each axis stays, the next one goes to the one after"
  (for ([R (list Rx Ry Rz)] [i 3])
    (define (axis k) (apply up (for/list ([j 3]) (if (= j (modulo k 3)) 1 0))))
    (check-identity ((R 'a) (axis i)) (axis i))
    (check-identity ((R 'a) (axis (+ i 1)))
                    (+ (* (cos 'a) (axis (+ i 1))) (* (sin 'a) (axis (+ i 2)))))))

(test-case "rotations about one axis add up, keep lengths and undo each other"
  (define v (up 'x 'y 'z))
  (for ([R (list Rx Ry Rz)])
    (check-identity ((compose (R 'a) (R 'b)) v) ((R (+ 'a 'b)) v))
    (check-identity ((compose (R 'a) (R (- 'a))) v) v)
    (check-identity (square ((R 'a) v)) (square v))))

(test-case "the derivative of a rotation at 0 is the product with its axis"
  (define v (up 'x 'y 'z))
  (for ([R (list Rx Ry Rz)] [axis (list (up 1 0 0) (up 0 1 0) (up 0 0 1))])
    (check-identity ((D (lambda (s) ((R s) v))) 0) (cross-product axis v))))

(test-case "a down tuple stays down"
  (check-identity ((Rz 'a) (down 'p 'q 'r))
                  (down (- (* 'p (cos 'a)) (* 'q (sin 'a)))
                        (+ (* 'p (sin 'a)) (* 'q (cos 'a)))
                        'r)))

(test-case "a rotation prints as what was typed and names what it cannot turn"
  (check-equal? (format "~a" (Rx 'a)) "(Rx a)")
  (check-exn #rx"^Ry: expected a tuple of 3 coordinates; given [(]up 1 2[)], an up tuple of 2$"
             (lambda () ((Ry 'a) (up 1 2))))
  (check-exn
   #rx"^Rx: expected a tuple of 3 coordinates; given [(]up t [(]up x y z[)].*\n  of a local tuple: [(]compose [(]Rx a[)] coordinate[)]$"
   (lambda () ((Rx 'a) space)))
  (define path (up (literal-function 'x) (literal-function 'y) (literal-function 'z)))
  (check-identity (((Rx 'a) path) 't) ((Rx 'a) (path 't))))

;; ---------------------------------------------------------------------------
;; Frames

(test-case "there and back is the identity, for symbols"
  (for ([there (list (rotating->inertial 'Omega) (accelerated->inertial (up 'a 'b)))]
        [back (list (inertial->rotating 'Omega) (inertial->accelerated (up 'a 'b)))])
    (check-identity ((compose (F->C there) (F->C back)) plane) plane)
    (check-identity ((compose (F->C back) (F->C there)) plane) plane))
  (check-identity ((compose (F->C (rotating->inertial 'Omega)) (F->C (inertial->rotating 'Omega)))
                   space)
                  space))

(test-case "there and back is the identity at random points, for every pair of names"
  (define (random-tuple n)
    (apply up (for/list ([_ n]) (random-flonum))))
  (with-seed 20
    (for ([pair (list (list p->r r->p 2) (list polar->rectangular rectangular->polar 2)
                      (list s->r r->s 3) (list spherical->rectangular rectangular->spherical 3)
                      (list (rotating->inertial 0.7) (inertial->rotating 0.7) 3)
                      (list (accelerated->inertial (up 1 2)) (inertial->accelerated (up 1 2)) 2))]
          #:when #t
          [_ 20])
      (define-values (F G n) (apply values pair))
      (define local (up (random-flonum) (random-tuple n) (random-tuple n)))
      (define back ((compose (F->C F) (F->C G)) local))
      (define distance (- back local))
      (check-true (< (sqrt (+ (square (ref distance 0)) (square (ref distance 1))
                              (square (ref distance 2))))
                     1e-12)
                  (format "~a ~a" F local)))))

(test-case "named pairs of coordinates are inverse, for symbols"
  (define (back-again C local) (verdict-status (verify-equal (C local) local)))
  (check-eq? (back-again (compose (F->C p->r) (F->C r->p)) plane) 'proved)
  (check-eq? (back-again (compose (F->C s->r) (F->C r->s)) space) 'proved))

(test-case "free motion in a rotating frame feels Coriolis and centrifugal forces (p. 48)"
  (define L (compose (L-free-particle 'm) (F->C (rotating->inertial 'Omega))))
  (check-identity ((Lagrangian->acceleration L) plane)
                  (up (+ (* 2 'Omega 'vy) (* (square 'Omega) 'x))
                      (+ (* -2 'Omega 'vx) (* (square 'Omega) 'y))))
  (check-identity (ref ((Lagrangian->acceleration L) space) 2) 0))

(test-case "free motion in an accelerated frame falls (the equivalence principle)"
  (define L (compose (L-free-particle 'm) (F->C (accelerated->inertial (up 0 'g)))))
  (check-identity ((Lagrangian->acceleration L) plane) (up 0 (- 'g)))
  (define one (compose (L-free-particle 'm) (F->C (accelerated->inertial 'g))))
  (check-identity ((Lagrangian->acceleration one) (up 't 'x 'v)) (- 'g)))

(test-case "frames print as what was typed and name what they cannot turn"
  (check-equal? (format "~a ~a" (rotating->inertial 'Omega) (inertial->accelerated 'g))
                "(rotating->inertial Omega) (inertial->accelerated g)")
  (check-exn
   #rx"^rotating->inertial: expected a local tuple with 2 or 3 coordinates; given [(]up t x v[)]"
   (lambda () ((rotating->inertial 'Omega) (up 't 'x 'v)))))
