#lang racket/base
;; The Taylor method beside heyoka's (github.com/bluescarni/heyoka): on the same operations, and on
;; the system as heyoka's user writes it.
;;
;; heyoka compiles a system by LLVM, which takes most of a tenth of a second; that is counted
;; apart.  Events are crossings of x = 0 with growing x.

(require racket/flonum racket/string
         (only-in mechanics/compile/trace trace)
         (only-in mechanics/motion/event/event event)
         (only-in mechanics/motion/evolution evolve state-advancer)
         (only-in mechanics/motion/evolve-trajectory evolve-trajectory)
         (only-in mechanics/value/shape structure->flvector)
         (only-in mechanics ref)
         "clock.rkt" "heyoka-systems.rkt" "motion-systems.rkt"
         "program-text.rkt" "python.rkt" "table.rkt")

(provide Taylor-heading Taylor-rows)

(define Taylor-heading
  '("Taylor method, CPU ms" "ours" "by DOP853" "heyoka, by hand" "ours : that"
    "heyoka, our operations" "ours : that" "heyoka compiles" "ours, first run"))

(define repetitions 9)

(define (Taylor-rows)
  (append (for/list ([s (in-list (motions))]) (row s (advancing s) #f))
          (list (let ([s (Henon-Heiles-long)]) (row s (crossing s) #t)))))

(define (Henon-Heiles-long)
  (motion "Hénon–Heiles to 60 000 with its crossings" Henon-Heiles
          (Henon-Heiles-start 1/12 0.1 0.0) 60000.0 1e-12 0.0 #f))

;; run : method -> thunk that integrates, which has compiled what it needs after one call
(define (row s run events?)
  (define-values (first ours) (times (run 'Taylor)))
  (define-values (_ other) (times (run 'Dormand-Prince-853)))
  (define by-hand (heyoka-by-user s events?))
  (define of-ours (heyoka-of-operations s events?))
  (append (list (motion-name s) (milliseconds ours) (milliseconds other))
          (beside ours by-hand)
          (beside ours of-ours)
          (list (cond [(pair? by-hand) (milliseconds (cadr by-hand))]
                      [(pair? of-ours) (milliseconds (cadr of-ours))]
                      [else "–"])
                (milliseconds first))))

;; peer : list of milliseconds and those of compilation, or a string
(define (beside ours peer)
  (if (pair? peer)
      (list (milliseconds (car peer)) (ratio ours (car peer)))
      (list peer "–")))

(define (times thunk)
  (define-values (_ first) (call/cpu thunk))
  (values first
          (apply min (for/list ([_ (in-range repetitions)])
                       (define-values (r ms) (call/cpu thunk))
                       ms))))

;; Where outputs are wanted, each of them is a state that a monitor sees.
(define ((advancing s) method)
  (define (maker) (motion-derivative s))
  (define advance (state-advancer maker))
  (define follow (evolve maker))
  (define-values (start end tolerance)
    (values (motion-start s) (motion-end s) (motion-tolerance s)))
  (define step (motion-output-step s))
  (if (> step 0.0)
      (lambda () (follow start void step end tolerance #:method method))
      (lambda () (advance start end tolerance #:method method))))

(define ((crossing s) method)
  (define section (event (lambda (s) (ref s 1 0)) #:direction 'rising))
  (lambda ()
    (evolve-trajectory (motion-derivative s) (motion-start s) (motion-end s)
                       #:tolerance (motion-tolerance s) #:events section #:method method)))

;; ---------------------------------------------------------------------------

;; Both -> (milliseconds milliseconds-to-compile), or why there are none

(define (heyoka-by-user s events?)
  (define text (heyoka-by-hand (motion-name s)))
  (if text (heyoka s text events?) "–"))

(define (heyoka-of-operations s events?)
  (define-values (program _) (trace 'bench (motion-derivative s) (motion-start s)))
  (define text (program->Python program))
  (define y (structure->flvector (motion-start s) values))
  (if (string-contains? text "solve(")
      "–"
      (heyoka s (operations-program text y) events?)))

(define (heyoka s text events?) (numbers-of (python/text (heyoka-program text s events?))))

(define (operations-program text y)
  (format #<<PYTHON
n = ~a
y = [hy.time] + list(hy.make_vars(*["y%d" % k for k in range(1, n)]))
def system():
    dy = [0.0]*n
~a    return [(y[k], hy.expression(0.0) + dy[k]) for k in range(1, n)]
equations = system()
start = [~a][1:]

PYTHON
          (flvector-length y) text
          (string-join (for/list ([x (in-flvector y)]) (number->string x)) ", ")))

;; text : defines the equations, a list of pairs, and the start, without the time
(define (heyoka-program text s events?)
  (format #<<PYTHON
import time
import heyoka as hy
import numpy as np
from heyoka import sin, cos, tan, exp, log, sqrt
~aend = ~a
outputs = ~a
crossings = []
def crossed(integrator, t, *sign):
    crossings.append(t)
before = time.process_time()
rising = hy.event_direction.positive
events = [hy.nt_event(equations[0][0], crossed, direction=rising)] if ~a else []
ta = hy.taylor_adaptive(equations, start, tol=~a, nt_events=events)
compiled = time.process_time() - before
best = 1e9
for _ in range(~a):
    ta.time = 0.0
    ta.state[:] = start
    before = time.process_time()
    if outputs: ta.propagate_grid(np.linspace(0.0, end, outputs + 1))
    else: ta.propagate_until(end)
    best = min(best, time.process_time() - before)
print("%.4f %.4f" % (1e3*best, 1e3*compiled))
PYTHON
          text (motion-end s) (output-count s) (if events? "True" "False")
          (motion-tolerance s) repetitions))

(define (output-count s)
  (define step (motion-output-step s))
  (if (> step 0.0) (inexact->exact (round (/ (motion-end s) step))) 0))
