#lang racket/base
;; The systems of motion-systems.rkt as a user writes them for heyoka: by hand, or by its models.
;;
;; Each text defines `equations`, the pairs of a variable and its rate, and `start`.

(provide heyoka-by-hand)

;; name of a motion -> text, or #f
(define (heyoka-by-hand name)
  (for/first ([entry (in-list systems)] #:when (regexp-match? (car entry) name)) (cdr entry)))

(define driven-pendulum #<<PYTHON
x, v = hy.make_vars("x", "v")
g, a, f = 9.8, 0.1, 2*9.8**0.5
equations = [(x, v), (v, (a*f*f*cos(f*hy.time) - g)*sin(x))]
start = [1.0, 0.0]

PYTHON
  )

(define Henon-Heiles #<<PYTHON
x, y, px, py = hy.make_vars("x", "y", "px", "py")
equations = [(x, px), (y, py), (px, -x - 2*x*y), (py, -y - x*x + y*y)]
start = [0.0, 0.1, (2*(1/12 - 0.1**2/2 + 0.1**3/3))**0.5, 0.0]

PYTHON
  )

;; Angular velocities along the principal axes and Euler's equations for their rates
(define rigid-body #<<PYTHON
th, ph, ps, vt, vf, vs = hy.make_vars("th", "ph", "ps", "vt", "vf", "vs")
A, B, C = 1.0, 2**0.5, 2.0
st, ct, ss, cs = sin(th), cos(th), sin(ps), cos(ps)
wa, wb, wc = vt*cs + vf*st*ss, vf*st*cs - vt*ss, vf*ct + vs
ra, rb, rc = (B - C)/A*wb*wc, (C - A)/B*wc*wa, (A - B)/C*wa*wb
p = ra + vt*vs*ss - vf*vt*ct*ss - vf*vs*st*cs
q = rb + vt*vs*cs - vf*vt*ct*cs + vf*vs*st*ss
precession = (p*ss + q*cs)/st
equations = [(th, vt), (ph, vf), (ps, vs), (vt, p*cs - q*ss), (vf, precession),
             (vs, rc + vf*vt*st - precession*ct)]
start = [1.0, 0.0, 0.0, 0.1, 0.1, 0.1]

PYTHON
  )

(define three-bodies #<<PYTHON
equations = hy.model.nbody(3, masses=[1.0, 1e-3, 3e-4])
start = [0.0, 0.0, 0.0, 0.0, -4e-4, 0.0, 5.2, 0.0, 0.1, 0.02, 0.43, 0.0,
         0.0, 9.5, -0.3, -0.32, 0.01, 0.01]

PYTHON
  )

(define systems
  (list (cons #rx"pendulum|the same without outputs" driven-pendulum)
        (cons #rx"Hénon–Heiles" Henon-Heiles)
        (cons #rx"rigid body" rigid-body)
        (cons #rx"three bodies" three-bodies)))
