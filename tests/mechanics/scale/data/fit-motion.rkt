#lang racket/base
;; Systems fitted to measured data: certified values, the truth within its deviations, SciPy.

(require json
         mechanics
         (only-in mechanics/error/progress current-reporter reporter)
         (only-in mechanics/book L-pendulum)
         (only-in mechanics/plot frame frame-curves frame-points plot-residuals)
         "../../support/checks.rkt" "../../support/folder.rkt" "../../support/messages.rkt"
         "../../support/python.rkt"
         "../../support/random.rkt" "../../support/skip.rkt")

;; ---------------------------------------------------------------------------
;; NIST, Statistical Reference Datasets, Misra1a: y = b₁ (1 − exp(−b₂ x)), as a motion along x

(define Misra1a
  '((77.6 10.07) (114.9 14.73) (141.1 17.94) (190.8 23.93) (239.9 29.61) (289.0 35.18)
    (332.8 40.02) (378.4 44.82) (434.8 50.76) (477.3 55.05) (536.8 61.01) (593.1 66.40)
    (689.1 75.47) (760.0 81.78)))
(define (saturating b1 b2) (lambda (s) (up (* b2 (- b1 (ref s 0))))))

(define-check (check-close found expected part)
  (unless (<= (abs (- found expected)) (* part (abs expected))) (fail-check)))

(test-case "values, deviations and sum of squares are those that NIST certifies"
  (for ([guesses '(((b1 500) (b2 0.0001)) ((b1 250) (b2 0.0005)))])
    (define f (fit-motion saturating (up 0.0) Misra1a #:parameters guesses #:hold '(x0)))
    (check-equal? (map car (motion-fit-values f)) '(b1 b2))
    (for ([v (motion-fit-values f)] [expected '(238.94212918 5.5015643181e-4)])
      (check-close (cadr v) expected 1e-7))
    (for ([d (motion-fit-deviations f)] [expected '(2.7070075241 7.2668688436e-6)])
      (check-close (cadr d) expected 1e-6))
    (check-close (motion-fit-chi-square f) 0.12455138894 1e-8)))

;; ---------------------------------------------------------------------------
;; A pendulum whose angle is measured

(define (pendulum g l) (Lagrangian->state-derivative (L-pendulum g 1 l)))
(define (angle s) (ref s 1))
(define start (up 0 1.0 0.3))
(define truth (evolve-trajectory (pendulum 9.8 1.2) start 10))
(define times (for/list ([k (in-range 1 41)]) (/ k 4.0)))

(define (gaussian) (* (sqrt (* -2 (log (random)))) (cos (* 2 pi (random)))))
(define (measurements deviation)
  (for/list ([t times]) (up t (+ (angle (truth t)) (* deviation (gaussian))))))

(define (fitted data #:deviation [deviation #f])
  (fit-motion pendulum (up 0 0.9 0) data #:parameters '((g 9.8) (l 1.1)) #:hold '(g)
              #:measured angle #:deviation deviation))

;; A number that converges to 0 has no size of its own.
(test-case "an unknown may be 0"
  (define ((oscillator w) s) (up 1 (ref s 2) (* -1 w w (ref s 1))))
  (for* ([guess '(0.9 -0.9)] [(f q+v) (in-parallel (list cos sin) '((1 0) (0 1.2)))])
    (define-values (q v) (apply values q+v))
    (define data (for/list ([k 31]) (list (/ k 10.0) (f (* 0.12 k)))))
    (define found (fit-motion oscillator (up 0 guess 0) data #:parameters '((w 1.0))
                              #:measured angle))
    (for ([value (motion-fit-values found)] [expected (list q v 1.2)])
      (check-= (cadr value) expected 1e-9))))

(test-case "a state without the time is fitted whole"
  (define ((decay k) s) (up (* -1 k (ref s 0))))
  (define data (for/list ([t '(0.0 0.5 1.0 2.0)]) (list t (* 2 (exp (* -0.7 t))))))
  (define found (motion-fit-values (fit-motion decay (up 1.5) data #:parameters '((k 1)))))
  (check-equal? (map car found) '(x0 k))
  (for ([v found] [true '(2 0.7)]) (check-close (cadr v) true 1e-8)))

(test-case "a picture of the residuals: a point for each row, about a line at 0"
  (define f (fitted (measurements 0.01)))
  (define picture (frame 0 10 -0.05 0.05))
  (plot-residuals picture f #:color 'red)
  (check-equal? (frame-points picture)
                (for/list ([row (motion-fit-residuals f)]) (vector (ref row 0) (ref row 1))))
  (check-equal? (frame-curves picture) '((#(0.0 0.0) #(10.0 0.0))))
  (check-message (string-append "plot-residuals: expected which of 1 measured numbers, from 0\n"
                                "  given: the number 1")
                 (plot-residuals picture f 1))
  (check-message "plot-residuals: expected a fit, as fit-motion gives it\n  given: the number 3"
                 (plot-residuals picture 3)))

(test-case "data without noise give the truth back"
  (define f (fitted (measurements 0)))
  (for ([v (motion-fit-values f)] [true '(1.0 0.3 1.2)]) (check-close (cadr v) true 1e-8))
  (check-equal? (map car (motion-fit-values f)) '(q v l))
  (check-equal? (motion-fit-parameters f) (list 9.8 (cadr (list-ref (motion-fit-values f) 2))))
  (check-equal? (ref (motion-fit-start f) 1) (cadr (car (motion-fit-values f))))
  (check-equal? (length (motion-fit-residuals f)) 40))

(test-case "the truth is within two deviations in 90 to 99 of 100 cases"
  (define within (make-vector 3 0))
  (with-seed 41
    (for ([_ 100])
      (define f (fitted (measurements 0.02) #:deviation 0.02))
      (for ([v (motion-fit-values f)] [d (motion-fit-deviations f)] [true '(1.0 0.3 1.2)] [k 3])
        (when (< (abs (- (cadr v) true)) (* 2 (cadr d)))
          (vector-set! within k (+ 1 (vector-ref within k)))))))
  (for ([n within]) (check-true (<= 90 n 99) (format "~a" within))))

(test-case "a deviation that is not given is estimated"
  (define f (with-seed 5 (fitted (measurements 0.02))))
  (define known (with-seed 5 (fitted (measurements 0.02) #:deviation 0.02)))
  (define estimate (sqrt (/ (motion-fit-chi-square f) 37)))
  (check-true (< 0.015 estimate 0.025))
  (for ([d (motion-fit-deviations f)] [e (motion-fit-deviations known)])
    (check-close (cadr d) (* (/ estimate 0.02) (cadr e)) 1e-6))
  (check-regexp-match
   (pregexp (string-append "^motion fitted to 40 numbers\n  q = [01].\\d{4} ± 0.00[1-9]\\d\n"
                           ".*\n  deviation of the data 0.0\\d+$"))
   (format "~a" f))
  (check-regexp-match #px"\n  chi-square [\\d.]+, of 37 expected$" (format "~a" known)))

(test-case "progress is told by sums of squares"
  (define port (open-output-string))
  (define now 0)
  (define (clock)
    (set! now (+ now 1000))
    now)
  (parameterize ([current-reporter (reporter port clock)])
    (fit-motion saturating (up 0.0) Misra1a #:parameters '((b1 500) (b2 0.0001)) #:hold '(x0)
                #:progress? #t))
  (check-regexp-match #rx"fit-motion: sum of squares [0-9.]+" (get-output-string port)))

(test-case "several columns, each with its deviation, from a table"
  (with-folder (folder)
    (define file (build-path folder "a.csv"))
    (write-table truth file #:times times)
    (define f
      (fit-motion pendulum (up 0 0.9 0) (read-table file) #:parameters '((g 9.8) (l 1.1))
                  #:hold '(g) #:deviation '(0.1 0.2)))
    (for ([v (motion-fit-values f)] [true '(1.0 0.3 1.2)]) (check-close (cadr v) true 1e-8))
    (define c (motion-fit-covariance f))
    (check-close (matrix-ref c 0 1) (matrix-ref c 1 0) 1e-12)
    (check-close (cadr (car (motion-fit-deviations f))) (sqrt (matrix-ref c 0 0)) 1e-12)))

(test-case "a motion that breaks off during the search is not the end of it"
  (define (falling k) (lambda (s) (up 1 (/ (- k) (ref s 1)))))       ; q² = q₀² − 2kt
  (define data (for/list ([t '(0.0 1.0 1.5 1.9)]) (list t (sqrt (- 4 (* 2 t))))))
  (define f (fit-motion falling (up 0 2.0) data #:parameters '((k 0.01)) #:hold '(x1)
                        #:measured (component 1)))
  (check-close (cadr (assq 'k (motion-fit-values f))) 1.0 1e-6))

;; ---------------------------------------------------------------------------
;; SciPy

(define python (python-with "numpy" "scipy"))

(define script #<<end
import json
import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import least_squares
rows = np.genfromtxt('data.csv', delimiter=',', names=True)
def residuals(x):
    q, v, l = x
    s = solve_ivp(lambda t, y: [y[1], -9.8 / l * np.sin(y[0])], (0, 10), [q, v],
                  t_eval=rows['t'], method='DOP853', rtol=1e-11, atol=1e-12)
    return s.y[0] - rows['q']
r = least_squares(residuals, [0.9, 0, 1.1], jac='3-point', xtol=1e-13, ftol=1e-13, gtol=1e-13)
c = np.linalg.inv(r.jac.T @ r.jac) * 2 * r.cost / (len(rows) - 3)
print(json.dumps([list(r.x), list(np.sqrt(np.diag(c)))]))
end
  )

(test-case "SciPy's least_squares finds the same"
  (skip-unless python "a Python with SciPy: a fit compared"
    (with-folder (folder)
      (define data (with-seed 8 (measurements 0.02)))
      (write-table data (build-path folder "data.csv") #:names '(t q))
      (define found (string->jsexpr (run-python python folder script)))
      (define f (fitted data))
      (for ([v (motion-fit-values f)] [other (car found)]) (check-close (cadr v) other 1e-6))
      (for ([d (motion-fit-deviations f)] [other (cadr found)])
        (check-close (cadr d) other 1e-4)))))
