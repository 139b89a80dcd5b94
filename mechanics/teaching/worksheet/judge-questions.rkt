#lang racket/base
;; Answers to which the system itself is the key: motions, what is conserved, canonical maps.

(require "answer-parts.rkt" "exercise.rkt" "judgment.rkt" "prescribed-symbols.rkt"
         "../../calculus/derivative.rkt"
         "../../hamiltonian/on-demand.rkt"
         "../../question/on-demand.rkt"
         "../derivation/canonical-map.rkt"
         "../../value/matrix/linear-algebra.rkt" "../../value/matrix/matrix.rkt"
         "../../value/read-expression.rkt" "../../value/shape.rkt" "../../value/simplify.rkt"
         "../../value/structure.rkt"
         "../../verdict/prove-zero.rkt" "../../verdict/verdict.rkt")

(provide judge-solution judge-conserved judge-canonical)

;; The system of an exercise, as a function.
(define (system-of e at)
  (define f (value-function (read-expression (setting e 'system)) at))
  (if (setting e 'Hamiltonian) (make-Hamiltonian f) f))

(define (force-of e at)
  (define d (setting e 'force))
  (and d (value-function (read-expression d) at)))

;; ---------------------------------------------------------------------------
;; Motions

(define (judge-solution e key answer)
  (define local (local-tuple-of (exercise-coordinates e)))
  (define path (value-function answer 't))
  (cond [(not (alike? (coordinate-part local) answer))
         (wrong #f "the path does not have one component for each coordinate")]
        [else
         (define v (verify-solution (system-of e local) path #:force (force-of e local)))
         (if (proved? v)
             (judge-motion e v key path)
             (judged-by (verdict-status v) v (lambda () (share-proved (verdict-residual v)))))]))

(define (coordinate-part local) (ref local 1))

;; A motion: does it rest where the key moves, begin as it should, and has it all constants?
(define (judge-motion e v key path)
  (define (moves? q) (not (zero-value? ((D q) 't))))
  (define start (setting e 'starts))
  (define constants (setting e 'constants '()))
  (cond [(and (not (moves? path)) (moves? (value-function key 't)))
         (trivial v "it is a solution, but nothing moves")]
        [start (judge-start v path (read-expression start))]
        [(pair? constants) (judge-constants v path constants (exercise-coordinates e))]
        [else (right v)]))

;; start : (up t0 q0 v0)
(define (judge-start v path start)
  (define t0 (ref start 0))
  (define at-start (verify-equal (up (path t0) ((D path) t0)) (up (ref start 1) (ref start 2))))
  (if (proved? at-start)
      (right v)
      (judged-by (verdict-status at-start) at-start
                 (lambda () (/ (+ 1 (share-proved (verdict-residual at-start))) 3))
         "it is a solution, but does not begin as it should")))

;; By how many ways its constants change the state.
(define (judge-constants v path constants names)
  (define q (path 't))
  (define state (append (scalars q) (scalars ((D path) 't))))
  (define J
    (apply matrix-by-rows
           (for/list ([x (in-list state)])
             (for/list ([c (in-list constants)])
               (simplify (derivative-at (value-function x c) c))))))
  (define-values (found needed) (values (rank J) (* 2 (length names))))
  (if (= found needed)
      (right v)
      (partly 1/2 v
              (format "it is a solution, but not the general one: it has ~a of the ~a constants"
                      found needed))))

;; ---------------------------------------------------------------------------
;; Conserved quantities

(define (judge-conserved e key answer)
  (define names (exercise-coordinates e))
  (define at (if (setting e 'Hamiltonian) (state-of names) (local-tuple-of names)))
  (define Q (value-function answer at))
  (define v (verify-conserved (system-of e at) Q at #:force (force-of e at)))
  (define gradients (map (lambda (x) (gradient-at x at)) (scalars answer)))
  (cond [(andmap zero-value? gradients)
         (trivial v "it is the same whatever the state: a constant, not a quantity of the motion")]
        [(not (proved? v))
         (judged-by (verdict-status v) v (lambda () (share-proved (verdict-residual v))))]
        [(known-already? e gradients at)
         (trivial v "it is conserved, but only what is known to be so already, in other words")]
        [else (right v)]))

;; The derivatives by the scalars of the state.
(define (gradient-at x at)
  (list->up (for/list ([s (in-list (scalars at))]) (derivative-at (value-function x s) s))))

;; Is it a function of the quantities of the clause `besides`?
(define (known-already? e gradients at)
  (define known
    (for*/list ([d (in-list (setting e 'besides '()))]
                [x (in-list (scalars (read-expression d)))])
      (gradient-at x at)))
  (define (rank-of rows) (rank (apply matrix-by-rows (map row rows))))
  (and (pair? known) (= (rank-of known) (rank-of (append known gradients)))))

(define (row gradient) (map simplify (scalars gradient)))

;; ---------------------------------------------------------------------------
;; Canonical maps

(define (judge-canonical e key answer)
  (define state (state-of (exercise-coordinates e)))
  (define C (value-function answer state))
  (cond [(not (alike? state answer))
         (wrong #f "its value is to be a state: (up t q p), momenta as they are here")]
        [else
         (define v (verify-canonical-map C state))
         (cond [(and (same? answer state) (not (same? key state)))
                (trivial v "it leaves every state where it is")]
               [(not (proved? v))
                (judged-by (verdict-status v) v (lambda () 0) "it is not canonical")]
               [else (judge-transformed e v C state)])]))

;; What is to become of the Hamiltonian, if the question says so.
(define (judge-transformed e v C state)
  (define wanted (setting e 'becomes))
  (cond [(not wanted) (right v)]
        [else
         (define H (value-function (read-expression (setting e 'system)) state))
         (define w (verify-equal (H (C state)) (read-expression wanted)))
         (judged-by (verdict-status w) w (lambda () 1/2)
         "it is canonical, but the Hamiltonian does not become what it should")]))
