#lang racket/base
;; The path of stationary action between two positions (SICM 1.4, pp. 20–22).
;;
;; Paths are polynomials through n points between the ends, evenly spaced in time,
;; and the action is a function of these points.  It is approximated by Gauss and
;; Legendre's rule with a number of nodes; Lagrangian and derivatives by the points
;; are compiled, as a function of time and the points.  So the gradient is exactly
;; that of the sum which is minimised.  More nodes are taken until they no longer
;; move the points.

(require racket/flonum
         "check.rkt"
         "../calculus/derivative.rkt"
         "../compile/compile-function.rkt"
         "../generic/structure.rkt" "../generic/arithmetic.rkt"
         "../lagrangian/Lagrange-equations.rkt" "../lagrangian/local-tuple.rkt" "../lagrangian/path.rkt"
         "../numeric/gauss-legendre.rkt" "../numeric/progress.rkt" "../numeric/quasi-newton.rkt"
         "../value/shape.rkt")

(provide find-path)

;; observe : called with each path tried and its action
(define (find-path L t0 q0 t1 q1 n #:tolerance [tolerance 1e-8] #:observe [observe void]
                   #:progress [progress? (report-progress)])
  (check-Lagrangian 'find-path L)
  (check-real 'find-path "initial time" t0)
  (check-real 'find-path "final time" t1)
  (when (= t0 t1)
    (raise-arguments-error 'find-path "the initial and the final time are the same" "time" t0))
  (unless (exact-nonnegative-integer? n)
    (raise-argument-error 'find-path "a number of intermediate points" n))
  (define start (apply up (linear-interpolants q0 q1 n)))
  (define (path-through qs) (make-path t0 q0 t1 q1 (vector->list (structure-elements qs))))
  (define x (structure->flvector start (lambda (x) (check-real 'find-path "coordinate" x))))
  (define (path x) (path-through (flvector->structure start x)))
  (define integrand (compile-integrand L path-through start t0))
  (define (search note!)
    (define watch (counting-search note! 'find-path (lambda (x action) (observe (path x) action))))
    (define (minimum x nodes)
      (define-values (found action slope count)
        (quasi-newton (action-and-gradient integrand nodes t0 t1) x
                      #:tolerance tolerance #:name 'find-path #:observe watch))
      found)
    (let refine ([before (minimum x (* 2 (+ n 4)))] [nodes (* 4 (+ n 4))])
      (define after (minimum before nodes))
      (if (or (close? before after tolerance) (> nodes 1000))
          (path after)
          (refine after (* 2 nodes)))))
  (if (zero? n)
      (path x)
      (call-with-progress progress? search)))

(define (close? v w tolerance)
  (for/and ([x (in-flvector v)] [y (in-flvector w)])
    (<= (abs (- x y)) (* 10 tolerance (+ 1.0 (abs x))))))

;; From (t, points) to L of the local tuple at t and its derivatives by the points:
;; (input output -> void)
(define (compile-integrand L path-through points t0)
  (define value (scalar-valued 'find-path L))
  (define (L-at t points) (value ((Gamma (path-through points)) t)))
  (define (both s)
    (define t (vector-ref (structure-elements s) 0))
    (define points (vector-ref (structure-elements s) 1))
    (up (L-at t points)
        (derivative-at (lambda (points) (L-at t points)) points)))
  (compiled-function-runner (compile-function both (up t0 points) #:name 'find-path)))

;; points -> the action and its gradient, with that many nodes
(define ((action-and-gradient integrand count t0 t1) x)
  (define n (flvector-length x))
  (define input (make-flvector (+ n 1)))
  (define output (make-flvector (+ n 1)))
  (define sums (make-flvector (+ n 1)))
  (define half (* 0.5 (- t1 t0)))
  (define middle (* 0.5 (+ t1 t0)))
  (define-values (nodes weights) (gauss-legendre-rule count))
  (for ([i (in-range n)]) (flvector-set! input (+ i 1) (flvector-ref x i)))
  (for ([u (in-flvector nodes)] [w (in-flvector weights)])
    (flvector-set! input 0 (real->double-flonum (+ middle (* half u))))
    (integrand input output)
    (for ([k (in-range (+ n 1))])
      (flvector-set! sums k (+ (flvector-ref sums k) (* half w (flvector-ref output k))))))
  (values (flvector-ref sums 0)
          (for/flvector #:length n ([k (in-range n)]) (flvector-ref sums (+ k 1)))))
