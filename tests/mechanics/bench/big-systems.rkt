#lang racket/base
;; Chains of many links, derivation and compilation included, beside CasADi with SciPy.
;;
;; CasADi (casadi.org) is given the Lagrangian as its users would write it: symbols, the
;; Hessian by the velocities, a function of mass matrix and forces; NumPy solves for the
;; accelerations, and SciPy's DOP853 integrates.

(require racket/format
         (only-in mechanics/compile/cache clear-compiled-programs)
         (only-in mechanics/motion/system/kept-systems clear-kept-systems)
         (only-in mechanics/motion/evolve-trajectory evolve-trajectory)
         "clock.rkt" "motion-systems.rkt" "python.rkt" "table.rkt")

(provide big-systems-heading big-systems-rows)

(define big-systems-heading
  '("chain of links to t = 1, 1e-9, CPU ms" "ours" "the same again" "CasADi, derivation"
    "CasADi and SciPy, all" "ours : theirs"))

(define sizes '(8 20 40 100))
(define repetitions 3)
(define tolerance 1e-9)

(define (big-systems-rows)
  (for/list ([n (in-list sizes)])
    (define-values (first again) (our-times n))
    (define theirs (numbers-of (python/text (CasADi-program n))))
    (list (~a n)
          (milliseconds first) (milliseconds again)
          (if (pair? theirs) (milliseconds (car theirs)) theirs)
          (if (pair? theirs) (milliseconds (cadr theirs)) theirs)
          (if (pair? theirs) (ratio first (cadr theirs)) "–"))))

;; -> the least of the first and of the second motions of a state derivative
(define (our-times n)
  (define start (released-chain-start n))
  (define (time derivative)
    (define-values (_ ms)
      (call/cpu (lambda () (evolve-trajectory derivative start 1 #:tolerance tolerance))))
    ms)
  (for/fold ([first +inf.0] [again +inf.0]) ([_ (in-range repetitions)])
    (clear-compiled-programs)
    (clear-kept-systems)
    (define derivative (released-chain n))
    (define a (time derivative))
    (values (min first a) (min again (time derivative)))))

(define (CasADi-program n)
  (format #<<PYTHON
import time
import numpy as np, casadi as ca
from scipy.integrate import solve_ivp
n = ~a
start = np.r_[np.ones(n), np.zeros(n)]
def derive():
    q, v = ca.SX.sym("q", n), ca.SX.sym("v", n)
    x = y = vx = vy = L = 0
    for i in range(n):
        x = x + ca.sin(q[i]); y = y - ca.cos(q[i])
        vx = vx + ca.cos(q[i])*v[i]; vy = vy + ca.sin(q[i])*v[i]
        L = L + 0.5*(vx*vx + vy*vy) - 9.8*y
    P = ca.gradient(L, v)
    M = ca.jacobian(P, v)
    F = ca.gradient(L, q) - ca.jtimes(P, q, v)
    return ca.Function("f", [q, v], [M, F])
best = derivation = 1e9
for _ in range(~a):
    before = time.process_time()
    f = derive()
    derived = time.process_time() - before
    def slope(t, s):
        M, F = f(s[:n], s[n:])
        return np.r_[s[n:], np.linalg.solve(np.array(M), np.array(F).ravel())]
    solve_ivp(slope, (0, 1), start, method="DOP853", rtol=~a, atol=~a)
    best = min(best, time.process_time() - before)
    derivation = min(derivation, derived)
print("%.4f %.4f" % (1e3*derivation, 1e3*best))
PYTHON
          n repetitions tolerance tolerance))
