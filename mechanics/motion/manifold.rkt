#lang racket/base
;; Motions on a manifold of states, such as constraints make.
;;
;; The manifold is known by two corrections, functions of a state: an increment of the
;; coordinates that leads nearer to it, which is repeated as Newton's method is, and one of
;; the velocities, which is exact.  A motion must begin on the manifold; its steps end there.

(require racket/flonum
         "../compile/compile-function.rkt"
         "../generic/kind.rkt" "../generic/value-struct.rkt"
         "../numeric/ode/projected.rkt"
         "../value/shape.rkt")

(provide make-manifold-derivative manifold-derivative? prepare-motion derivative-from
         (struct-out corrections) projector method-on check-on)

(define kind:manifold-derivative
  (make-kind #:rank rank:function
             #:describe (lambda (d) "a function")
             #:datum (lambda (d) ((manifold-derivative-make-datum d)))
             #:arity (lambda (d) 2)))

;; A state derivative.
;; prepare : who state -> a state derivative for motions from there on, and corrections
(value-struct manifold-derivative (at prepare make-datum)
  #:kind kind:manifold-derivative
  #:constructor-name make-manifold-derivative
  #:omit-define-syntaxes
  #:property prop:procedure 0)

;; positions, velocities : state -> increment of the state, or compiled; or #f
;; refuse : who state -> does not return; the state is not on the manifold
(struct corrections (positions velocities refuse) #:authentic)

;; -> a state derivative, and compiled corrections or #f
(define (prepare-motion who derivative state)
  (cond [(manifold-derivative? derivative)
         (define-values (ready c) ((manifold-derivative-prepare derivative) who state))
         (define (code f) (and f (compile-function f state #:name who)))
         (values ready
                 (and c (corrections (code (corrections-positions c))
                                     (code (corrections-velocities c))
                                     (corrections-refuse c))))]
        [else (values derivative #f)]))

;; m, with steps that end on the manifold, if there is one
(define (method-on m c n)
  (if c (projected-method m (projector c n)) m))

;; How far from the manifold, relative to 1 + |y|, a motion may begin.
(define most-off 1e-8)

(define (check-on who c y state)
  (when c
    (define moved (flvector-copy y))
    (unless (fl<= ((projector c (flvector-length y)) moved) most-off)
      ((corrections-refuse c) who state))))

;; The state derivative for motions from a state on that may be of higher precision, where
;; they can begin there; steps in such numbers are not projected.
(define (derivative-from who derivative state)
  (define y (structure->flvector state (lambda (x) +nan.0)))
  (cond [(and (manifold-derivative? derivative) (for/and ([x (in-flvector y)]) (fl= x x)))
         (define-values (ready c) (prepare-motion who derivative (flvector->structure state y)))
         (check-on who c y state)
         ready]
        [else derivative]))

;; -> (y -> the greatest change of a component of y, which is moved onto the manifold)
(define (projector c n)
  (define increment (make-flvector n))
  (define positions! (runner (corrections-positions c)))
  (define velocities! (runner (corrections-velocities c)))
  (define (correct! run y)
    (run y increment)
    (for/fold ([greatest 0.0]) ([d (in-flvector increment)] [k (in-naturals)])
      (define x (flvector-ref y k))
      (flvector-set! y k (fl+ x d))
      (flmax greatest (fl/ (flabs d) (fl+ 1.0 (flabs x))))))
  (lambda (y)
    (define moved (if positions! (repeat (lambda () (correct! positions! y))) 0.0))
    (if velocities! (flmax moved (correct! velocities! y)) moved)))

(define (runner code) (and code (compiled-function-runner code)))

;; Newton's method, until rounding ends it -> the first change, the greatest
(define (repeat correct!)
  (define first (correct!))
  (let loop ([last first] [count 1])
    (unless (or (fl<= last 1e-15) (= count most-corrections))
      (define now (correct!))
      (when (fl<= now (fl* 0.5 last)) (loop now (+ count 1)))))
  first)

(define most-corrections 20)
