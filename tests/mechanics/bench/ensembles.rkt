#lang racket/base
;; Ten thousand driven pendulums: ours on one core and on two, the exported C, and JAX, diffrax and
;; heyoka where they are installed.
;;
;; Elapsed time is what more cores make less; CPU time is what a busy machine leaves alone.
;; Compilation before the first motion is in ours, and not in those of Python.

(require racket/file
         racket/string
         mechanics
         "clock.rkt" "motion-systems.rkt" "table.rkt"
         tests/mechanics/support/exported tests/mechanics/support/python)

(provide ensembles-heading ensembles-rows)

(define ensembles-heading
  '("driven pendulums to t = 100, error 1e-9" "s" "CPU s" "motions a second" "speed-up"))

(define end 100)
(define tolerance 1e-9)

(define (starts count)
  (for/list ([k (in-range count)]) (up 0.0 (+ 0.5 (/ (* 1.0 k) count)) 0.0)))

;; label; elapsed and CPU seconds, or why there are none; the same on one core, or #f
(define (row label count figures [alone #f])
  (if (string? figures)
      (list label figures "–" "–" "–")
      (list label (milliseconds* (car figures)) (milliseconds* (cdr figures))
            (number->string (inexact->exact (round (/ count (car figures)))))
            (if (pair? alone) (ratio (car alone) (car figures)) "–"))))

(define (milliseconds* seconds) (number->string (/ (round (* 100 seconds)) 100)))

;; -> (cons elapsed CPU), in seconds, of this process and of those that end meanwhile
(define (timed thunk)
  (collect-garbage)
  (define before (+ (cpu-milliseconds) (processes-milliseconds)))
  (define start (current-inexact-milliseconds))
  (thunk)
  (define elapsed (- (current-inexact-milliseconds) start))
  (sleep 0.3)                           ; until workers have ended, and are counted
  (cons (* 1e-3 elapsed)
        (* 1e-3 (- (+ (cpu-milliseconds) (processes-milliseconds)) before))))

(define (ensembles-rows [count 10000])
  (define-values (one two) (values (ours count 1) (ours count 2)))
  (append
   (list (row "evolve-ensemble, 1 job" count one)
         (row "evolve-ensemble, 2 jobs" count two one))
   (C-rows count)
   (list (row "JAX, order 5" count (in-JAX count JAX-script "jax"))
         (row "JAX with diffrax, order 8" count (in-JAX count diffrax-script "jax" "diffrax"))
         (row "heyoka, Taylor" count (in-heyoka count)))))

;; ---------------------------------------------------------------------------

(define (ours count jobs)
  (define ps (for/list ([_ (in-range count)]) driven-parameters))
  (timed
   (lambda ()
     (evolve-ensemble driven-pendulum (starts count) end #:parameters ps #:tolerance tolerance
                      #:jobs jobs #:collect coordinate #:fold + #:initial 0.0 #:progress? #f))))

(define symbols '(m l g a w))

(define (export-to target folder)
  (export-system (apply driven-pendulum symbols) (up 't 'angle 'v) #:language target #:name "driven"
                 #:folder folder #:parameters symbols))

(define (in-new-folder use)
  (define folder (make-temporary-file "bench~a" 'directory))
  (dynamic-wind void
                (lambda () (use folder))
                (lambda () (delete-directory/files folder))))

(define (C-rows count)
  (define labels '("exported C, 1 thread" "exported C, 2 threads"))
  (if compiler?
      (in-new-folder
       (lambda (folder)
         (define to (build-path folder "driven"))
         (export-to 'C to)
         (run-in to "make" "-s")
         (define figures (for/list ([n '("1" "2")]) (in-C to count n)))
         (for/list ([label labels] [f figures] [alone (list #f (car figures))])
           (row label count f alone))))
      (for/list ([label labels]) (row label count "no C compiler"))))

(define (in-C folder count threads)
  (define input
    (apply string-append
           (for/list ([s (starts count)])
             (string-join (map number->string (append (structure->list s) driven-parameters)) " "
                          #:after-last "\n"))))
  (putenv "OMP_NUM_THREADS" threads)
  (timed (lambda ()
           (run-in folder (build-path folder "driven") (number->string end)
                   (number->string tolerance) #:input input))))

;; ---------------------------------------------------------------------------
;; Scripts print elapsed and CPU seconds.

(define (in-JAX count script . modules)
  (define python (apply python-with modules))
  (if python
      (in-new-folder
       (lambda (folder)
         (define to (build-path folder "driven"))
         (export-to 'JAX to)
         (figures-of (run-python python to (string-append (head count) script)))))
      "not installed"))

(define (in-heyoka count)
  (define python (python-with "heyoka"))
  (if python
      (in-new-folder
       (lambda (folder)
         (figures-of (run-python python folder (string-append (head count) heyoka-script)))))
      "not installed"))

(define (figures-of text)
  (define all (map string->number (string-split text)))
  (if (and (= 2 (length all)) (andmap real? all)) (cons (car all) (cadr all)) "failed"))

(define (head count)
  (format "import time\ncount, end, tolerance = ~a, ~a.0, ~a\np = [~a]\n" count end tolerance
          (string-join (map number->string driven-parameters) ", ")))

(define measured #<<python
def measured(run):
    run()
    wall, cpu = time.perf_counter(), time.process_time()
    run()
    print(time.perf_counter() - wall, time.process_time() - cpu)

python
  )

(define JAX-script
  (string-append measured #<<python
import jax, jax.numpy as jnp, driven
k = jnp.arange(count)
y = jnp.stack([0.0 * k, 0.5 + k / count, 0.0 * k], axis=1)
p = jnp.array(p)
f = jax.jit(jax.vmap(lambda y: driven.evolve(y, p, end, tolerance)))
measured(lambda: f(y).block_until_ready())
python
                 ))

(define diffrax-script
  (string-append measured #<<python
import jax, jax.numpy as jnp, driven, diffrax
k = jnp.arange(count)
y = jnp.stack([0.0 * k, 0.5 + k / count, 0.0 * k], axis=1)
p = jnp.array(p)
term = diffrax.ODETerm(lambda t, y, p: driven.derivative(y, p))
control = diffrax.PIDController(rtol=tolerance, atol=tolerance)
def follow(y):
    return diffrax.diffeqsolve(term, diffrax.Dopri8(), 0.0, end, 0.01, y, p, max_steps=100000,
                               stepsize_controller=control).ys[-1]
f = jax.jit(jax.vmap(follow))
measured(lambda: f(y).block_until_ready())
python
                 ))

;; The equation of motion written for heyoka, which needs its own expressions.
(define heyoka-script
  (string-append measured #<<python
import heyoka as hy
m, l, g, a, w = p
x, v = hy.make_vars("x", "v")
force = -(g - a * w * w * hy.cos(w * hy.time)) / l * hy.sin(x)
ta = hy.taylor_adaptive([(x, v), (v, force)], [0.5, 0.0], tol=tolerance)
def start(ta, k):
    ta.time = 0.0
    ta.state[:] = [0.5 + k / count, 0.0]
    return ta
measured(lambda: hy.ensemble_propagate_until(ta, end, count, start))
python
                 ))

(module+ main
  (define words (current-command-line-arguments))
  (define count (if (zero? (vector-length words)) 10000 (string->number (vector-ref words 0))))
  (display (table->string (cons ensembles-heading (ensembles-rows count)))))
