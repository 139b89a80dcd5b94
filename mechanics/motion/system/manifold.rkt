#lang racket/base
;; Motions on a manifold of states, as constraints define.
;;
;; The manifold is known by two corrections, functions of a state: an increment of the
;; coordinates that leads nearer to it, which is repeated as Newton's method is, and one of
;; the velocities, which is exact.  A motion must begin on the manifold; its steps end there.

(require racket/flonum
         "../../compile/compile-function.rkt"
         "../../generic/kind.rkt" "../../generic/value-struct.rkt"
         "../../numeric/ode/projection-method.rkt"
         "../../value/shape.rkt")

(provide make-manifold-derivative manifold-derivative?
         (struct-out preparation) prepare-motion complete-motion derivative-from
         (struct-out corrections) projector method-on check-on)

(define kind:manifold-derivative
  (make-kind #:rank rank:function
             #:describe (lambda (d) "a function")
             #:datum (lambda (d) ((manifold-derivative-make-datum d)))
             #:arity (lambda (d) 2)))

;; A state derivative.
;; prepare : who state -> preparation
(value-struct manifold-derivative (at prepare make-datum)
  #:kind kind:manifold-derivative
  #:constructor-name make-manifold-derivative
  #:omit-define-syntaxes
  #:property prop:procedure 0)

;; positions, velocities : state -> increment of the state, or compiled; or #f
;; refuse : who state -> does not return; the state is not on the manifold
(struct corrections (positions velocities refuse) #:authentic)

;; The preparation of motions from a state on.
;; derivative : their state derivative
;; mark       : the other data on which they depend, compared by equal?; or #f
;; watched    : function of the state whose values determine the compiled code
;; complete   : -> corrections or #f, and the compiled rates or #f if they are to be made of the
;;              derivative
(struct preparation (derivative mark watched complete) #:authentic)

(define (prepare-motion who derivative state)
  (if (manifold-derivative? derivative)
      ((manifold-derivative-prepare derivative) who state)
      (preparation derivative #f derivative (lambda () (values #f #f)))))

;; who p state -> corrections, compiled, or #f; and the compiled rates, or #f
(define (complete-motion who p state)
  (define (code f) (and f (if (compiled-function? f) f (compile-function f state #:name who))))
  (define-values (c rates) ((preparation-complete p)))
  (values (and c (corrections (code (corrections-positions c))
                              (code (corrections-velocities c))
                              (corrections-refuse c)))
          rates))

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
         (define start (flvector->structure state y))
         (define p (prepare-motion who derivative start))
         (define-values (c rates) (complete-motion who p start))
         (check-on who c y state)
         (preparation-derivative p)]
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
  (define start (correct!))
  (let loop ([change start] [count 1])
    (unless (or (fl<= change 1e-15) (= count most-corrections))
      (define next (correct!))
      (when (fl<= next (fl* 0.5 change)) (loop next (+ count 1)))))
  start)

(define most-corrections 20)
