#lang racket/base
;; Wrong calls, as a reader of the first three chapters makes them: other shapes, another order,
;; a number for a tuple, a Lagrangian for a Hamiltonian, a path for a state, symbols for numbers.
;; Each message begins with what was called, and speaks of no contract, no struct and no procedure
;; of Racket's that the reader did not write.

(require mechanics
         (only-in mechanics/book L-harmonic)
         "../support/checks.rkt" "../support/messages.rkt")

(define L (L-harmonic 'm 'k))
(define (Lp (up t (up r phi) (up rdot phidot)))
  (- (* 1/2 'm (+ (square rdot) (square (* r phidot)))) ((literal-function 'V) r)))
(define (H (up t q p)) (+ (/ (square p) (* 2 'm)) (* 1/2 'k (square q))))
(define Hp (Lagrangian->Hamiltonian Lp))
(define q (literal-function 'q))
(define p (literal-function 'p))
(define state (up 't 'x 'v))
(define flat (up 't 'r 'phi 'rdot 'phidot))
(define plane (up 't (up 'r 'phi) (up 'rdot 'phidot)))
(define (rates m k) (Lagrangian->state-derivative (L-harmonic m k)))
(define tr (evolve-trajectory (rates 1 1) (up 0 1 0) 1))
(define rod (holonomic (lambda (t q) (- (square q) 1))))

(define foreign
  #rx"contract violation|arity mismatch|application:|#<|(car|cdr|list-ref|vector-ref|hash-ref):")

;; (called expression ...) : what each message begins with
(define-syntax-rule (say entry ...) (begin (say-of . entry) ...))

(define-syntax-rule (say-of called expression ...)
  (test-case called
    (check-words called 'expression (lambda () expression))
    ...))

(define (check-words called call thunk)
  (define said (message-of (thunk) (lambda (e) #t)))
  (with-check-info (['call call] ['said said])
    (check-true (regexp-match? (string-append "^[(]?" (regexp-quote called) "[: )]") said))
    (check-false (regexp-match? foreign said))))

(say
 ["Lagrange-equations"
  (Lagrange-equations 3) ((Lagrange-equations L) 3) ((Lagrange-equations L) 'x)
  ((Lagrange-equations L) state) ((Lagrange-equations L) (list q q)) (Lagrange-equations L-harmonic)
  ((Lagrange-equations Hp) q) (((Lagrange-equations L) q) state) ((Lagrange-equations L) q p)]
 ["Gamma" (Gamma state) (Gamma 3) (Gamma q 1) (Gamma q p) ((Gamma q) p) ((Gamma q) state)]
 ["Lagrangian-action"
  (Lagrangian-action L q 't 1) (Lagrangian-action L q 0 1) (Lagrangian-action q L 0 1)
  (Lagrangian-action L q p 0 1) (Lagrangian-action 3 q 0 1)]
 ["find-path"
  (find-path L 0 1 1 0 3) (find-path (L-harmonic 1 1) 0 (up 1 0) 1 0 3)
  (find-path (L-harmonic 1 1) 0 'x 1 0 3) (find-path 1 0 1 1 0 3)]
 ["F->C" (F->C 3) ((F->C p->r) 3) ((F->C (lambda (t q) q)) state)]
 ["p->r" (p->r 3) (p->r state) ((F->C p->r) state)]
 ["Lagrangian->energy"
  (Lagrangian->energy 3) ((Lagrangian->energy L) 't) ((Lagrangian->energy L) q)
  ((Lagrangian->energy L) (up 't 'x))]
 ["Lagrangian->acceleration"
  ((Lagrangian->acceleration L) 't) ((Lagrangian->acceleration L) (up 't 'x))
  ((Lagrangian->acceleration L) (up 't (up 'x 'y) 'v))]
 ["state-advancer"
  ((state-advancer L-harmonic 1 1) (up 0 1 0) 1) ((state-advancer rates 1) (up 0 1 0) 1)
  ((state-advancer rates 'm 'k) (up 0 1 0) 1) ((state-advancer rates 1 1) (up 0 'x 0) 1)
  ((state-advancer rates 1 1) (up 0 1 0) 1 1e-30)]
 ["evolve" ((evolve rates 1 1) (up 0 1 0) 3 0.1 1) ((evolve rates 1 1) (up 0 1 0) 1 0.1)]
 ["evolve-trajectory"
  (evolve-trajectory L (up 0 1 0) 1) (evolve-trajectory (rates 1 1) '(0 1 0) 1)
  (evolve-trajectory (up 0 1 0) (rates 1 1) 1) (evolve-trajectory (rates 1 1) (up 0 1 0) 'T)
  (evolve-trajectory (rates 1 1) (up 0 1 0) 1 #:events coordinate)
  (evolve-trajectory (rates 1 1) (up 0 1 0) 1 #:method 'RK4)]
 ["trajectory" (tr 2) (tr 't) (tr (up 0 1 0)) ((D tr) 0)]
 ["verify-solution"
  (verify-solution q L) (verify-solution L 'x) (verify-solution L (lambda (x y) x))
  (verify-solution L-harmonic q) (verify-solution L q p) (verify-solution L q #:force 3)
  (verify-solution L q #:multipliers p)]
 ["verify-conserved"
  (verify-conserved L state (Lagrangian->energy L)) (verify-conserved L 'E state)
  (verify-conserved L (Lagrangian->energy L) (up 0 1 2)) (verify-conserved L H q)]
 ["conserved-momenta" (conserved-momenta L q) (conserved-momenta state L)
                      (conserved-momenta Hp plane)]
 ["ignorable-coordinates" (ignorable-coordinates L (up 't 'x)) (ignorable-coordinates 3 state)]
 ["Lp" (conserved-momenta Lp flat) (equilibria Lp flat) (((Lagrange-equations Lp) q) 't)]
 ["equilibria" (equilibria L 'x) (equilibria L (up 't 1 'v))]
 ["find-equilibrium" (find-equilibrium L 0) (find-equilibrium (L-harmonic 1 1) 'x)]
 ["equilibrium-stability" (equilibrium-stability L 1) (equilibrium-stability 0 L)]
 ["Noether-integral" (Noether-integral L 3) ((Noether-integral L (lambda (s) s)) state)]
 ["Dt" (Dt 3) ((Dt coordinate) (up 't 'x)) ((Dt q) 't)]
 ["partial" ((partial 3 L) state) (((partial 5) L) state) (partial)]
 ["momentum" (momentum L) (momentum tr) (momentum (up 't 'x)) (momentum plane)]
 ["Hamilton-equations"
  (Hamilton-equations 3) ((Hamilton-equations H) q) ((Hamilton-equations H) 'q 'p)
  (((Hamilton-equations H) q p) state) (((Hamilton-equations Hp) (up q q) (up p p)) 't)]
 ["Lagrangian->Hamiltonian"
  (Lagrangian->Hamiltonian 3) ((Lagrangian->Hamiltonian L) (up 't 'x))
  ((Lagrangian->Hamiltonian Lp) plane)]
 ["Hamiltonian->state-derivative"
  (Hamiltonian->state-derivative 3) ((Hamiltonian->state-derivative H) (up 't 'x))
  ((Hamiltonian->state-derivative Hp) plane)]
 ["Poisson-bracket" (Poisson-bracket 3 4) ((Poisson-bracket H H) (up 't 'x))]
 ["constrained-Lagrange-equations"
  ((constrained-Lagrange-equations L 3) q p) ((constrained-Lagrange-equations L rod) q)]
 ["holonomic" (holonomic 3) (holonomic (lambda (t) t))]
 ["s:map" (s:map 3 (up 1 2))]
 ["definite-integral" (definite-integral 3 0 1) (definite-integral sin (up 1 2) 1)]
 ["minimize" (minimize 3 0 1) (minimize sin 'a 1)])
