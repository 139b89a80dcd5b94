#lang racket/base
;; A state derivative ready for integration: compiled, its first value checked.
;;
;; The parameters of a system that are numbers, or tuples of numbers, become inputs of
;; the compiled code beside the state, so that other numbers use the same code.  If the system
;; decides something by a parameter, it is compiled for that one.

(require racket/flonum
         racket/unsafe/ops
         "check.rkt" "kept-systems.rkt" "Lagrangian-code.rkt" "manifold.rkt"
         "../calculus/derivative.rkt"
         "../compile/compile-function.rkt" "../compile/jet-program.rkt"
         "../error/once.rkt"
         "../generic/up-down.rkt"
         "../numeric/flvector.rkt"
         "../numeric/ode/differentiated.rkt" "../numeric/ode/expandable.rkt"
         "../numeric/ode/stepper.rkt"
         "../value/shape.rkt" (only-in "../value/structure.rkt" ref structure->list))

(provide (struct-out system) make-system make-parametric-system
         system-right-hand-side system-method system-state system-size system-expand check-start
         for-one-integration call-for-passage
         derivative-for constant-rate? raise-rate-varies)

;; shape : a state; clock? : is its first scalar the time, with derivative 1?
;; derivative     : state -> state
;; make-slope!    : -> (y dy -> void), for one integration
;; make-jacobian! : -> (y J -> void), for one integration, or #f if the derivative
;;                  cannot be differentiated; compiled when first asked for
;; operations     : how many flonum operations its rates take, or #f
;; expander       : -> expander (numeric/jet/expansion.rkt), or a string that says why there
;;                  is none; found out when first asked for
;; corrections    : those of the manifold that motions are on (manifold.rkt), or #f
;; spares         : a box of right-hand sides that no integration uses any more
;; separable      : a box: was that found out (separable.rkt)?
;; own            : its right-hand side in one integration, or #f
(struct system (shape clock? derivative make-slope! make-jacobian! operations expander corrections
                spares separable own)
  #:authentic)

;; What a method integrates.
(define (system-right-hand-side s m)
  (cond [(eq? 'jacobian (method-asks m))
         (define slope! ((system-make-slope! s)))
         (define jacobian! ((system-make-jacobian! s)))
         (if jacobian! (differentiated slope! jacobian!) slope!)]
        [else (or (system-own s) (new-right-hand-side s))]))

(define (new-right-hand-side s) (expandable ((system-make-slope! s)) (system-expand s)))

;; What makes Taylor coefficients of motions, or a string that says why there are none.
(define (system-expand s) ((system-expander s)))

;; What integrates it by a method.
(define (system-method s m) (method-on m (system-corrections s) (system-size s)))

;; s for one integration: a method that is tried goes on with what it worked out.
(define (for-one-integration s) (with-own s (new-right-hand-side s)))

;; (use s'), s' being s for one integration of which no interpolant is kept: what it works with,
;; which takes longer to make than a few steps, is left to the next.
(define (call-for-passage s use)
  (define spares (system-spares s))
  (define f! (or (take-spare! spares) (new-right-hand-side s)))
  (begin0 (use (with-own s f!))
          (rest! f!)
          (give-back! spares f!)))

(define (take-spare! spares)
  (define all (unbox spares))
  (cond [(null? all) #f]
        [(box-cas! spares all (cdr all)) (car all)]
        [else (take-spare! spares)]))

;; Those of one integration are kept, a few.
(define (give-back! spares f!)
  (define all (unbox spares))
  (when (< (length all) 8) (box-cas! spares all (cons f! all))))

(define (with-own s f!)
  (struct-copy system s [own f!]))

;; Does a motion begin where it can?
(define (check-start who s y) (check-on who (system-corrections s) y (system-state s y)))

(define (system-state s y) (flvector->structure (system-shape s) y))

(define (system-size s) (shape-length (system-shape s)))

;; given : state -> state
(define (make-system who given state)
  (define (make) (new-system who given state))
  (if (manifold-derivative? given)
      (make)
      (keeping-system given state #:make make #:keep? system-operations
                      #:good? (lambda (s) (starts? s (state-vector who state))))))

;; Are the rates numbers at y?  If not, it is to be said why.
(define (starts? s y)
  (define slope (make-flvector (flvector-length y)))
  (((system-make-slope! s)) y slope)
  (flvector-finite? slope))

(define (new-system who given state)
  (define-values (derivative corrections) (prepare-motion who given state))
  (define code
    (or (Lagrangian-code who derivative state)
        (let ([slope (check-derivative who derivative state)])
          (compile-function derivative state #:name who #:value slope))))
  (define clock? (clock-first? code))
  (define (slope!)
    (define run (compiled-function-runner code))
    (if (and clock? (compiled-function-reason code)) (on-time who run) run))
  (define jacobian
    (once (lambda () (compile-jacobian who (lambda (s) (derivative-at derivative s)) state))))
  (system state clock? derivative
          slope!
          (lambda () (let ([c (jacobian)]) (and c (compiled-function-runner c))))
          (compiled-function-operations code)
          (once (lambda () (expander-of code (shape-length state) (flvector))))
          corrections (box '()) (box #f) #f))

;; n : how many scalars a state has; ps : the values of the parameters
(define (expander-of code n ps)
  (define p (compiled-function-program code))
  (define make
    (if p
        (program->expansion-maker p n #:constants (flvector->list ps))
        (compiled-function-reason code)))
  (define inputs (make-flvector (compiled-function-inputs code)))
  (for ([p (in-flvector ps)] [k (in-naturals n)]) (flvector-set! inputs k p))
  (if (string? make) make (maker->expander make inputs)))

;; derivative-maker : parameters -> derivative
(define (make-parametric-system who derivative-maker parameters state)
  (define derivative (derivative-for derivative-maker parameters))
  (or (and (ormap numeric? parameters)
           (not (manifold-derivative? derivative))
           (system-of-parameters who derivative derivative-maker parameters state))
      (make-system who derivative state)))

;; #f if the system takes a decision.
(define (system-of-parameters who derivative derivative-maker parameters state)
  (define slope (check-derivative who derivative state))
  (define inputs (apply up (filter numeric? parameters)))
  (define ps (structure->flvector inputs values))
  (define example (up state inputs))
  (define n (shape-length state))
  (define (f s)
    (define all (with-numbers parameters (structure->list (ref s 1))))
    ((derivative-for derivative-maker all) (ref s 0)))
  (define (slopes s)
    (derivative-at (lambda (state) (f (up state (ref s 1)))) (ref s 0)))
  ;; The parameters are as they were given: an exact 2 may count or choose.
  (define (at-state g) (lambda (v) (g (flvector->structure state v))))
  (define code
    (compile-traced f example #:name who
                    #:value-at (at-state derivative) #:varying n #:value slope))
  (define jacobian
    (once (lambda ()
            (compile-jacobian who slopes example
                              #:value-at (at-state (lambda (s) (derivative-at derivative s)))
                              #:varying n))))
  (define (with-parameters c) (and c (fix-parameters c n ps)))
  (and code
       (system state (clock-first? code) derivative
               (lambda () (with-parameters code))
               (lambda () (with-parameters (jacobian)))
               (compiled-function-operations code)
               (once (lambda () (expander-of code n ps)))
               #f (box '()) (box #f) #f)))

;; Masses may be given as a tuple.
(define (numeric? parameter) (andmap real? (scalars parameter)))

;; The parameters with these in place of the numeric ones.
(define (with-numbers parameters numbers)
  (cond [(null? parameters) '()]
        [(numeric? (car parameters))
         (cons (car numbers) (with-numbers (cdr parameters) (cdr numbers)))]
        [else (cons (car parameters) (with-numbers (cdr parameters) numbers))]))

(define (derivative-for derivative-maker ps)
  (if (takes-state-only? derivative-maker ps) derivative-maker (apply derivative-maker ps)))

;; n : how many scalars a state has
(define (fix-parameters code n ps)
  (define input (make-flvector (compiled-function-inputs code)))
  (for ([p (in-flvector ps)] [k (in-naturals n)]) (flvector-set! input k p))
  (define run (compiled-function-runner code))
  (lambda (y dy)
    (let loop ([i 0])
      (when (unsafe-fx< i n)
        (unsafe-flvector-set! input i (unsafe-flvector-ref y i))
        (loop (unsafe-fx+ i 1))))
    (run input dy)))

;; The derivatives of a state derivative, compiled, or #f if they cannot be traced.
;; slopes : example -> the derivatives there
(define (compile-jacobian who slopes example
                          #:value-at [value-at #f] #:varying [varying (shape-length example)])
  (define (at v) (slopes (flvector->structure example v)))
  (compile-traced slopes example
                  #:name who #:value-at (or value-at at) #:varying varying))

;; ---------------------------------------------------------------------------
;; The clock

;; Is the rate of the first scalar the constant 1?  A trace tells.  Without one it
;; is taken for constant if it is exact, for states are flonums.
(define (clock-first? code)
  (constant-rate? (compiled-function-value-shape code) (not (compiled-function-reason code))))

(define (constant-rate? slope traced?)
  (define rate (car (scalars slope)))
  (if traced?
      (and (number? rate) (= rate 1))
      (eqv? rate 1)))

;; It may be exact and not constant, 1 or 2 by a decision.
(define ((on-time who run) y dy)
  (run y dy)
  (define rate (flvector-ref dy 0))
  (unless (or (fl= rate 1.0) (not (fl= rate rate))) (raise-rate-varies who rate)))

(define (raise-rate-varies who rate)
  (raise-arguments-error
   who "the first component of the state was taken for the time, but its derivative varies"
   "at the start" 1
   "now" rate
   "if it is not the time" (unquoted-printing-string "let its derivative be 1.0 at the start")))
