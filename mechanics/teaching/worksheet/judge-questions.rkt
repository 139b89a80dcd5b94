#lang racket/base
;; Answers to which the system itself is the key: motions, conserved quantities, canonical maps.

(require (only-in racket/list append-map)
         "answer-parts.rkt" "exercise.rkt" "judgment.rkt" "prescribed-symbols.rkt"
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
             (judged-by v share-proved))]))

(define (coordinate-part local) (ref local 1))

;; Does the motion move if the key does, begin as the question says, and have all constants?
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
      (judged-by at-start (lambda (residual) (/ (+ 1 (share-proved residual)) 3))
                 "it is a solution, but does not begin as it should")))

;; The rank of the derivative of the state by the constants tells how many are independent.
(define (judge-constants v path constants names)
  (define q (path 't))
  (define state (append (scalars q) (scalars ((D path) 't))))
  (define-values (found needed)
    (values (rank-of-derivatives state constants) (* 2 (length names))))
  (if (= found needed)
      (right v)
      (partly 1/2 v
              (format "it is a solution, but not the general one: it has ~a of the ~a constants"
                      found needed))))

;; xs : expressions, whose derivatives by the symbols are the rows
(define (rank-of-derivatives xs symbols)
  (rank (apply matrix-by-rows
               (for/list ([x (in-list xs)])
                 (for/list ([s (in-list symbols)]) (simplify (rate x s)))))))

;; ---------------------------------------------------------------------------
;; Conserved quantities

(define (judge-conserved e key answer)
  (define names (exercise-coordinates e))
  (define at (if (setting e 'Hamiltonian) (state-of names) (local-tuple-of names)))
  (define v (verify-conserved (system-of e at) (value-function answer at) at
                              #:force (force-of e at)))
  (define parts (scalars answer))
  (cond [(for*/and ([x (in-list parts)] [s (in-list (scalars at))]) (zero-value? (rate x s)))
         (trivial v "it is the same whatever the state: a constant, not a quantity of the motion")]
        [(not (proved? v)) (judged-by v share-proved)]
        [(known-already? e parts (scalars at))
         (trivial v "it is conserved, but only what is known to be so already, in other words")]
        [else (right v)]))

;; Are the parts functions of the quantities of the clause `besides`?
(define (known-already? e parts state)
  (define known
    (append-map (lambda (d) (scalars (read-expression d))) (setting e 'besides '())))
  (and (pair? known)
       (= (rank-of-derivatives known state) (rank-of-derivatives (append known parts) state))))

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
                (judged-by v (lambda (_) 0) "it is not canonical")]
               [else (judge-transformed e v C state)])]))

;; Does the Hamiltonian become the one of the question, if it names one?
(define (judge-transformed e v C state)
  (define wanted (setting e 'becomes))
  (cond [(not wanted) (right v)]
        [else
         (define H (value-function (read-expression (setting e 'system)) state))
         (define w (verify-equal (H (C state)) (read-expression wanted)))
         (judged-by w (lambda (_) 1/2)
                    "it is canonical, but the Hamiltonian does not become what it should")]))
