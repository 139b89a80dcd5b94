#lang racket/base
;; Equilibria: coordinates at which a system that rests stays at rest.
;;
;; A constant path q solves Lagrange's equations if the residual vanishes at
;; (t, q, 0, 0); of an L that does not change in time that is −∂₁L there.

(require racket/list
         "equilibrium.rkt" "argument-order.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/pi.rkt"
         "../algebra/expression/symbols.rkt"
         "../algebra/solve/angles-in.rkt" "../algebra/solve/solve-by-cases.rkt"
         "../error/complain.rkt" "../error/failure.rkt" "../error/note.rkt" "../error/refusal.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/up-down.rkt"
         "../hamiltonian/as-Lagrangian.rkt"
         "../lagrangian/external-force.rkt" "../lagrangian/generic-state.rkt"
         "../lagrangian/Lagrange-equations.rkt" "../lagrangian/local-tuple.rkt"
         "../lagrangian/total-derivative.rkt"
         "../numeric/constants.rkt"
         "../search/find-root.rkt"
         "../value/algebra.rkt" "../value/assumptions.rkt" "../value/shape.rkt"
         "../value/simplify.rkt"
         "../verdict/derivative-survey.rkt" "../verdict/prove-zero.rkt"
         "../verdict/question-domain.rkt"
         "../verdict/verdict.rkt")

(provide verify-equilibrium equilibria find-equilibrium
         equilibrium? equilibrium-coordinates equilibrium-conditions)

;; A verdict on the residual of a system at rest at q, at all times.
(define (verify-equilibrium given q #:force [given-force #f])
  (check-order-of-arguments 'verify-equilibrium '(L q) (list given q))
  (check-coordinates 'verify-equilibrium q)
  (define-values (L force) (as-Lagrangian 'verify-equilibrium given q given-force))
  (define (judge q)
    (prove-zero (lambda (t) (residual-at-rest 'verify-equilibrium L force t q))
                #:motion-domain (lambda (t) (values-at-rest L force t q))
                #:surveys (lambda ()
                            (surveys-at-rest L force (string->uninterned-symbol "t") q))))
  (define v (judge q))
  (define exactly (and (not (proved? v)) (with-exact-angles q)))
  (define w (if exactly (judge exactly) v))
  (if (proved? w) w v))

;; Kinks are looked for at coordinates that are any numbers; for an L that fails at symbols the
;; given numbers suffice.
(define (surveys-at-rest L force t q)
  (define anywhere (symbols-like q "q"))
  (define-values (_ survey)
    (if-raised raised? (values #f #f)
      (survey-derivatives
       (lambda () (residual-at-rest 'verify-equilibrium L force t anywhere))
       (scalars anywhere)
       #:put (lambda () (map cons (scalars anywhere) (scalars q)))
       #:domain (lambda () (values-at-rest L force t q))
       #:solve-for (remove-duplicates (append-map symbols-in (scalars q))))))
  (if survey (list survey) '()))

;; q with exact multiples of π/2 in place of flonums that are rounded multiples, or made of the
;; flonum pi; #f if there are none.
(define (with-exact-angles q)
  (define exact (s:map/r (lambda (x) (or (exact-angle x) x)) q))
  (and (not (equal? exact q)) exact))

(define (exact-angle x)
  (define turns (and (flonum? x) (rational? x) (round (/ x (/ pi 2)))))
  (and turns
       (not (zero? turns))
       (or (= x (* turns (/ pi 2)))
           (= x (exact->inexact (* (inexact->exact turns) 1/2 pi-digits))))
       (e:* (* 1/2 (inexact->exact turns)) exact-pi)))

;; A list of them, by formulas in the parameters.
;; state : of symbols, with velocities or with momenta
(define (equilibria given state #:force [given-force #f])
  (check-order-of-arguments 'equilibria '(L local) (list given state))
  (define-values (L force) (as-Lagrangian-at 'equilibria given state given-force))
  (define local (as-local state))
  (check-generic-states 'equilibria local L (external-force 'equilibria force #f))
  (define q (coordinate local))
  (define given-residual (residual-at-rest 'equilibria L force (time local) q))
  (define residual (simplify given-residual))
  (check-constant 'equilibria residual (time local))
  (define solutions
    (solve-by-cases (scalars given-residual) (scalars q) (assumptions-in-force)))
  (unless solutions (raise-no-formula residual))
  (when (null? solutions) (note-constant-force residual q))
  (note-other-period residual q)
  (note-other-turns L (time local) q residual)
  (for*/list ([s (in-list solutions)]
              [at (in-value (s:map/r (lambda (name) (value-of name (car s))) q))]
              #:when (in-domain? L force (time local) at))
    (equilibrium at (cdr s))))

;; Where a force a is the same everywhere, nothing rests, unless a is 0.
(define (note-constant-force residual q)
  (for ([e (in-list (scalars residual))])
    (define names (if (symbolic? e) (symbols-in e) '()))
    (when (and (pair? names) (not (ormap (lambda (x) (memq x names)) (scalars q))))
      (note-once (format "equilibria: there are none, unless ~a is 0" (value->text e))))))

(define (value-of name solution)
  (cond [(assq name solution) => cdr]
        [else name]))

;; Where the Lagrangian has no real value nothing rests.
(define (in-domain? L force t q)
  (somewhere-real? (domain-expressions (append (scalars q) (values-at-rest L force t q)))
                   (assumptions-in-force)))

(define (values-at-rest L force t q) (values-along (list L force) (up t q (g:* 0 q))))

;; For cos(k x) the equilibria within one turn of k x are found; a turn of x may have others.
(define (note-other-period residual q)
  (define u (angle-of-other-period (scalars residual) (scalars q) (assumptions-in-force)))
  (when u
    (note-once (format (string-append "equilibria: found are those within one turn of ~a; "
                                      "there may be others, of other turns")
                       (value->text u)))))

;; The force of cos x − x/2 is the same a turn on, and the system is not: x is no angle, and there
;; are other equilibria a turn on.
(define (note-other-turns L t q residual)
  (define (at-rest q) (L (up t q (g:* 0 q))))
  (define (change x)
    (simplify (g:- (at-rest (substitute q x (g:+ x ':2pi))) (at-rest q))))
  (for ([x (in-list (scalars q))]
        #:when (ormap (lambda (e) (in-angle? x e)) (scalars residual))
        #:unless (eqv? 0 (change x)))
    (note-once (format (string-append "equilibria: found are those within one turn of ~a; the "
                                      "system is not the same a turn on, where there are others")
                       x))))

;; An equilibrium is one at any time; at 0 a factor t would hide it.
(define some-time 0.7318)

;; The coordinates of one near the start, by numbers.
(define (find-equilibrium given start #:force [given-force #f])
  (check-order-of-arguments 'find-equilibrium '(L start) (list given start))
  (check-coordinates 'find-equilibrium start)
  (define-values (L force) (as-Lagrangian 'find-equilibrium given start given-force))
  (define (residual-at q) (residual-at-rest 'find-equilibrium L force some-time q))
  (check-no-symbols (residual-at start))
  (check-no-symbols (if-raised raised? 0 (residual-at (beside start))))
  (define q (find-root residual-at start))
  (define (residual t) (residual-at-rest 'find-equilibrium L force t q))
  (check-constant 'find-equilibrium (simplify (residual 't)) 't)
  q)

(define (residual-at-rest who L force t q)
  (define rest (g:* 0 q))
  (define inside ((Euler-Lagrange-operator (scalar-valued who L)) (up t q rest rest)))
  (if force
      (g:- inside (force-like who inside ((external-force who force #f) (up t q rest))))
      inside))

;; ---------------------------------------------------------------------------
;; Complaints

;; A factor of a coordinate vanishes with it, as k x does at 0; beside the start it does not.
(define (beside start) (s:map/r (lambda (x) (g:+ 1/3 x)) start))

;; Newton's method is one of numbers.
(define (check-no-symbols residual)
  (when (ormap symbolic? (scalars (simplify residual)))
    (complain 'find-equilibrium
              (string-append "symbols are left in the force on the system at rest"
                             "\n  residual: ~a"
                             "\n  give the Lagrangian numbers as parameters; "
                             "equilibria finds formulas in symbols")
              (value->text (simplify residual)))))

(define (check-constant who residual t)
  (define name (string->uninterned-symbol "t"))
  (define (at value) (substitute residual t value))
  (when (refuted? (prove-zero (g:- (at name) residual)))
    (complain who "the force on the system at rest changes in time\n  residual: ~a"
              (value->text residual))))

(define (raise-no-formula residual)
  (raise-no-answer 'equilibria
                   (string-append "no formula was found for the zeros of ~a"
                                  "\n  find-equilibrium finds one near given coordinates, "
                                  "by numbers")
                   (value->text residual)))
