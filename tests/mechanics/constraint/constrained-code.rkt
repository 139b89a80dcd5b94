#lang racket/base
;; Constrained motions compiled from the instructions of Lagrangian and constraints: the same as
;; those of the generic arithmetic, kept with their state derivative, and never stale.

(require racket/flonum
         mechanics
         (only-in mechanics/constraint/constrained-code constrained-code rates-code position-code)
         (only-in mechanics/constraint/constraint gather)
         (only-in mechanics/motion/system/make-system make-system)
         (only-in mechanics/motion/system/system system-make-jacobian!)
         (only-in mechanics/value/shape structure->flvector flvector->structure shape-length)
         "../support/checks.rkt")

(define (random-vector n) (for/flvector #:length n ([_ (in-range n)]) (+ 0.2 (random))))

(define (check-close xs ys tolerance)
  (for ([x (in-flvector xs)] [y (in-flvector ys)]) (check-= x y (* tolerance (+ 1 (abs y))))))

(define (numbers s) (structure->flvector s raise))

;; A decision ends the trace; what is decided by is no matter.
(define ((not-traced f) s) (if (< (time s) 1e9) (f s) 0))

;; The rates at random states, and a state on the constraints, are those of the generic way.
(define (check-code L constraints count example #:force [Q #f])
  (define f (constrained-state-derivative L constraints #:force Q))
  (define c
    (constrained-code 'test L (gather 'test constraints) Q (build-list count values) f example))
  (for ([_ (in-range 3)])
    (define v (random-vector (shape-length example)))
    (check-close ((rates-code c) v) (numbers (f (flvector->structure example v))) 1e-9))
  (define start ((consistent-state L constraints) example))
  (check-close (numbers start) (numbers ((consistent-state (not-traced L) constraints) example))
               1e-12)
  (define (final L)
    (numbers (trajectory-final-state
              (evolve-trajectory (constrained-state-derivative L constraints #:force Q) start 1/5
                                 #:method 'Dormand-Prince-853))))
  (check-close (final L) (final (not-traced L)) 1e-9)
  c)

(define ((L-mass m) (up t q v)) (- (* 1/2 m (square v)) (* 9.8 m (ref q 1))))
(define (rod l) (holonomic (lambda (t q) (- (sqrt (square q)) l))))

(random-seed 717)

(test-case "one constraint, and several on one body"
  (check-code (L-mass 2) (rod 1) 1 (up 0 (up 0.6 0.7) (up 0.3 0.2)))
  (define (rods t q)
    (up (- (+ (square (ref q 0)) (square (ref q 1))) 1)
        (- (+ (square (- (ref q 2) (ref q 0))) (square (- (ref q 3) (ref q 1)))) 1)))
  (void (check-code (L-mass 1) (holonomic rods) 2 (up 0 (up 0.6 0.7 1.5 0.3) (up 0.3 0.2 0 0.4)))))

(test-case "a constraint that moves, a force, a potential of the time"
  (define moving (holonomic (lambda (t q) (- (ref q 1) (* (sin t) (ref q 0))))))
  (define (L s) (+ ((L-mass 3) s) (* (cos (time s)) (ref (coordinate s) 0))))
  (define (drag s) (* -1 (flip (velocity s))))
  (define (flip v) (down (ref v 0) (ref v 1)))
  (void (check-code L moving 1 (up 0.2 (up 0.6 0.7) (up 0.3 0.2)) #:force drag))
  (void (check-code L moving 1 (up 0.2 (up 0.6 0.7) (up 0.3 0.2)) #:force (lambda (s) 0))))

(test-case "nonholonomic ones, beside holonomic ones"
  (define (L (up t q v)) (+ (* 1/2 (square v)) (* 3 (ref q 0))))
  (define blade (nonholonomic (lambda (t q v) (- (* (ref v 0) (sin (ref q 2)))
                                                 (* (ref v 1) (cos (ref q 2)))))))
  (define turning (nonholonomic (lambda (t q v) (- (ref v 2) (* 1/2 t)))))
  (define example (up 0.1 (up 0.6 0.7 0.3) (up 0.3 0.2 0.4)))
  (check-false (position-code (check-code L blade 1 example)))
  (check-code L (list blade turning) 2 example)
  (void (check-code L (list (holonomic (lambda (t q) (- (* (ref q 0) (ref q 1)) 1))) turning)
                    2 example)))

(test-case "a mass matrix that is not diagonal, and one that has no inverse"
  (define (L-coupled (up t (up x y) (up vx vy)))
    (- (* 1/2 (+ (square vx) (* 2 (square vy)) (* vx vy (sin (+ x y))))) (* x y)))
  (check-code L-coupled (rod 1) 1 (up 0 (up 0.6 0.7) (up 0.3 0.2)))
  (define (L-light (up t (up x y) (up vx vy))) (- (* 1/2 (square vx)) (* 9.8 y)))
  (check-code L-light (rod 1) 1 (up 0 (up 0.6 0.7) (up 0.3 0.2)))
  (define (L-cross (up t (up x y) (up vx vy))) (- (* vx vy) (* 9.8 y)))
  (void (check-code L-cross (rod 1) 1 (up 0 (up 0.6 0.7) (up 0.3 0.2)))))

(test-case "a mass that is nothing where the motion begins is carried by the constraint"
  (define ((L-lower mass) s)
    (define-values (q v) (values (coordinate s) (velocity s)))
    (- (* 1/2 (+ (square (ref v 0)) (* (mass (time s)) (square (ref v 1))))) (* 9.8 (ref q 1))))
  (define start (up 0 (up 0.6 0.8) (up 0 0)))
  (for ([mass (list (lambda (t) 0.0) (lambda (t) t))])
    (define (final L)
      (trajectory-final-state
       (evolve-trajectory (constrained-state-derivative L (rod 1)) start 1/5)))
    (check-close (numbers (final (L-lower mass))) (numbers (final (not-traced (L-lower mass))))
                 1e-8)))

(test-case "its derivatives are those of D"
  (define f (constrained-state-derivative (L-mass 1) (rod 1)))
  (define start (up 0 (up 0.6 -0.8) (up 0 0)))
  (define jacobian! ((system-make-jacobian! (make-system 'test f start))))
  (define J (make-flvector 25))
  (define v (random-vector 5))
  (jacobian! v J)
  (check-close J (numbers ((D f) (flvector->structure start v))) 1e-9))

(test-case "what was compiled is used again, and not where something has changed"
  (define-values (m l g) (values 1 1 9.8))
  (define (L (up t q v)) (- (* 1/2 m (square v)) (* m g (ref q 1))))
  (define f (constrained-state-derivative L (holonomic (lambda (t q) (- (square q) (square l))))))
  (define (start) (up 0 (up (* 0.6 l) (* -0.8 l)) (up 0 0)))
  (define (system) (make-system 'test f (start)))
  (check-eq? (system) (system))
  (define (angle)
    (define end (trajectory-final-state (evolve-trajectory f (start) 1)))
    (check-= (square (coordinate end)) (square l) 1e-12)
    (atan (ref (coordinate end) 0) (- (ref (coordinate end) 1))))
  (define (expected)
    (define (swing s) (up 1 (ref s 2) (* -1 (/ g l) (sin (ref s 1)))))
    (ref (trajectory-final-state (evolve-trajectory swing (up 0 (atan 3/4) 0) 1)) 1))
  (for ([_ 2])
    (check-= (angle) (expected) 1e-8)
    (set! l (+ l 1/2))
    (check-= (angle) (expected) 1e-8)
    (set! g (* 2 g))
    (check-= (angle) (expected) 1e-8)))

(struct slipped (where))

(test-case "what a constraint or a Lagrangian raises reaches its author"
  (define start (up 0 (up 0.6 -0.8) (up 0 0)))
  (define (slips x) (when (and (real? x) (< x 0)) (raise (slipped x))))
  (define (rod-that-slips t q)
    (slips (ref q 0))
    (- (square q) 1))
  (define (L-that-slips s)
    (slips (ref (coordinate s) 0))
    ((L-mass 1) s))
  (define slipping-rod (constrained-state-derivative (L-mass 1) (holonomic rod-that-slips)))
  (define slipping-mass (constrained-state-derivative L-that-slips (rod 1)))
  (for* ([f (list slipping-rod slipping-mass)] [method '(Dormand-Prince-853 Radau-IIA-5)])
    (check-exn slipped? (lambda () (evolve-trajectory f start 3 #:method method)))))

(test-case "twenty rods fall without leaving their lengths"
  (define n 20)
  (define (rods t q)
    (vector->up (for/vector ([k n])
                  (- (square (- (ref q k) (if (= k 0) (up 0 0) (ref q (- k 1))))) 1))))
  (define (L (up t q v))
    (for/fold ([sum 0]) ([k n]) (+ sum (- (* 1/2 (square (ref v k))) (* 9.8 (ref q k 1))))))
  (define (tuple f) (vector->up (build-vector n f)))
  (define start
    (up 0 (tuple (lambda (k) (up (* (+ k 1) 0.6) (* (+ k 1) -0.8)))) (tuple (lambda (k) (up 0 0)))))
  (define end
    (trajectory-final-state
     (evolve-trajectory (constrained-state-derivative L (holonomic rods)) start 1/2)))
  (define energy (Lagrangian->energy L))
  (check-= (energy end) (energy start) 1e-6)
  (for ([x (in-flvector (numbers (rods 0 (coordinate end))))]) (check-= x 0 1e-12)))
