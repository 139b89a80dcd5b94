#lang racket/base
;; Radau IIA, the implicit Runge–Kutta method of order 5 for stiff systems (Hairer and
;; Wanner, Solving Ordinary Differential Equations II, 2nd ed. 1996, IV.8).
;;
;; A cubic through y that satisfies y' = f(y) at the fractions c₁, c₂ and c₃ = 1 of the
;; step leads to the new state.  Its distances zᵢ from y there are found by Newton's method
;; (radau-equations.rkt).  An embedded formula of order 3 gives the error
;;
;;     e = (γ/h − J)⁻¹ (f(y) + (d₁ z₁ + d₂ z₂ + d₃ z₃)/h),
;;
;; and once more with f(y + e) for f(y), or it would be far too large where hJ is.
;; Motions that die out within a small part of a step are damped entirely, as if h were
;; infinite for them.
;;
;; J stays for the next step where Newton's method converged fast; and if the step is to
;; be hardly longer it keeps its length, so that the matrices stay as well.

(require racket/flonum
         "step-prediction.rkt" "radau-equations.rkt" "stepper.rkt" "vector-formulas.rkt"
         "../record-fields.rkt" "../flvector.rkt")

(provide radau-iia-5)

(define d1 (fl/ (fl- -13.0 (fl* 7.0 root6)) 3.0))
(define d2 (fl/ (fl+ -13.0 (fl* 7.0 root6)) 3.0))
(define d3 (fl/ -1.0 3.0))

(define hardly-longer 1.2)

;; ---------------------------------------------------------------------------

;; f!      : the right-hand side; n : of how many variables; y : the present state, and the
;;           slope there; next : the state that the step leads to
;; k, e    : room for a slope and the error
;; control : proposes lengths of steps (step-prediction.rkt)
;; tried   : the length of the step tried last; step : of the one accepted last, with its
;;           interpolant, cubic, #f before the first
(struct radau (f! n y slope next k e control equations
               [tried #:mutable] [step #:mutable] [cubic #:mutable])
  #:authentic)

;; tolerance : of the error of a step
(define (start f! y0 [tolerance 1e-12])
  (define n (flvector-length y0))
  (define y (flvector-copy y0))
  (define-vectors n slope next k e)
  (define r (radau f! n y slope next k e (make-controller most-iterations)
                   (make-equations f! y tolerance) 0.0 0.0 #f))
  (define guess! (continuing r))
  (f! y slope)
  (make-stepper y
                (lambda () slope)
                (lambda (h) (try! r h guess!))
                (lambda () (accept! r))
                (lambda () (radau-cubic r))
                #:propose (lambda (h error) (propose r h error))))

(define (try! r h guess!)
  (define-fields radau r n y slope next k e equations)
  (set-radau-tried! r h)
  (define-elements (equations-zs equations) z1 z2 z3)
  (cond [(solve-equations! equations h guess!)
         (error-from! r slope h)
         (slope-at! equations k e)
         (weighted-sum! n next [1.0 y] [1.0 z3])
         (error-from! r k h)]
        [(failed-slope? equations) +nan.0]
        [else unsolved]))

;; Where the equations begin to be solved: the last cubic, continued.
(define ((continuing r) c z)
  (define-fields radau r n y tried step cubic)
  (cond [cubic
         (cubic (fl+ 1.0 (fl* c (fl/ tried step))) z)
         (weighted-sum! n z [1.0 z] [-1.0 y])]
        [else (scale! z 0.0)]))

;; The error, left in e, with the slope at y or another in its place.
(define (error-from! r slope h)
  (define-fields radau r n y e equations)
  (define-elements (equations-zs equations) z1 z2 z3)
  (define 1/h (fl/ 1.0 h))
  (weighted-sum! n e [1.0 slope] [(fl* 1/h d1) z1] [(fl* 1/h d2) z2] [(fl* 1/h d3) z3])
  (solve-real-equation! equations e)
  (root-mean-square e y y n))

(define (accept! r)
  (define-fields radau r f! n y slope next tried equations)
  (set-radau-step! r tried)
  (set-radau-cubic! r (make-cubic n y (equations-zs equations)))
  (flvector-copy! y next)
  (state-moved! equations)
  (f! y slope))

;; A step that was not solved for tells nothing of its error.
(define (propose r h error)
  (define-fields radau r control equations)
  (unless (fl<= error 1.0) (renew-derivatives! equations))
  (define length
    (if (fl< error too-large) (control h error (equations-iterations equations)) (fl* 0.5 h)))
  (if (and (converged-fast? equations)
           (fl<= h length)
           (fl<= length (fl* hardly-longer h)))
      h
      length))

;; The error of a step that was not solved for.
(define unsolved 1e100)
(define too-large 1e50)

;; y + θ (a + (θ − c₁) (b + (θ − c₂) c)), by divided differences at 0, c₁, c₂ and 1
(define (make-cubic n y zs)
  (define-elements zs z1 z2 z3)
  (define from (flvector-copy y))
  (define-vectors n a b c)
  (define p (fl/ 1.0 (fl- c2 c1)))
  (define q (fl/ 1.0 (fl- 1.0 c2)))
  (weighted-sum! n a [(fl/ 1.0 c1) z1])
  (weighted-sum! n b [(fl/ p c2) z2] [(fl/ (fl- 0.0 p) c2) z1] [(fl/ -1.0 c2) a])
  (define r (fl/ 1.0 (fl- 1.0 c1)))
  (weighted-sum! n c [(fl* r q) z3] [(fl* r (fl- 0.0 (fl+ q p))) z2] [(fl* r p) z1] [-1.0 b])
  (lambda (theta out)
    (define s (fl* theta (fl- theta c1)))
    (combine! n out from 1.0 [theta a] [s b] [(fl* s (fl- theta c2)) c])))

(define radau-iia-5 (adaptive-method 'Radau-IIA-5 4 start #:asks 'jacobian))
