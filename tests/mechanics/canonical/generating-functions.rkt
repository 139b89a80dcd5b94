#lang racket/base
;; Generating functions of the four types (SICM 5.4-5.8), in both directions.

(require mechanics
         mechanics/book
         "../support/checks.rkt"
         "../support/close.rkt" "../support/messages.rkt" "../support/session.rkt")

(define line (up 't 'q 'p))
(define polar (up 't (up 'r 'phi) (down 'p_r 'p_phi)))
(define plane (up 't (up 'x 'y) (down 'p_x 'p_y)))

(define (F1-polar t x theta) (* 1/2 'alpha (square x) (cot theta)))
(define (F2-polar t q p) (* p (r->p (up t q p))))
(define (F3-polar t p q) (* -1 p (p->r (up t q p))))
(define (F4-exchange t p pp) (* p pp))

(test-case "F1 of the polar-canonical transformation (p. 373)"
  (define C (F1->C F1-polar))
  (define here (up 't 'theta 'I))
  (check-identity (C here) ((polar-canonical 'alpha) here))
  (check-pred proved? (verify-canonical C here))
  (check-pred proved? (verify-generating-function (polar-canonical 'alpha) F1-polar here))
  (check-pred refuted? (verify-generating-function (polar-canonical 'alpha)
                                                   (lambda (t x theta) (* 2 (F1-polar t x theta)))
                                                   here)))

(test-case "F2 of a point transformation: p' f(t, q) takes old states to new ones by F->CH"
  (check-identity ((F2->C-inv (lambda (t q p) (* p (p->r (up t q p))))) polar)
                  ((F->CH p->r) ((F->CH r->p) ((F->CH p->r) polar)))))

(test-case "F3 of the same with the coordinates the other way"
  (check-identity ((F3->C F3-polar) polar) ((F->CH p->r) polar))
  (check-pred proved? (verify-generating-function (F->CH p->r) F3-polar polar #:type 3)))

(test-case "F1 and F4 exchange coordinates and momenta"
  (check-identity ((F1->C (lambda (t q qq) (* q qq))) line) (up 't (- 'p) 'q))
  (check-identity ((F4->C F4-exchange) line) (up 't (- 'p) 'q)))

(test-case "F2 = q p' is the identity"
  (check-identity ((F2->C (lambda (t q p) (* p q))) plane) plane)
  (check-identity ((F2->C-inv (lambda (t q p) (* p q))) plane) plane))

(test-case "each direction undoes the other"
  (define (cubic t q p) (+ (* p q) (* 'e (expt q 3)) (* t q)))
  (for ([to-old (list F2->C F1->C F3->C F4->C)]
        [to-new (list F2->C-inv F1->C-inv F3->C-inv F4->C-inv)])
    (check-identity ((compose (to-new cubic) (to-old cubic)) line) line)
    (check-identity ((to-old cubic) ((to-new cubic) line)) line)
    (check-identity ((symplectic-transform? (to-old cubic)) line) (* 0 (identity-matrix 2)))))

(test-case "what they make prints as it is made"
  (define (F t q p) (* q p))
  (check-equal? (map (lambda (f) (format "~a" f)) (list (F2->C F) (F2->C-inv F) (F2->K F)))
                '("(F2->C F)" "(F2->C-inv F)" "(F2->K F)")))

(test-case "p. 366: what the new Hamiltonian gets"
  (check-identity ((F2->K (lambda (t q p) (* p (- q (* 'v t))))) line) (* -1 'v 'p))
  ;; a translation of the momentum, too, for Galileo: H∘C + ∂₀F is the free particle again
  (define (boost t q p) (- (* (+ p (* 'm 'v)) (- q (* 'v t))) (* -1/2 'm (square 'v) t)))
  (check-identity ((+ (compose (H-free 'm) (F2->C boost)) (F2->K boost)) line)
                  ((H-free 'm) line))
  (check-pred proved? (verify-canonical (F2->C boost) (H-free 'm) (H-free 'm) line))
  (for ([K (list F1->K F3->K F4->K)] [x (list 'p 'p 'q)])
    (check-identity ((K (lambda (t x y) (+ (* x y) (* t (square x))))) line) (square x))
    (check-identity ((K (lambda (t x y) (+ (* x y) (sin t)))) line) (cos 't))))

(test-case "where nothing can be solved, numbers are found, and their derivatives"
  (define (F t q p) (+ (* q p) (* 0.1 (sin q) (square p))))
  (define C (F2->C F))
  (define old (C (up 0 1.0 2.0)))
  (check-close (+ (ref old 1) (* 0.2 2.0 (sin (ref old 1)))) 1.0 1e-10)
  (check-close (+ 2.0 (* 0.1 4.0 (cos (ref old 1)))) (ref old 2) 1e-10)
  (check-close (determinant (qp-submatrix ((D-as-matrix C) (up 0 1.0 2.0)))) 1.0 1e-9)
  (check-close ((F2->C-inv F) old) '(0 1.0 2.0) 1e-9))

;; ---------------------------------------------------------------------------
;; The way back

(test-case "what generates a transformation is found by integration"
  (define F (generating-function (polar-canonical 'alpha) (up 't 'theta 'I) #:type 1))
  (check-prints (F 't 'x 'theta) '(/ (* 1/2 alpha (expt x 2) (cos theta)) (sin theta)))
  (check-identity (F 't 'x 'theta) (F1-polar 't 'x 'theta))
  (check-pred proved? (verify-generating-function (polar-canonical 'alpha) F (up 't 'theta 'I)))
  (define F3 (generating-function (F->CH p->r) polar #:type 3))
  (check-identity (F3 't (down 'a 'b) (up 'r 'phi)) (F3-polar 't (down 'a 'b) (up 'r 'phi))))

(test-case "back and forth"
  (for ([k '(1 2 3 4)] [to-old (list F1->C F2->C F3->C F4->C)])
    (define (cubic t x y) (+ (* x y) (* 'e (expt x 3)) (* 'f (expt y 2))))
    (define F (generating-function (to-old cubic) line #:type k))
    (check-identity (- (F 't 'x 'y) (F 't 0 0)) (cubic 't 'x 'y))
    (check-pred proved? (verify-generating-function (to-old cubic) F line #:type k))))

(test-case "to a frame that moves, at all times"
  (define (boost (up t q p)) (up t (+ q (* 'v t)) (+ p (* 'm 'v))))
  (define F2 (generating-function boost line #:type 2))
  (check-identity (F2 't 'x 'y) (+ (* 'x 'y) (* 'm 'v 'x) (* -1 'v 't 'y)))
  (define F3 (generating-function boost line #:type 3))
  (check-identity (F3 't 'x 'y) (+ (* -1 'x 'y) (* 'm 'v 'y) (* -1 'v 't 'x))))

;; ---------------------------------------------------------------------------
;; Functions that generate nothing

(test-case "brackets that vanish are no multiple to divide a Hamiltonian by"
  (define v (verify-canonical (lambda (s) (up (time s) (coordinate s) (coordinate s))) line))
  (check-pred refuted? v)
  (check-equal? (verdict-remarks v) '()))

(test-case "a generating function without mixed derivatives"
  (check-message
   (string-append
    "F2->C: it generates no transformation: the old coordinates do not follow from the new state\n"
    "  the determinant of the mixed second derivatives is 0\n  mixed second derivatives: 0")
   ((F2->C (lambda (t q p) (+ q p))) line)
   exn:fail:mechanics:singular:matrix?)
  (check-message
   (string-append
    "F1->C-inv: it generates no transformation: the new coordinates do not follow from the old "
    "state\n  the determinant of the mixed second derivatives is 0\n"
    "  mixed second derivatives: (down (down 1 1) (down 1 1))")
   ((F1->C-inv (lambda (t q qq) (* (+ (ref q 0) (ref q 1)) (+ (ref qq 0) (ref qq 1))))) plane)
   exn:fail:mechanics:singular:matrix?))

(define (not-canonical (up t theta p)) (up t (* p (sin theta)) (* p (cos theta))))

(says
 [(F2->C (lambda (state) 1))
  "F2->C: a generating function of type 2 takes three arguments, the time, the old coordinates "
  "and the new momenta; given a function without a name, which takes 1 argument"]
 [((F1->C (lambda (t x y) (up x y))) line)
  "F1->C: the value of a generating function is a number, but that of <function> is (up q q), "
  "an up tuple of 2"]
 [((F2->C (lambda (t q p) (+ (* p q) (* (sin q) (exp (* p q)))))) line)
  "F2->C: no formula was found for the old coordinates, and numbers are not found with symbols "
  "left\n  one of them: q\n  give the parameters and the state as numbers"]
 [(generating-function not-canonical (up 't 'theta 'p))
  "generating-function: not-canonical has no generating function: it is not canonical\n"
  "  for what it misses: (verify-canonical C state)"]
 [(generating-function (polar-canonical 'alpha) line #:type 5)
  "generating-function: expected the type of a generating function: 1, 2, 3 or 4\n  given: the number 5"])

;; Of a root that is nowhere real nothing is proved or refuted.
(define (nowhere-real (up t q p)) (up t (* (sqrt (- -1 (square 'a))) q) p))

(test-case "what is not shown to be generated is not given"
  (check-message
   (string-append "generating-function: a function was found, but not shown to generate "
                  "nowhere-real\n  is it canonical? (verify-canonical C state)")
   (generating-function nowhere-real line #:type 2)
   exn:fail:mechanics?))
