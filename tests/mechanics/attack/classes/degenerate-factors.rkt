#lang racket/base
;; Lagrangians of which a part has a factor that vanishes for some values of the parameters, or
;; that are singular in the velocities: are they equivalent to those without, is a quantity
;; conserved?

(require "../statement.rkt" "../template.rkt")

(provide degenerate-factors)

;; F and H are factors, L is a Lagrangian, O another one, Q a quantity and G a gauge term.
(define (degenerate-factors)
  (define plane? (chance 2))
  (define system (pick (if plane? planes lines)))
  (define choices
    `((F . ,(pick factors)) (H . ,(pick factors)) (L . ,(car system))
      (O . ,(car (pick (if plane? planes lines)))) (Q . ,(pick (cdr system)))
      (G . ,(pick gauges)) (P . ,(pick potentials))))
  (define-values (kind one other) (apply values (resolved (pick questions) choices)))
  (define swap? (and (eq? kind 'equivalent) (chance 3)))
  (define-values (first second) (if swap? (values other one) (values one other)))
  (define head (if plane? 'plane 'line))
  (question-of (list (if (eq? kind 'equivalent) 'verify-equivalent-Lagrangians 'verify-conserved)
                     (list head first) (list head second) (if plane? 'local-plane 'local))
               (list kind first second (if plane? '(x y) '(x)) (if plane? '(u v) '(v)))
               '()))

;; L and Q have F in them, and P.
(define (resolved e choices) (filled (filled (filled e choices) choices) choices))

(define questions
  '((equivalent L (+ (* F L) G)) (equivalent (* F L) (+ (* H L) G)) (equivalent O (* F L))
    (equivalent L (+ (* F L) O)) (equivalent (+ L G) (* (square F) L))
    (conserved (* F L) Q) (conserved (+ L G) (* H Q)) (conserved (+ (* F L) G) Q)
    (conserved L Q)))

(define factors
  '(c (- a b) (square c) (- (square a) (square b)) (- c) (- 1 c) (* (- c 1) (- c 2)) (sin c) (exp c)
    (+ 1 (square c)) (abs c) (sqrt (square (- a b))) (* a b) (+ a b) (/ a b) (+ c (abs c)) (log c)
    (- (exp c) 1) (+ (square a) (square b)) (- (* 2 c) (* 2 c c))))

(define gauges
  '(0 0 0 (* a v) (* c x v) (+ (* x (exp t)) (* v (exp t))) 1 (* b t) (* c (+ x (* v t)))))

;; (Lagrangian quantity ...)
(define lines
  '(((* 1/2 (square v)) v (* x v) (- x (* v t)) (square v))
    ((- (* 1/2 (square v)) (* 1/2 (square x))) (+ (square v) (square x))
                                               (+ (* v (cos t)) (* x (sin t))))
    ((- (* 1/2 (square v)) x) (+ (* 1/2 (square v)) x) (+ v t))
    ((- (* 1/2 (square v)) (cos x)) (+ (* 1/2 (square v)) (cos x)))
    ((* (exp t) (square v)) (* (exp t) v)) ((* 1/2 (square x) (square v)) (* x v))
    ((* x v) v) ((expt v 4) v) ((sqrt (+ 1 (square v))) v) ((* x (square v)) (* x (square v)))
    ((- (* 1/2 F (square v)) x) (+ (* 1/2 F (square v)) x))))

(define planes
  '(((- (+ (* 1/2 (square u)) (* 1/2 F (square v))) P) u v (* F v) (+ u v))
    ((- (* 1/2 (+ (square u) (square v))) P) u (- (* x v) (* y u)) (* F (- (* x v) (* y u))))
    ((- (* F u v) P) u v (+ (* F u v) P)) ((- (* 1/2 (square (+ u v))) P) (+ u v) (- u v))
    ((- (* x v) (* y u) P) x (- u v)) ((+ (* 1/2 (square u)) (* F u v)) u v)
    ((+ (* 1/2 (square u)) (* y v)) u y)
    ((- (+ (square u) (* F (square v))) (+ (square x) (* F (square y))))
     (+ (square u) (square x)) (+ (square v) (square y)) (* F (+ (square v) (square y))))))

(define potentials
  '(0 0 (* F x) (* 1/2 (+ (square x) (square y))) (* x y) (cos (- x y)) (* F (square y))))
