#lang racket/base
;; Implicit methods and projections, and the derivatives they need, beside SciPy.
;;
;; The cost of derivatives is told twice: as they are made, of the list of operations of the rates,
;; and as D makes them, run on placeholders, which is compiled in its turn.  SciPy's Radau is given
;; the same operations in Python, and takes differences.  So is its DOP853 for constrained
;; motions, of which it projects nothing.

(require racket/string
         (only-in mechanics D)
         (only-in mechanics/compile/cache clear-compiled-programs)
         (only-in mechanics/compile/compile-function compile-function compiled-function-program)
         (only-in mechanics/compile/trace trace)
         (only-in mechanics/motion/system/kept-systems clear-kept-systems)
         (only-in mechanics/motion/system/Lagrangian-code Lagrangian-code)
         (only-in mechanics/motion/system/make-system make-system)
         (only-in mechanics/motion/system/system system-make-jacobian!)
         (only-in mechanics/motion/evolve-trajectory evolve-trajectory)
         (only-in mechanics/value/shape scalars shape-length)
         "clock.rkt" "motion-systems.rkt" "program-text.rkt" "python.rkt" "stiff-systems.rkt"
         "table.rkt")

(provide stiff-heading stiff-rows projected-heading projected-rows)

(define repetitions 5)

;; ---------------------------------------------------------------------------
;; Stiff motions

(define stiff-heading
  '("Radau IIA, CPU ms" "first" "again" "Jacobian" "the same by D" "SciPy" "again : SciPy"))

(define (stiff-rows)
  (for/list ([s (in-list (stiff-motions))])
    (define-values (first again) (our-times s 'Radau-IIA-5))
    (define theirs (scipy-time s "Radau"))
    (list (motion-name s) (milliseconds first) (milliseconds again)
          (milliseconds (derivatives-time s)) (time-by-D s)
          (theirs-text theirs) (compared again theirs))))

;; -> the least of the first and of the second motions of a state derivative
(define (our-times s method)
  (define f (motion-derivative s))
  (define (time)
    (define-values (_ ms)
      (call/cpu (lambda ()
                  (evolve-trajectory f (motion-start s) (motion-end s)
                                     #:tolerance (motion-tolerance s) #:method method))))
    ms)
  (for/fold ([first +inf.0] [again +inf.0]) ([_ (in-range repetitions)])
    (forget!)
    (define a (time))
    (values (min first a) (min again (time)))))

(define (forget!)
  (clear-compiled-programs)
  (clear-kept-systems))

(define (derivatives-time s)
  (forget!)
  (define made (make-system 'bench (motion-derivative s) (motion-start s)))
  (define-values (_ ms) (call/cpu (lambda () ((system-make-jacobian! made)))))
  ms)

;; Beyond that it takes minutes.
(define most-by-D 20)

(define (time-by-D s)
  (cond [(> (shape-length (motion-start s)) most-by-D) "–"]
        [else
         (define-values (_ ms)
           (call/cpu (lambda () (compile-function (D (motion-derivative s)) (motion-start s)))))
         (milliseconds ms)]))

;; ---------------------------------------------------------------------------
;; Constrained motions

(define projected-heading
  '("constrained motion, CPU ms" "first" "again" "rates alone, by D" "SciPy, not projected"
    "again : SciPy"))

(define (projected-rows)
  (for/list ([s (in-list (projected-motions))])
    (define-values (first again) (our-times s 'Dormand-Prince-853))
    (define theirs (scipy-time s "DOP853"))
    (define-values (_ by-D)
      (call/cpu (lambda () (compile-function (motion-derivative s) (motion-start s)))))
    (list (motion-name s) (milliseconds first) (milliseconds again) (milliseconds by-D)
          (theirs-text theirs) (compared again theirs))))

;; ---------------------------------------------------------------------------
;; In SciPy

;; -> milliseconds, or why there are none
(define (scipy-time s method)
  (define text (python (SciPy-program s method)))
  (or (string->number text) text))

(define (theirs-text x) (if (number? x) (milliseconds x) x))
(define (compared ours theirs) (if (number? theirs) (ratio ours theirs) "–"))

(define (program-of s)
  (define f (motion-derivative s))
  (define code (Lagrangian-code 'bench f (motion-start s)))
  (if code
      (compiled-function-program code)
      (let-values ([(p _) (trace 'bench f (motion-start s))]) p)))

(define (SciPy-program s method)
  (format #<<PYTHON
import time
from math import *
from numpy.linalg import solve
from scipy.integrate import solve_ivp
def slope(t, y):
    y = y.tolist()
    dy = [0.0]*len(y)
~a    return dy
def run():
    solve_ivp(slope, (0, ~a), [~a], method="~a", rtol=~a, atol=~a)
run()
start = time.process_time()
run()
print(round(1e3*(time.process_time() - start)))
PYTHON
          (program->Python (program-of s))
          (motion-end s)
          (string-join (map number->string (scalars (motion-start s))) ", ")
          method (motion-tolerance s) (motion-tolerance s)))
