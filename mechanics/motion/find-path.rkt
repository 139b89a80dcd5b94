#lang racket/base
;; The path of least action between two positions (SICM 1.4, pp. 20–22).
;;
;; Paths are polynomials through n points between the ends, evenly spaced in time, and
;; the action is a function of as many unknowns (path-action.rkt).  Its minimum is searched
;; for by a quasi-Newton method; Newton's method, with second derivatives from differences
;; of the gradient, takes it to rounding.  The action is then integrated more finely, until
;; that no longer moves the path.
;;
;; A motion makes the action stationary, and least if it does not last too long (over half
;; a period of an oscillator it is a saddle point).  The second derivatives tell.

(require racket/flonum
         "path-action.rkt"
         "system/check.rkt"
         "../error/complain.rkt" "../error/failure.rkt" "../error/refusal.rkt"
         "../generic/arithmetic.rkt" "../generic/define-plain.rkt" "../generic/up-down.rkt"
         "../generic/wrong-argument.rkt"
         "../lagrangian/Lagrange-equations.rkt" "../lagrangian/path.rkt"
         (only-in "../numeric/flvector.rkt" flvector->list flvector-finite? greatest norm)
         "../numeric/finite-number.rkt" "../error/progress.rkt"
         "../numeric/linear-algebra/definiteness.rkt" "../numeric/linear-algebra/row-matrix.rkt"
         "../numeric/optimization/newton.rkt" "../numeric/optimization/quasi-newton.rkt"
         "../value/shape.rkt")

(provide find-path)

(define who 'find-path)

;; observe : called with each path tried and its action
(define-plain (find-path L t0 q0 t1 q1 n #:tolerance [tolerance 1e-8] #:observe [observe void]
                         #:most-steps [most 1000] #:progress? [progress? (report-progress)])
  (check-arguments L t0 q0 t1 q1 n)
  (check-tolerance who tolerance)
  (check-argument who exact-positive-integer? most "a number of steps, a positive integer")
  (define (search t0 q0 t1 q1)
    (define p (make-problem L t0 q0 t1 q1 n))
    (call-with-progress progress?
                        (lambda (note!)
                          (least-path p tolerance most (counting-search note! who observe)))))
  (cond [(= n 0) (make-path t0 q0 t1 q1 '())]
        [(< t0 t1) (search t0 q0 t1 q1)]
        [else (search t1 q1 t0 q0)]))

(define (check-arguments L t0 q0 t1 q1 n)
  (check-Lagrangian who L)
  (check-real who "initial time" t0)
  (check-real who "final time" t1)
  (when (= t0 t1)
    (complain-showing who "the initial and the final time are the same" "time" t0))
  (check-argument who exact-nonnegative-integer? n "a number of intermediate points")
  (for ([q (list q0 q1)]
        [name '("coordinate at the initial time" "coordinate at the final time")])
    (for ([x (in-list (scalars q))]) (check-real who name x)))
  (unless (same-shape? q0 q1)
    (complain-showing
     who "the coordinates at the two ends are of different shapes"
     "at the initial time" q0
     "at the final time" q1)))

;; size   : how many unknowns
;; points : unknowns -> the scalars of the points between; path : unknowns -> path
;; action : how many parts -> unknowns -> action and gradient
(struct problem (size points path action) #:authentic)

(define (make-problem L t0 q0 t1 q1 n)
  (define velocity (g:/ (g:- q1 q0) (- t1 t0)))
  (define run (compile-Lagrangian who L (up t0 q0 velocity)))
  (define shape (apply up (linear-interpolants q0 q1 n)))
  (define-values (a b) (values (numbers q0) (numbers q1)))
  (define (points c) (points-between a b n c))
  (problem (* n (flvector-length a))
           points
           (lambda (c)
             (define qs (flvector->structure shape (points c)))
             (make-path t0 q0 t1 q1 (vector->list (structure-elements qs))))
           (lambda (parts)
             (path-action run (real->double-flonum t0) a (real->double-flonum t1) b
                          n (* 2 (+ n 4)) parts))))

(define (numbers s) (structure->flvector s (lambda (x) (check-real who "coordinate" x))))

;; ---------------------------------------------------------------------------

(define most-parts 256)

(define (least-path p tolerance most observe)
  (let refine ([c (make-flvector (problem-size p))] [parts 1])
    (define action ((problem-action p) parts))
    (define next (minimum p action c tolerance most observe))
    (define moved (if (= parts 1) +inf.0 (distance c next)))
    (cond [(<= moved (* 10.0 tolerance)) ((problem-path p) next)]
          [(= parts most-parts)
           (raise-no-path p "the action of the paths cannot be integrated well enough" next moved)]
          [else (refine next (* 2 parts))])))

;; The failure carries a path; its message shows the points it goes through.
(define (raise-no-path p what c error . fields)
  (apply raise-not-convergent who what ((problem-path p) c) error
         #:shown (flvector->list ((problem-points p) c)) fields))

;; Beside 1 + |x|
(define (distance v w)
  (for/fold ([m 0.0]) ([x (in-flvector v)] [y (in-flvector w)])
    (max m (/ (abs (- x y)) (+ 1.0 (abs y))))))

(define (minimum p action c tolerance most observe)
  (with-handlers ([stopped? (lambda (failure) (path-after-all p action c failure most))])
    (define-values (found value slope count)
      (quasi-newton action c #:tolerance tolerance #:limit most #:name who
                    #:observe (lambda (c value) (observe ((problem-path p) c) value))
                    #:argument stopped-at))
    (define best (or (lower-point action value (stationary-point action found)) found))
    (check-least p action best)
    best))

;; Where the search stopped: with it a failure of ours is told from one of the Lagrangian's.
(struct stopped-at (point) #:authentic)
(define (stopped? e)
  (and (exn:fail:mechanics:not-convergent? e)
       (stopped-at? (exn:fail:mechanics:not-convergent-value e))))

;; Newton's method may find a path that the descent did not; else the failure says why that stopped.
(define (path-after-all p action c failure most)
  (define last (stopped-at-point (exn:fail:mechanics:not-convergent-value failure)))
  (define-values (value slope) (action last))
  (define s (stationary-point action c))
  (define (raise-none what)
    (when s (check-least p action s))
    (raise-no-path p (string-append no-minimum what) c +inf.0))
  (cond
    [(and s (least? action s) (finite? (value-at action s))) s]
    [(not (and (finite? value) (flvector-finite? slope))) (raise-none ": it is not finite there")]
    [(or (> (greatest last) far) (straight-down? action last slope))
     (raise-none ": it falls without end")]
    [else
     (raise-no-path p (format "the search for the path was stopped after ~a steps" most)
                    last (exn:fail:mechanics:not-convergent-error-estimate failure)
                    "action" value "size of its gradient" (norm slope))]))

;; Does the action not bend along its gradient?
(define (straight-down? action c slope)
  (define bend
    (for/sum ([row (in-vector (second-derivatives action c))] [s (in-flvector slope)])
      (* s (for/sum ([h (in-vector row)] [s (in-flvector slope)]) (* h s)))))
  (< (abs bend) (* 1e-6 (norm slope) (norm slope))))

(define no-minimum "the action has no minimum among these paths")

;; No search that ends in a minimum comes by there.
(define far 1e30)

;; The stationary point, if there is one and the action there is not greater.
(define (lower-point action value stationary)
  (and stationary
       (<= (value-at action stationary) (+ value (* 1e-9 (+ 1.0 (abs value)))))
       stationary))

(define (value-at action c)
  (define-values (value slope) (action c))
  value)

(define (least? action c) (not (takes-negative-values? (second-derivatives action c))))

(define (check-least p action c)
  (unless (least? action c)
    (raise-no-path p (string-append "the stationary path does not make the action least:"
                                    " it falls in some direction from there, as it does"
                                    " where a motion lasts longer than half a period")
                   c 0.0 "action of the stationary path" (value-at action c))))

(define (stationary-point action x)
  (if-raised exn:fail:mechanics? #f
    (define-values (found step)
      (newton (lambda (x) (gradient-of action x)) (lambda (x) (second-derivatives action x)) x
              #:tolerance 1e-10 #:name who))
    found))

(define (gradient-of action x)
  (define-values (value slope) (action x))
  slope)

(define (second-derivatives action x)
  (symmetric-rows (difference-rows (lambda (x) (gradient-of action x)) x 1e-4)))
