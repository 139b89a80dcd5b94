#lang racket/base
;; How a motion depends on where it starts and on its parameters.
;;
;; With s' = f(s, p), a change v of the state follows the equation of variations,
;; v' = ∂f/∂s v + ∂f/∂p δp.  That is a motion too: of the pair (s, v), and is integrated like
;; any other, with the same care for its error.  So derivatives of a motion are exact, not
;; differences of motions.  What is differentiated may itself be a derivative: the motion of
;; pairs is followed by the same advancer, which finds the ε of the other derivative in it.

(require "integration-failure.rkt" "system/parametric-system.rkt"
         "../calculus/derivative.rkt" "../calculus/dual.rkt" "../calculus/perturbed-value.rkt"
         "../calculus/recorded-number.rkt"
         "../error/failure.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/scalar.rkt" "../generic/up-down.rkt"
         "../value/shape.rkt"
         (only-in "../value/structure.rkt" ref structure->list))

(provide advance-perturbed flow-derivative
         ;; for exponents and multipliers
         with-displacements unit-displacements call-for-state)

;; advance : maker parameters state duration -> state, as of a state-advancer

;; The state reached where the state, a parameter or the duration is being differentiated.
(define (advance-perturbed who advance maker ps state duration)
  (define x (outermost-of (append (scalars state) (append-map* scalars ps) (list duration))))
  (define tag (perturbed-tag x))
  (cond [(dual? x) (advance-dual tag advance maker ps state duration)]
        [(recorded? x) (advance-recorded tag advance maker ps state duration)]
        [else (raise-no-series who)]))

(define (append-map* f xs) (apply append (map f xs)))

(define (outermost-of xs)
  (for/fold ([found #f]) ([x (in-list xs)] #:when (perturbed? x))
    (if found (outermost found x) x)))

;; Of derivatives of higher order, to be taken one after the other then (calculus/derivative).
(define (raise-no-series who)
  (raise-singular who "a motion has no Taylor series by its start; D of D is taken" #f))

;; ---------------------------------------------------------------------------
;; One direction

(define (advance-dual tag advance maker ps state duration)
  (define (value x) (map-scalars (lambda (x) (primal-part x tag)) x))
  (define (change x) (map-scalars (lambda (x) (tangent-part x tag)) x))
  (define pair
    (advance (variation-maker maker (length ps))
             (append (map value ps) (map change ps))
             (up (value state) (change state))
             (primal-part duration tag)))
  (define end (ref pair 0))
  (define slope ((derivative-for maker (map value ps)) end))
  (define all (g:+ (ref pair 1) (g:* (tangent-part duration tag) slope)))
  (combined (lambda (x dx) (make-dual tag x dx)) end all))

;; Parameters may be functions, which are left alone.
(define (map-scalars f x)
  (cond [(tuple? x) (scalars->structure x (let ([xs (list->vector (scalars x))])
                                            (lambda (k) (f (vector-ref xs k)))))]
        [(scalar? x) (f x)]
        [else x]))

(define (combined f x y)
  (define-values (xs ys) (values (list->vector (scalars x)) (list->vector (scalars y))))
  (scalars->structure x (lambda (k) (f (vector-ref xs k) (vector-ref ys k)))))

;; Of parameters and their changes: the derivative of pairs of a state and its change.
(define ((variation-maker maker n) . all)
  (define-values (ps changes) (split all n))
  (lambda (pair)
    (define-values (slope change)
      (varied maker ps changes (ref pair 0) (ref pair 1)))
    (up slope change)))

(define (split xs n)
  (if (eqv? n 0)
      (values '() xs)
      (let-values ([(first rest) (split (cdr xs) (- n 1))]) (values (cons (car xs) first) rest))))

;; The rate of a state, and the rate of its change where the parameters change as well.
(define (varied maker ps changes state v)
  (define (varies? p) (or (tuple? p) (scalar? p)))
  (define (f all)
    (define-values (state numbers) (let ([xs (structure->list all)]) (values (car xs) (cdr xs))))
    ((derivative-for maker (refilled ps varies? numbers)) state))
  (value-and-derivative-along
   f
   (apply up state (filter varies? ps))
   (apply up v (for/list ([p (in-list ps)] [dp (in-list changes)] #:when (varies? p)) dp))))

(define (refilled ps varies? numbers)
  (cond [(null? ps) '()]
        [(varies? (car ps)) (cons (car numbers) (refilled (cdr ps) varies? (cdr numbers)))]
        [else (cons (car ps) (refilled (cdr ps) varies? numbers))]))

;; ---------------------------------------------------------------------------
;; All directions at once

;; end : the state reached; by-state, by-parameters : its derivatives by each scalar of these
(struct flow (end by-state by-parameters) #:authentic)

;; parameters? : are derivatives by these wanted as well?
(define (flow-from advance maker ps state duration parameters?)
  (define n (shape-length state))
  (define no-changes (map (lambda (p) (map-scalars (lambda (x) 0) p)) ps))
  (define changes (if parameters? (unit-changes ps no-changes) '()))
  (define still (map-scalars (lambda (x) 0) state))
  (define starts
    (append (for/list ([k (in-range n)]) (unit-structure state k))
            (for/list ([_ (in-list changes)]) still)))
  (define all-changes (append (for/list ([_ (in-range n)]) no-changes) changes))
  (define ((variations-maker . ps) all)
    (define s (ref all 0))
    (apply up ((derivative-for maker ps) s)
           (for/list ([dp (in-list all-changes)] [k (in-naturals 1)])
             (define-values (slope change) (varied maker ps dp s (ref all k)))
             change)))
  (define (later) (advance variations-maker ps (apply up state starts) duration))
  (define end (structure->list (call-for-state 'linearized-flow later)))
  (define-values (by-state by-parameters) (split (cdr end) n))
  (flow (car end) by-state by-parameters))

(define (unit-structure x k) (scalars->structure x (lambda (j) (if (eqv? j k) 1 0))))

;; A motion with displacements of it: (up s v ...) ↦ (up f(s) Df(s)v ...).
(define (with-displacements f)
  (unary-function (lambda () (list 'with-displacements (value->datum f))) (all)
    (define parts (structure->list all))
    (define s (car parts))
    (apply up (f s)
           (for/list ([v (in-list (cdr parts))])
             (define-values (slope change) (value-and-derivative-along f s v))
             change))))

;; (advance), of a state and its displacements: where the motion ends the state alone is told.
;; Other failures are those of what it follows.
(define (call-for-state who advance)
  (define (retold e)
    (define state (ref (exn:fail:mechanics:singular-where e) 0))
    (define cause (cut-short-cause e))
    (raise-cut-short who 'ended #f state state (or cause "") cause))
  (with-handlers ([cut-short? retold])
    (advance)))

;; One in the direction of each scalar of the state from number `first` on.
(define (unit-displacements state first)
  (for/list ([k (in-range first (shape-length state))]) (unit-structure state k)))

;; For each scalar of each parameter, the changes of all parameters.
(define (unit-changes ps no-changes)
  (for*/list ([(p i) (in-parallel ps (in-naturals))]
              #:when (or (tuple? p) (scalar? p))
              [k (in-range (shape-length p))])
    (for/list ([q (in-list ps)] [none (in-list no-changes)] [j (in-naturals)])
      (if (eqv? i j) (unit-structure q k) none))))

;; The derivative as D would give it: by the state, or down, by the state and the parameters.
(define (flow-derivative advance maker ps state duration parameters?)
  (define f (flow-from advance maker ps state duration parameters?))
  (define by-state (arranged state (flow-by-state f)))
  (if parameters?
      (apply down by-state
             (let loop ([ps ps] [columns (flow-by-parameters f)])
               (cond [(null? ps) '()]
                     [(or (tuple? (car ps)) (scalar? (car ps)))
                      (define-values (own rest) (split columns (shape-length (car ps))))
                      (cons (arranged (car ps) own) (loop (cdr ps) rest))]
                     [else (loop (cdr ps) columns)])))
      by-state))

;; Derivatives by the scalars of x in the shape that D gives them.
(define (arranged x columns)
  (define rest columns)
  (let walk ([x x])
    (cond [(tuple? x)
           (define s (adopt x))
           (structure (flip-orientation (structure-orientation s))
                      (for/vector ([e (in-vector (structure-elements s))]) (walk e)))]
          [else (begin0 (car rest) (set! rest (cdr rest)))])))

;; Of numbers on a tape: the linear function that the derivatives make.
(define (advance-recorded tag advance maker ps state duration)
  (define (on-this-tape? x) (and (recorded? x) (eqv? (perturbed-tag x) tag)))
  (define (value x)
    (map-scalars (lambda (x) (if (on-this-tape? x) (recorded-value x) x)) x))
  (define numbers (filter (lambda (p) (or (tuple? p) (scalar? p))) ps))
  (define parameters? (ormap on-this-tape? (append-map* scalars numbers)))
  (define f (flow-from advance maker (map value ps) (value state) (value duration) parameters?))
  (define end (flow-end f))
  (define slope ((derivative-for maker (map value ps)) end))
  (for/fold ([sum end])
            ([x (in-list (append (list duration) (scalars state)
                                 (if parameters? (append-map* scalars numbers) '())))]
             [column (in-list (cons slope (append (flow-by-state f) (flow-by-parameters f))))]
             #:when (on-this-tape? x))
    (g:+ sum (g:* column (g:- x (recorded-value x))))))
