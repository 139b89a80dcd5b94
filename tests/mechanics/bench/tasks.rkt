#lang racket/base
;; The tasks of `make bench`.  A new task is one more entry here; figures to
;; compare it with go into peers.rkt, under its name.

(require racket/promise
         (prefix-in m: mechanics)
         (only-in mechanics/algebra/zero/fingerprint fingerprint)
         (only-in mechanics/algebra/zero/zero-test zero-test zero-test-status)
         "canonical.rkt" "curvature.rkt" "derivatives.rkt" "integrals.rkt" "matrices.rkt"
         "motion.rkt" "pictures.rkt" "rigid.rkt" "rotations.rkt" "systems.rkt" "task.rkt")

(provide tasks micros growths (struct-out scaling) find-task find-micro)

;; ---------------------------------------------------------------------------
;; Lagrange equations on literal paths, simplified

;; A residual before and after simplification.
(define (residual L path)
  (define raw (((m:Lagrange-equations L) path) 't))
  (cons raw (m:simplify raw)))

(define (residual-size r)
  (format "~a > ~a" (node-count (m:expression (car r))) (node-count (m:expression (cdr r)))))

;; The lists of an S-expression, shared ones once.
(define (node-count datum)
  (define seen (make-hasheq))
  (let walk ([d datum])
    (when (and (pair? d) (not (hash-ref seen d #f)))
      (hash-set! seen d #t)
      (for-each walk d)))
  (hash-count seen))

(define (chain-task name n)
  (make-task name
             (format "Lagrange equations of a chain of ~a links through F->C, simplified" n)
             (lambda () (residual (chain-Lagrangian n) (chain-path n)))
             #:size residual-size))

(define (decimal-chain-task name n)
  (residual-task name
                 (format "the same of ~a links with decimal masses, lengths and g" n)
                 (lambda () (chain-Lagrangian/decimal n))
                 (lambda () (chain-path n))))

(define (residual-task name description make-L make-path)
  (make-task name description
             (lambda () (residual (make-L) (make-path)))
             #:size residual-size))

;; ---------------------------------------------------------------------------
;; State derivatives, simplified

(define (derivative-task name description make-L make-state)
  (make-task name description
             (lambda ()
               (define raw ((m:Lagrangian->state-derivative (make-L)) (make-state)))
               (cons raw (m:simplify raw)))
             #:size residual-size))

(define (chain-derivative-task name n)
  (derivative-task name
                   (format "state derivative of a chain of ~a links, simplified" n)
                   (lambda () (chain-Lagrangian n))
                   (lambda () (chain-state n))))

(define (decimal-chain-derivative-task name n)
  (derivative-task name
                   (format "the same of ~a links with decimal masses, lengths and g" n)
                   (lambda () (chain-Lagrangian/decimal n))
                   (lambda () (chain-state n))))

(define (rigid-body) (rigid-body-Lagrangian 'A 'B 'C))

;; ---------------------------------------------------------------------------
;; Hamiltonians

(define (chain-Hamiltonian-task name n)
  (make-task name
             (format "Hamiltonian of a chain of ~a links, simplified" n)
             (lambda ()
               (define raw ((m:Lagrangian->Hamiltonian (chain-Lagrangian n))
                            (chain-momentum-state n)))
               (cons raw (m:simplify raw)))
             #:size residual-size))

(define (rigid-Hamiltonian-task name)
  (make-task name
             "state derivative of a rigid body through its Hamiltonian, simplified"
             (lambda ()
               (define H (m:Lagrangian->Hamiltonian (rigid-body)))
               (define raw ((m:Hamiltonian->state-derivative H) (Euler-momentum-state)))
               (cons raw (m:simplify raw)))
             #:size residual-size))

;; The rate of the energy along the motion, a proof that it is zero.
(define (energy-rate)
  (define L (rigid-body))
  (define rate (m:* ((m:D (m:Lagrangian->energy L)) (Euler-state))
                    ((m:Lagrangian->state-derivative L) (Euler-state))))
  (cons rate (m:simplify rate)))

;; ---------------------------------------------------------------------------
;; Linear algebra

;; A use of a matrix, whose result is then simplified if it is symbolic.
(define (matrix-task name description make use)
  (make-prepared-task name description
                      make
                      (lambda (A)
                        (define raw (use A))
                        (cons raw (m:simplify raw)))
                      #:size residual-size))

;; The same left as it is.
(define (numeric-task name description make use)
  (make-prepared-task name description make use))

(define matrix-tasks
  (list
   (matrix-task 'D5 "determinant of 5 by 5 symbols, simplified"
                (lambda () (symbolic-matrix 5)) m:determinant)
   (matrix-task 'D6 "determinant of 6 by 6 symbols, simplified"
                (lambda () (symbolic-matrix 6)) m:determinant)
   (matrix-task 'D12 "determinant of a tridiagonal matrix of 12 rows, simplified"
                (lambda () (tridiagonal-matrix 12)) m:determinant)
   (matrix-task 'D16 "determinant of K - w M for 16 coupled oscillators, simplified"
                (lambda () (frequency-matrix 16)) m:determinant)
   (matrix-task 'I4 "inverse of 4 by 4 symbols, simplified"
                (lambda () (symbolic-matrix 4)) m:m:invert)
   (matrix-task 'I8 "inverse of 8 by 8 symbols with many zeros, simplified"
                (lambda () (sparse-matrix 8)) m:m:invert)
   (numeric-task 'N50 "solving 50 equations in flonums"
                 (lambda () (flonum-matrix 50))
                 (lambda (A) (m:solve-linear-left A (ones 50))))
   (numeric-task 'M50 "inverse of 50 by 50 flonums"
                 (lambda () (flonum-matrix 50)) m:m:invert)
   (numeric-task 'X50 "determinant of 50 by 50 integers"
                 (lambda () (integer-matrix 50)) m:determinant)
   (numeric-task 'Y20 "inverse of 20 by 20 integers"
                 (lambda () (integer-matrix 20)) m:m:invert)))

;; ---------------------------------------------------------------------------
;; Lie series

(define (bracket F G)
  (m:- (m:* ((m:partial 1) F) ((m:partial 2) G)) (m:* ((m:partial 2) F) ((m:partial 1) G))))

(define (Lie-series)
  (define (H s)
    (m:+ (m:/ (m:square (m:ref s 2)) (m:* 2 'm)) (m:* 1/2 'k (m:square (m:ref s 1)))))
  (define transform
    (m:exp (m:* 'dt (m:make-operator (lambda (F) (bracket F H)) 'Lie-derivative))))
  (map m:simplify (m:series:head ((transform m:coordinate) (m:up 0 'x0 'p0)) 6)))

;; ---------------------------------------------------------------------------
;; Zero-testing

;; judge : residual -> what it is found to be
(define (zero-task name description vanishing? judge)
  (make-prepared-task name description
                      (lambda () (rotations-residual vanishing?))
                      (lambda (e) (cons e (judge e)))
                      #:size (lambda (r)
                               (format "~a (tree ~a) ~a" (graph-size (car r))
                                       (tree-size (car r)) (cdr r)))))

(define (Jacobi-task name n)
  (make-task name
             (format "Jacobi's identity with three literal functions of ~a coordinates, proved" n)
             (lambda ()
               (define identity (Jacobi-identity n))
               (cons identity (m:verdict-status (m:prove-zero identity))))
             #:size (lambda (r) (format "~a ~a" (node-count (m:expression (car r))) (cdr r)))))

(define tasks
  (list*
   (chain-task 'L2 2)
   (chain-task 'L3 3)
   (chain-task 'L4 4)
   (chain-task 'L6 6)
   (decimal-chain-task 'L6d 6)
   (chain-derivative-task 'S2 2)
   (chain-derivative-task 'S3 3)
   (decimal-chain-derivative-task 'S3d 3)
   (chain-derivative-task 'S4 4)
   (derivative-task 'R1 "state derivative of a rigid body in Euler angles, simplified"
                    rigid-body Euler-state)
   (residual-task 'R2 "Lagrange equations of a rigid body in Euler angles, simplified"
                  rigid-body Euler-path)
   (make-task 'R3 "the rigid body's energy is conserved along its state derivative"
              energy-rate #:size residual-size)
   (rigid-Hamiltonian-task 'R4)
   (chain-Hamiltonian-task 'H2 2)
   (chain-Hamiltonian-task 'H4 4)
   (residual-task 'F1 "Lagrange equations of Foucault's pendulum, simplified"
                  Foucault-Lagrangian Foucault-path)
   (derivative-task 'F2 "state derivative of Foucault's pendulum, simplified"
                    Foucault-Lagrangian Foucault-state)
   (residual-task 'F3 "Lagrange equations of the same in rectangular coordinates, with a root"
                  Foucault-Lagrangian/rectangular plane-path)
   (derivative-task 'F4 "state derivative of the same in rectangular coordinates"
                    Foucault-Lagrangian/rectangular Foucault-state/rectangular)
   (residual-task 'T2 "Lagrange equations of the restricted three-body problem, simplified"
                  three-body-Lagrangian plane-path)
   (make-task 'X6 "Lie series of the coordinate of a harmonic oscillator, 6 terms, simplified"
              Lie-series #:size (lambda (terms) (node-count (map m:expression terms))))
   (Jacobi-task 'J2 2)
   (Jacobi-task 'J3 3)
   (zero-task 'Z1 "zero test of a large residual that does not vanish, with a witness"
              #f (lambda (e) (zero-test-status (zero-test e))))
   (zero-task 'Z2 "fingerprint of a large residual that vanishes"
              #t fingerprint)
   (zero-task 'Z3 "zero test of the same, a proof"
              #t (lambda (e) (zero-test-status (zero-test e))))
   (append motion-tasks rigid-tasks canonical-tasks curvature-tasks integral-tasks matrix-tasks
           picture-tasks)))

;; ---------------------------------------------------------------------------
;; Growth

(define (numbered-name base n) (string->symbol (format "~a~a" base n)))

;; Tasks of ascending size, and from which size on a power of it is fitted.
(struct scaling (heading sizes tasks fit-from))

(define (chain-growth heading task name sizes)
  (scaling heading sizes (for/list ([n (in-list sizes)]) (task (numbered-name name n) n)) 3))

(define growths
  (list (chain-growth "Lagrange equations of a chain of n links" chain-task 'chains-L
                      (for/list ([n (in-range 1 13)]) n))
        (chain-growth "state derivative of a chain of n links" chain-derivative-task 'chains-S
                      '(1 2 3 4 5))
        (scaling "motion of a chain of n links from 1 rad to t = 1, error 1e-10"
                 motion-growth-sizes motion-growth-tasks 8)))

;; ---------------------------------------------------------------------------
;; Operations

(define x (opaque 1.25))
(define y (opaque -0.75))
(define u (m:up x y 2.0))
(define v (m:up y 0.5 x))
(define u* (vector x y 2.0))
(define v* (vector y 0.5 x))

(define (add-vectors a b)
  (vector (+ (vector-ref a 0) (vector-ref b 0))
          (+ (vector-ref a 1) (vector-ref b 1))
          (+ (vector-ref a 2) (vector-ref b 2))))

(define micros
  (append
   (list
    (make-micro 'add "+ on two flonums"
                (lambda (n) (repeat n (m:+ x y)))
                #:against (lambda (n) (repeat n (+ x y)))
                #:reach "2×")
    (make-micro 'multiply "* on two flonums"
                (lambda (n) (repeat n (m:* x y)))
                #:against (lambda (n) (repeat n (* x y)))
                #:reach "2×")
    (make-micro 'sine "sin of a flonum"
                (lambda (n) (repeat n (m:sin x)))
                #:against (lambda (n) (repeat n (sin x))))
    (make-micro 'add3 "+ on two up tuples of 3"
                (lambda (n) (repeat n (m:+ u v)))
                #:against (lambda (n) (repeat n (add-vectors u* v*)))
                #:reach "100 ns")
    ;; SciPy 1.17: 130 µs; 3300 ns one by one, 70 ns within an array
    (make-micro 'spline "cubic spline through 1000 points, made"
                (lambda (n) (repeat n (m:cubic-spline waves-at waves))))
    (make-micro 'spline-value "its value at a flonum"
                (lambda (n) (repeat n (wave (opaque 456.7))))
                #:reach "500 ns"))
   derivative-micros))

(define waves-at (for/list ([k (in-range 1000)]) (exact->inexact k)))
(define waves (for/list ([x (in-list waves-at)]) (sin (* 0.1 x))))
(define (wave x) ((force spline) x))
(define spline (delay (m:cubic-spline waves-at waves)))

;; ---------------------------------------------------------------------------

(define (find-task name)
  (find name (apply append tasks (map scaling-tasks growths)) task-name))
(define (find-micro name) (find name micros micro-name))

(define (find name entries entry-name)
  (for/first ([e (in-list entries)] #:when (eq? (entry-name e) name)) e))
