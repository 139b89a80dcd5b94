#lang racket/base
;; The integrator beside itself in C, and beside SciPy's.
;;
;; dop853.c is our method of order 8 with the same control of steps; a C compiler, where
;; there is one, makes a program of it and of a right-hand side in C.  That is one of
;; two: the operations our compiler found, one after the other, so that what is compared
;; is the machine code; and formulas a programmer would have written down.  Steps and
;; evaluations are counted on both sides: they are to be the same.
;;
;; Ours is machine code that the library writes itself (numeric/ode/method-code.rkt).  Of few
;; components a whole step is straight code, in which a slope goes from the rates to the next stage
;; in registers; of many, loops work on two components at a time.  Both save what C spends on memory
;; between its function of the rates and its loops; and what chooses the next step's length, in
;; Racket, takes that again.

(require racket/fixnum racket/flonum racket/runtime-path racket/string
         (only-in mechanics/compile/trace trace)
         (only-in mechanics/motion/system/make-system make-system)
         (only-in mechanics/motion/system/system system-right-hand-side)
         (only-in mechanics/value/shape structure->flvector)
         mechanics/numeric/ode/dormand-prince-853 mechanics/numeric/ode/integrate
         "C.rkt" "clock.rkt" "motion-systems.rkt" "program-text.rkt" "python.rkt"
         "table.rkt")

(provide native-heading native-rows)

(define-runtime-path dop853.c "dop853.c")

(define native-heading
  '("integration, CPU ms" "ours" "steps, evaluations" "C" "steps, evaluations" "ours : C"
    "C by hand" "ours : it" "SciPy"))

(define (native-rows)
  (for/list ([s (in-list (motions))])
    (define-values (ours count) (our-figures s))
    (define same (c-figures s (program->C (traced s))))
    (define by-hand (c-figures s (motion-by-hand s)))
    (list (motion-name s)
          (milliseconds ours)
          count
          (c-time same) (c-count same) (c-ratio ours same)
          (c-time by-hand) (c-ratio ours by-hand)
          (python (SciPy-program s)))))

;; ---------------------------------------------------------------------------
;; Ours

(define repetitions 15)

(define (our-figures s)
  (define y (structure->flvector (motion-start s) values))
  (define f! (system-right-hand-side (make-system 'bench (motion-derivative s) (motion-start s))
                                     dormand-prince-853))
  (define steps 0)
  (define evaluations 0)
  (define (counted-f! y dy)
    (set! evaluations (+ evaluations 1))
    (f! y dy))
  (define (counted-step show)
    (lambda (from to interpolant)
      (set! steps (+ steps 1))
      (show from to interpolant)))
  (define (run f! count-steps)
    (define-values (end last)
      (integrate dormand-prince-853 f! y 0.0 (motion-end s)
                 #:tolerance (motion-tolerance s) #:clock 0
                 #:visit (count-steps (sampler (motion-output-step s) (flvector-length y)))))
    last)
  (run counted-f! counted-step)
  (define times
    (for/list ([_ (in-range repetitions)])
      (define-values (_ ms) (call/cpu (lambda () (run f! values))))
      ms))
  (values (apply min times) (format "~a, ~a" steps evaluations)))

;; Interpolates the state every `step`, or never if that is 0, as dop853.c does.
(define (sampler step n)
  (define out (make-flvector n))
  (define sum (make-flvector 1))
  (define shown 1)
  (define (due k) (fl* (fx->fl k) step))
  (define (show from to interpolant)
    (when (fl<= (due shown) to)
      (set! shown (show-until (interpolant) from to shown)))
    #t)
  (define (show-until at from to k)
    (cond [(fl<= (due k) to)
           (at (fl/ (fl- (due k) from) (fl- to from)) out)
           (flvector-set! sum 0 (fl+ (flvector-ref sum 0) (flvector-ref out 1)))
           (show-until at from to (fx+ k 1))]
          [else k]))
  (if (fl> step 0.0) show (lambda (from to interpolant) #t)))

;; ---------------------------------------------------------------------------
;; In C

(define (traced s)
  (define-values (program _) (trace 'bench (motion-derivative s) (motion-start s)))
  program)

;; body : of a function (y, dy), or #f
;; -> (steps evaluations milliseconds state ...), or why there is none, a string
(define (c-figures s body)
  (if body
      (run-C (list dop853.c) (system-in-C s body)
             (map number->string (list (motion-tolerance s) (motion-end s)
                                       (motion-output-step s) repetitions)))
      "–"))

(define (system-in-C s body)
  (define y (structure->flvector (motion-start s) values))
  (string-append
   "#include <math.h>\n" solve-in-C
   (format "const int size = ~a;\n" (flvector-length y))
   (format "const double initial[] = {~a};\n" (flvector->text y))
   "void slope(const double *y, double *dy)\n{\n" body "}\n"))

(define (flvector->text v)
  (string-join (for/list ([x (in-flvector v)]) (number->string x)) ", "))

(define (c-time figures) (if (pair? figures) (milliseconds (caddr figures)) figures))
(define (c-count figures)
  (if (pair? figures) (format "~a, ~a" (car figures) (cadr figures)) "–"))
(define (c-ratio ours figures) (if (pair? figures) (ratio ours (caddr figures)) "–"))

;; ---------------------------------------------------------------------------
;; In SciPy, from the same operations

(define (SciPy-program s)
  (define y (structure->flvector (motion-start s) values))
  (format #<<PYTHON
import time
from math import *
from numpy.linalg import solve
from scipy.integrate import solve_ivp
def slope(t, y):
    dy = [0.0]*len(y)
~a    return dy
start = time.process_time()
solve_ivp(slope, (0, ~a), [~a], method="DOP853", rtol=~a, atol=~a, t_eval=~a)
print(round(1e3*(time.process_time() - start)))
PYTHON
          (program->Python (traced s))
          (motion-end s)
          (flvector->text y)
          (motion-tolerance s) (motion-tolerance s)
          (Python-times (motion-output-step s) (motion-end s))))

(define (Python-times step end)
  (if (> step 0)
      (format "[min(k*~a, ~a) for k in range(~a)]" step end
              (+ 1 (inexact->exact (round (/ end step)))))
      "None"))
