#lang racket/base
;; From momenta to velocities: the v at which the gradient ∂F/∂v is w.
;;
;; F depends on v and on what is given with it, the time and coordinates.  How to find v is
;; settled once for all arguments of a shape, at symbols:
;;
;;   exactly     where F is quadratic in v: M v = w − b, with the second derivatives M, which
;;               do not depend on v, and the gradient b at v = 0
;;   by formula  where the equations can be solved (velocity-formula.rkt)
;;   by numbers  elsewhere, by Newton's method; the derivatives of v are those of the inverse
;;               function
;;
;; Of a quadratic F the Legendre transform w v − F(v) is (w − b) v / 2 − F(0).
;;
;; Second derivatives without an inverse leave velocities open: directions without inertia.

(require "unknowns-by-numbers.rkt"
         "../calculus/derivative.rkt"
         "../error/failure.rkt" "../error/refusal.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/on-demand.rkt"
         (only-in "../lagrangian/state-derivative.rkt" directions->text)
         "../numeric/finite-number.rkt"
         "../value/by-shape.rkt" "../value/shape.rkt"
         "../value/simplify.rkt" "../value/structure.rkt"
         "../value/matrix/linear-algebra.rkt")

;; Most Lagrangians are quadratic.
(require-on-demand
 ["velocity-formula.rkt" solve-gradient]
 ["../calculus/expression-function.rkt" evaluate-at]
 ["../search/implicit-root.rkt" plain])

(provide make-inverter velocity-at transform-at)

;; who : complains; F : given v -> number
;; how : (up given w) -> 'exactly, 'by-numbers or a formula, which may rest on declared assumptions
(struct inverter (who F how) #:authentic)

(define (make-inverter who F)
  (define i
    (inverter who F (by-shape (lambda (given-w) (settle i (ref given-w 0) (ref given-w 1)))
                              #:lasting? (lambda (how) (not (formula? how))))))
  i)

(define (how-to i given w) ((inverter-how i) (up given w)))

;; given : a tuple; w : momenta, or whatever is dual to v
(define (velocity-at i given w)
  (define how (how-to i given w))
  (case how
    [(exactly) (let-values ([(M push) (linear-equations i given w)]) (solved i M push))]
    [(by-numbers) (velocity-by-numbers i given w)]
    [else (velocity-by-formula i how given w)]))

;; w v − F(v) at that v
(define (transform-at i given w)
  (define (F v) ((inverter-F i) given v))
  (cond [(eq? (how-to i given w) 'exactly)
         (define-values (M push) (linear-equations i given w))
         (g:- (g:* 1/2 push (solved i M push)) (F (compatible-zero w)))]
        [else
         (define v (velocity-at i given w))
         (g:- (g:* w v) (F v))]))

;; -> M and w − b
(define (linear-equations i given w)
  (define F ((gradient-in i) given))
  (define zero (compatible-zero w))
  (values (derivative-at F zero) (g:- w (F zero))))

;; given ↦ (v ↦ ∂F/∂v)
(define ((gradient-in i) given)
  (lambda (v) (derivative-at (lambda (v) ((inverter-F i) given v)) v)))

;; ---------------------------------------------------------------------------
;; Settling the way

;; F may fail at symbols; then the velocities are found by numbers.
(define (settle i given w)
  (define place (symbols-like given "q"))
  (define-values (v momenta) (values (symbols-like (compatible-zero w) "v") (symbols-like w "w")))
  (define equations (gradient-at-symbols i place v))
  (cond [(not equations) 'by-numbers]
        [(independent? (equations-slopes equations) (scalars v)) 'exactly]
        [else
         (check-inertia i equations momenta)
         (define solution
           (solve-gradient (equations-values equations) (equations-slopes equations)
                           (scalars v) (scalars momenta)))
         (if solution (formula (up place momenta) (list->structure v solution)) 'by-numbers)]))

;; values : ∂F/∂v, slopes : its derivatives by v
(struct equations (values slopes) #:authentic)

(define (gradient-at-symbols i place v)
  (with-handlers ([raised? (lambda (e) #f)])
    (define F ((gradient-in i) place))
    (equations (F v) (derivative-at F v))))

;; Often it is seen before they are simplified that slopes do not depend on v; to simplify must
;; not take for granted that v is positive, as in the root of v².
(define (independent? slopes v)
  (or (free-of? slopes v)
      (free-of? (simplify-strictly slopes) v)))

;; ---------------------------------------------------------------------------
;; Formulas

;; place : (up given w) of symbols; v : the velocities in terms of these
(struct formula (place v) #:authentic)

(define (velocity-by-formula i f given w)
  (define v (evaluate-at (formula-v f) (formula-place f) (up given w)))
  ;; No velocity has a momentum of which the formula is the logarithm of a negative number, say.
  (when (ormap not-real? (scalars (plain v)))
    (raise-none-found (inverter-who i) (what-is-sought i) "" w (plain v) #f))
  v)

;; ---------------------------------------------------------------------------
;; Numbers

(define (velocity-by-numbers i given w)
  (unknowns-by-numbers (inverter-who i) (what-is-sought i) ((gradient-in i) given) w
                       (starting-velocity i (plain given) (plain w))))

;; The solution for a quadratic F; if it has no value, the momenta themselves.
(define (starting-velocity i given w)
  (with-handlers ([no-value? (lambda (e) (flip w))])
    (define-values (M push) (linear-equations i given w))
    (solve-linear-left M push)))

;; ---------------------------------------------------------------------------
;; Failures

(define (solved i M w)
  (with-handlers ([exn:fail:mechanics:singular:matrix? (lambda (e) (raise-no-inertia i M e))])
    (solve-linear-left M w)))

(define (check-inertia i equations w) (void (solved i (equations-slopes equations) w)))

(define (raise-no-inertia i M e)
  (raise-without-inverse
   (inverter-who i)
   (string-append
    "the second derivatives have no inverse; "
    (if (back? i) "momenta do not follow from velocities" "velocities do not follow from momenta")
    (directions->text e (if (back? i) "the same velocity" "no inertia") simplify)
    (format "\n  second derivatives: ~a" (value->text (simplify M))))
   M
   (or (exn:fail:mechanics:singular:matrix-null-vectors e) '())
   e))

;; Are momenta sought, those of velocities?
(define (back? i) (eq? (inverter-who i) 'Hamiltonian->Lagrangian))

(define (what-is-sought i) (if (back? i) "momenta" "velocities"))
