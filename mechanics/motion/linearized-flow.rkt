#lang racket/base
;; How a motion depends on where it starts and on its parameters.
;;
;; With s' = f(s, p), a change v of the state follows the equation of variations,
;; v' = ∂f/∂s v + ∂f/∂p δp.  That is a motion too: of the pair (s, v), and is integrated like
;; any other, with the same care for its error.  So derivatives of a motion are exact, not
;; differences of motions.  The derivative itself may be differentiated: the motion of
;; pairs is followed by the same advancer, which finds the ε of the other derivative in it.

(require racket/list
         "integration-failure.rkt" "system/parametric-system.rkt"
         "../calculus/derivative.rkt" "../calculus/dual.rkt" "../calculus/perturbed-value.rkt"
         "../calculus/recorded-number.rkt"
         "../error/failure.rkt"
         "../generic/arithmetic.rkt" "../generic/printed-function.rkt" "../generic/scalar.rkt"
         "../generic/up-down.rkt"
         "../value/shape.rkt"
         (only-in "../value/structure.rkt" flip ref s:map/r structure->list zero-like))

(provide advance-perturbed flow-derivative variation-maker
         ;; for exponents and multipliers
         with-displacements unit-displacements call-for-state)

;; Is x, a parameter, made of scalars?  It may be a function, which is left alone.
(define (varies? x) (or (tuple? x) (scalar? x)))

;; advance : maker parameters state duration -> state, as of a state-advancer

;; The state reached where the state, a parameter or the duration is being differentiated.
;; variation : as variation-maker makes it of the maker
(define (advance-perturbed who advance maker variation ps state duration)
  (define x (outermost-of (append (scalars state) (append-map scalars ps) (list duration))))
  (define tag (perturbed-tag x))
  (cond [(dual? x) (advance-dual tag advance maker variation ps state duration)]
        [(recorded? x) (advance-recorded tag advance maker ps state duration)]
        [else (raise-no-series who)]))

(define (outermost-of xs)
  (for/fold ([found #f]) ([x (in-list xs)] #:when (perturbed? x))
    (if found (outermost found x) x)))

;; The failure tells calculus/derivative to take derivatives of higher order one after the other.
(define (raise-no-series who)
  (raise-singular who "a motion has no Taylor series by its start; D of D is taken" #f))

;; ---------------------------------------------------------------------------
;; One direction

(define (advance-dual tag advance maker variation ps state duration)
  (define (value x) (map-scalars (lambda (x) (primal-part x tag)) x))
  (define (change x) (map-scalars (lambda (x) (tangent-part x tag)) x))
  (define pair
    (advance variation
             (append (map value ps) (map change ps))
             (up (value state) (change state))
             (primal-part duration tag)))
  (define end (ref pair 0))
  (define slope ((derivative-for maker (map value ps)) end))
  (define all (g:+ (ref pair 1) (g:* (tangent-part duration tag) slope)))
  (list->structure end (map (lambda (x dx) (make-dual tag x dx)) (scalars end) (scalars all))))

;; Functions, which parameters may be, are left alone.
(define (map-scalars f x) (if (varies? x) (s:map/r f x) x))

;; all : n parameters and their changes -> the derivative of pairs of a state and its change
(define ((variation-maker maker n) . all)
  (define-values (ps changes) (split-at all n))
  (lambda (pair)
    (define-values (slope change)
      (varied maker ps changes (ref pair 0) (ref pair 1)))
    (up slope change)))

;; The rate of a state, and the rate of its change where the parameters change as well.
(define (varied maker ps changes state v)
  (define (f all)
    (define xs (structure->list all))
    ((derivative-for maker (with-numbers varies? ps (cdr xs))) (car xs)))
  (value-and-derivative-along
   f
   (apply up state (filter varies? ps))
   (apply up v (for/list ([p (in-list ps)] [dp (in-list changes)] #:when (varies? p)) dp))))

;; ---------------------------------------------------------------------------
;; All directions at once

;; end : the state reached; by-state, by-parameters : its derivatives by each scalar of these
(struct flow (end by-state by-parameters) #:authentic)

;; parameters? : are derivatives by these wanted as well?
(define (flow-from advance maker ps state duration parameters?)
  (define n (shape-length state))
  (define no-changes (map zero-like ps))
  (define changes (if parameters? (unit-changes ps no-changes) '()))
  (define starts
    (append (unit-displacements state 0)
            (map (lambda (_) (zero-like state)) changes)))
  (define all-changes (append (make-list n no-changes) changes))
  (define ((variations-maker . ps) all)
    (define s (ref all 0))
    (apply up ((derivative-for maker ps) s)
           (for/list ([dp (in-list all-changes)] [k (in-naturals 1)])
             (define-values (slope change) (varied maker ps dp s (ref all k)))
             change)))
  (define (later) (advance variations-maker ps (apply up state starts) duration))
  (define end (structure->list (call-for-state 'linearized-flow later)))
  (define-values (by-state by-parameters) (split-at (cdr end) n))
  (flow (car end) by-state by-parameters))

;; The rates of a motion and of displacements of it: (up s v ...) ↦ (up f(s) Df(s)v ...).
(define (with-displacements f)
  (printed-function (with-displacements f) (all)
    (define parts (structure->list all))
    (define s (car parts))
    (apply up (f s)
           (for/list ([v (in-list (cdr parts))])
             (define-values (slope change) (value-and-derivative-along f s v))
             change))))

;; The value of (advance), which follows a state and its displacements; a failure of the motion
;; is raised again with the state alone.
(define (call-for-state who advance)
  (define (retold e)
    (define state (ref (exn:fail:mechanics:singular-where e) 0))
    (define cause (cut-short-cause e))
    (raise-cut-short who 'ended #f state state (or cause "") cause))
  (with-handlers ([cut-short? retold])
    (advance)))

;; One in the direction of each scalar of the state from index `start` on.
(define (unit-displacements state start)
  (for/list ([k (in-range start (shape-length state))]) (unit-structure state k)))

;; For each scalar of each parameter, the changes of all parameters.
(define (unit-changes ps no-changes)
  (for*/list ([(p i) (in-parallel ps (in-naturals))]
              #:when (varies? p)
              [k (in-range (shape-length p))])
    (list-set no-changes i (unit-structure p k))))

;; The derivative as D would give it: by the state, or down, by the state and the parameters.
(define (flow-derivative advance maker ps state duration parameters?)
  (define f (flow-from advance maker ps state duration parameters?))
  (define by-state (flip state))
  (list->structure (if parameters? (apply down by-state (map flip (filter varies? ps))) by-state)
                   (append (flow-by-state f) (flow-by-parameters f))))

;; The state reached as a linear function of the numbers on a tape, by its derivatives.
(define (advance-recorded tag advance maker ps state duration)
  (define (on-this-tape? x) (and (recorded? x) (eqv? (perturbed-tag x) tag)))
  (define (value x)
    (map-scalars (lambda (x) (if (on-this-tape? x) (recorded-value x) x)) x))
  (define numbers (append-map scalars (filter varies? ps)))
  (define parameters? (ormap on-this-tape? numbers))
  (define f (flow-from advance maker (map value ps) (value state) (value duration) parameters?))
  (define end (flow-end f))
  (define slope ((derivative-for maker (map value ps)) end))
  (for/fold ([sum end])
            ([x (in-list (append (list duration) (scalars state)
                                 (if parameters? numbers '())))]
             [column (in-list (cons slope (append (flow-by-state f) (flow-by-parameters f))))]
             #:when (on-this-tape? x))
    (g:+ sum (g:* column (g:- x (recorded-value x))))))
