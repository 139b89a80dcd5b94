#lang racket/base
;; Questions about systems that have no real value where their solution, equilibrium or conserved
;; quantity is said to be, though derivatives have; and about the same where there are values.

(require "../statement.rkt")

(provide domains)

(define (domains)
  ((pick (list at-rest at-rest at-rest moving with-constant with-constant with-constant nowhere))))

(define (of-local e) `(lambda ((up t x v)) ,(quoted-symbols e '(t x v))))
(define (of-state e) `(lambda ((up t x p)) ,(quoted-symbols e '(t x p))))
(define local '(up 't 'x 'v))
(define free '(* 1/2 (square v)))

;; ---------------------------------------------------------------------------
;; Rest

;; (potential (place . slope there) ...): of each some places are outside.
(define potentials
  '(((log (- x 2)) (1 . -1) (3 . 1) (-1 . -1/3)) ((log x) (-1 . -1) (2 . 1/2) (-3 . -1/3))
    ((log (- x)) (1 . 1) (-2 . -1/2) (5 . 1/5)) ((atanh x) (2 . -1/3) (-3 . -1/8) (1/2 . 4/3))
    ((log (- 1 (square x))) (2 . 4/3) (-3 . -3/4) (1/2 . -4/3))
    ((log (- (square x) 4)) (1 . -2/3) (-1 . 2/3) (3 . 6/5))
    ((log (/ (- x 1) (- 3 x))) (0 . -2/3) (4 . -2/3) (2 . 2))
    ((log (sqrt (- x 2))) (1 . -1/2) (3 . 1/2))
    ((log (- -1 (square x))) (0 . 0) (1 . 1) (-2 . -4/5)) ((log (+ 1 (square x))) (0 . 0) (1 . 1))
    ((sqrt (- (square x) 2)) (0 . 0)) ((expt (- (square x) 2) 3/2) (0 . 0)) ((log (cos x)) (0 . 0))
    ((log (- (cos x) 2)) (0 . 0)) ((log (- a (square x))) (0 . 0))
    ((log (- (square x) (square b))) (0 . 0))))

;; V less a force and a half spring, so that the place is at rest.
(define (at-rest)
  (define entry (pick potentials))
  (define-values (c slope) (let ([p (pick (cdr entry))]) (values (car p) (cdr p))))
  (define k (pick (list 0 (if (zero? c) 0 (/ slope c)))))
  (define V `(- ,(car entry) (* 1/2 ,k (square x)) (* ,(- slope (* k c)) x)))
  (define L `(- ,free ,V))
  (define there (substituted V 'x c))
  (case (random 4)
    [(0) (inquiry `(verify-solution ,(of-local L) (lambda (t) ,c)) `(domain ,there))]
    [(1) (inquiry `(verify-equilibrium ,(of-local L) ,c) `(domain ,there))]
    [(2) (inquiry `(verify-Hamiltonian-solution ,(of-state `(+ (* 1/2 (square p)) ,V))
                                                (lambda (t) ,c) (lambda (t) 0))
                  `(domain ,there))]
    [else
     (inquiry `(map (lambda (e) (list (equilibrium-coordinates e) (equilibrium-conditions e)))
                    (equilibria ,(of-local L) ,local))
              `(found ,V))]))

;; ---------------------------------------------------------------------------
;; Motions of one speed, where L may have no value at that speed

(define (moving)
  (define L (pick '((- (sqrt (- 1 (square v)))) (* v (log v)) (sqrt v) (log (- 1 v)) (acosh v)
                    (* v (atanh v)) (expt (- v 1) 3/2) (log (- (square v) b)) (asin v))))
  (define speed (pick '(2 -1 1/2 -3 3/2 c)))
  (inquiry `(verify-solution ,(of-local L) (lambda (t) (+ 1 (* ,(if (eq? speed 'c) ''c speed) t))))
           `(domain ,(substituted L 'v speed))))

;; ---------------------------------------------------------------------------
;; Constants, of which some have no value anywhere

(define (constant u)
  (pick `((- (log (- ,u)) (log ,u)) (- (log (- -1 (square ,u))) (log (+ 1 (square ,u))))
          (+ (asin (+ 2 (square ,u))) (acos (+ 2 (square ,u))))
          (- (log (- ,u 2)) (log (- 2 ,u))) (/ (sqrt ,u) (sqrt (- ,u)))
          (/ (sqrt (- -1 (square ,u))) (sqrt (+ 1 (square ,u))))
          (- (log (- (cos ,u) 2)) (log (- 2 (cos ,u))))
          (- (log (- (exp ,u))) ,u) (- (log (- (square (sin ,u)) 1)) (log (square (cos ,u))))
          ;; with values
          (- (log (- ,u)) (log (* -2 ,u))) (- (log (- ,u 2)) (log (- (* 2 ,u) 4)))
          (+ (asin ,u) (acos ,u)) (/ (sqrt (- 1 ,u)) (sqrt (- 2 (* 2 ,u)))))))

(define (with-constant)
  (define (one u) (constant u))
  (case (random 7)
    [(0) (let ([e (one 't)])
           (inquiry `(verify-solution ,(of-local free) (lambda (t) (+ t ,e))) `(domain ,e)))]
    [(1) (let ([e (one (pick '(x v (+ x v))))])
           (inquiry `(verify-conserved ,(of-local free) ,(of-local `(+ v ,e)) ,local)
                    `(domain ,e)))]
    [(2) (let ([e (one (pick '(x v (* x v))))])
           (inquiry `(verify-equivalent-Lagrangians ,(of-local free) ,(of-local `(+ ,free ,e))
                                                    ,local)
                    `(domain ,e)))]
    [(3) (let ([e (one (pick '(x v t)))])
           (inquiry `(verify-total-time-derivative ,(of-local `(+ v ,e)) ,local) `(domain ,e)))]
    [(4) (let ([e (one 'x)])
           (inquiry `(verify-Hamilton-Jacobi ,(of-state '(* 1/2 (square p)))
                                             (lambda (t x) (- (+ (* 'k x) ,e)
                                                              (* 1/2 (square 'k) t)))
                                             't 'x)
                    `(domain ,e)))]
    [(5) (let ([e (one (pick '(x p)))])
           (inquiry `(verify-canonical-map ,(of-state `(up t (* 1 x) (+ p ,e))) (up 't 'x 'p))
                    `(domain ,e)))]
    [else (let ([e (one 't)])
            (inquiry `(verify-Hamiltonian-solution ,(of-state '(* 1/2 (square p)))
                                                   (lambda (t) (+ t ,e)) (lambda (t) 1))
                     `(domain ,e)))]))

;; ---------------------------------------------------------------------------
;; Lagrangians with a value nowhere, or not everywhere

(define (nowhere)
  (define e (pick '((log (- -1 (square v))) (sqrt (- -1 (square v))) (log (- -1 (square x)))
                    (acosh (cos v)) (asin (+ 2 (square x))) (sqrt (- (cos x) 2)) (log (- (exp v)))
                    (atanh (+ 1 (square x))) (sqrt (- 1 (square v))) (log (- x 1)) (log v))))
  (define L `(- ,free ,e))
  (case (random 3)
    [(0) (inquiry `(let ([L ,(of-local L)]) (verify-conserved L (Lagrangian->energy L) ,local))
                  `(domain ,e))]
    [(1) (inquiry `(verify-ignorable ,(of-local L) 'x ,local) `(domain ,e))]
    [else (inquiry `(verify-equivalent-Lagrangians ,(of-local L) ,(of-local `(* 2 ,L)) ,local)
                   `(domain ,e))]))
