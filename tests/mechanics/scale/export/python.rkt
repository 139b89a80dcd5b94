#lang racket/base
;; Systems exported as packages of Python and modules for JAX, where these are installed.

(require json
         racket/flonum
         racket/list
         mechanics mechanics/book
         mechanics/value/shape
         tests/mechanics/support/exported tests/mechanics/support/python
         tests/mechanics/support/random tests/mechanics/support/skip
         "../../support/checks.rkt" "../../support/folder.rkt")

(define numpy (and compiler? (python-with "numpy")))
(define dask (and compiler? (python-with "numpy" "distributed")))
(define JAX (python-with "jax"))

(define general (Lagrangian->state-derivative (L-Kepler-polar 'GM 'm)))
(define particular (Lagrangian->state-derivative (L-Kepler-polar 1.0 0.5)))
(define example (up 't (up 'r 'phi) (up 'rdot 'phidot)))

(define (call-with-exported target use)
  (with-folder (folder)
    (export-system general example #:language target #:name "Kepler" #:folder folder
                   #:replace? #t #:derivatives? #t)
    (use folder)))

;; The output of the script, read as JSON, with the list of rows as `rows`.
(define (python-value python folder rows script)
  (define head (format "import json\nrows = json.loads('~a')\n" (jsexpr->string rows)))
  (string->jsexpr (run-python python folder (string-append head script))))

(define (random-rows n)
  (with-seed 20
    (for/list ([_ n])
      (list 0.0 (+ 0.5 (random)) (random) (* 0.1 (random)) (+ 0.7 (* 0.5 (random)))))))

(define (row->state row) (flvector->structure example (apply flvector row)))
(define (state->row s) (map real->double-flonum (scalars s)))

(define (check-rows found expected tolerance)
  (check-equal? (length found) (length expected))
  (for ([row found] [other expected])
    (for ([a row] [b other])
      (unless (<= (abs (- a b)) (* tolerance (+ 1 (abs b)))) (check-equal? row other)))))

(test-case "a package of Python follows rows of starts, and refuses rows of another width"
  (skip-unless numpy "exported Python: there is no compiler, or no NumPy"
    (call-with-exported
     'python
     (lambda (folder)
       (define rows (random-rows 40))
       (define found
         (python-value numpy folder rows #<<script
import Kepler
def bad(call):
    try:
        call()
    except ValueError as e:
        return str(e)
states = Kepler.evolve(rows, (1.0, 0.5), 3.0, 1e-9)
print(json.dumps({
    "names": [Kepler.variables, Kepler.parameters],
    "states": states.tolist(),
    "rates": [Kepler.derivative(r, (1.0, 0.5)).tolist() for r in rows],
    "jacobian": Kepler.jacobian(rows[0], (1.0, 0.5)).tolist(),
    "bad": [bad(lambda: Kepler.evolve([[1, 2]], (1.0, 0.5), 3.0)),
            bad(lambda: Kepler.evolve(rows, (1.0,), 3.0)),
            bad(lambda: Kepler.evolve(rows, [(1.0, 0.5)] * 3, 3.0))]}))
script
                       ))
       (check-equal? (hash-ref found 'names)
                     '(("t" "r" "phi" "rdot" "phidot") ("GM" "m")))
       (check-rows (hash-ref found 'rates)
                   (for/list ([r rows]) (state->row (particular (row->state r)))) 1e-14)
       (check-rows (hash-ref found 'states)
                   (for/list ([r rows])
                     (state->row ((evolve-trajectory particular (row->state r) 3
                                                     #:tolerance 1e-9
                                                     #:method 'Dormand-Prince-853)
                                  3)))
                   1e-12)
       (check-equal? (map length (hash-ref found 'jacobian)) '(7 7 7 7 7))
       (for ([message (hash-ref found 'bad)]
             [rx '(#rx"expected starts as rows of 5" #rx"rows of 2 numbers" #rx"40 starts and 3")])
         (check-regexp-match rx message))))))

(test-case "a module for JAX has our rates, follows motions, and is differentiated"
  (skip-unless JAX "exported JAX: JAX is not installed"
    (call-with-exported
     'JAX
     (lambda (folder)
       (define rows (random-rows 1000))
       (define found
         (python-value JAX folder rows #<<script
import jax, jax.numpy as jnp, Kepler
p = jnp.array([1.0, 0.5])
y = jnp.array(rows)
rates = jax.vmap(lambda y: Kepler.derivative(y, p))(y)
few = y[:20]
ends = jax.vmap(lambda y: Kepler.evolve(y, p, 3.0, 1e-10))(few)
steps = jax.vmap(lambda y: Kepler.evolve_steps(y, p, 3.0, 30000))(few)
flow = jax.jacfwd(lambda y: Kepler.evolve(y, p, 3.0, 1e-10))(y[0])
print(json.dumps({"rates": rates.tolist(), "ends": ends.tolist(), "steps": steps.tolist(),
                  "flow": flow.tolist()}))
script
                       ))
       (check-rows (hash-ref found 'rates)
                   (for/list ([r rows]) (state->row (particular (row->state r)))) 2e-15)
       (define ends
         (for/list ([r (take rows 20)])
           (state->row ((state-advancer particular) (row->state r) 3.0 1e-12))))
       (check-rows (hash-ref found 'ends) ends 1e-7)
       (check-rows (hash-ref found 'steps) ends 1e-8)
       (define columns
         (scalars ((linearized-flow particular) (row->state (car rows)) 3.0 1e-12)))
       ;; but for the time: ours is the derivative at a duration, not at an end
       (check-rows (list (append* (cdr (apply map list (cdr (hash-ref found 'flow))))))
                   (list (append* (for/list ([k (in-range 1 5)])
                                    (cdr (take (drop columns (* 5 k)) 5)))))
                   1e-5)))))

(test-case "over a cluster every batch is there once, though a worker is killed"
  (skip-unless dask "exported Python over a cluster: distributed is not installed"
    (call-with-exported
     'python
     (lambda (folder)
       (define rows (random-rows 400))
       (define found
         (python-value dask folder rows #<<script
import os, signal, Kepler, numpy as np
from Kepler.ensemble import evolve_on
from distributed import Client, LocalCluster
import logging
logging.disable(logging.CRITICAL)
if __name__ == "__main__":
    os.environ["PYTHONPATH"] = os.getcwd()
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        with Client(cluster) as client:
            seen = []
            def each(index):
                seen.append(index)
                if len(seen) == 3:
                    pid = next(iter(client.run(os.getpid).values()))
                    os.kill(pid, signal.SIGKILL)
            states, status = evolve_on(client, rows, (1.0, 0.5), 3.0, 1e-9, batch=16,
                                       checkpoint="run", each=each)
            again = []
            other, _ = evolve_on(client, rows, (1.0, 0.5), 3.0, 1e-9, batch=16,
                                 checkpoint="run", each=again.append)
            os.remove("run/batch-00000004.npz")
            evolve_on(client, rows, (1.0, 0.5), 3.0, 1e-9, batch=16,
                      checkpoint="run", each=again.append)
            try:
                evolve_on(client, rows, (1.0, 0.5), 4.0, 1e-9, batch=16, checkpoint="run")
            except ValueError as e:
                refused = str(e)
    alone = Kepler.evolve(rows, (1.0, 0.5), 3.0, 1e-9)
    print(json.dumps({"seen": sorted(seen), "again": again, "refused": refused,
                      "same": bool((states == alone).all() and (other == alone).all())}))
script
                       ))
       (check-true (hash-ref found 'same))
       (check-equal? (hash-ref found 'seen) (range 25))
       (check-equal? (hash-ref found 'again) '(4))
       (check-regexp-match #rx"of another ensemble" (hash-ref found 'refused))))))
