#lang racket/base
;; Periodic orbits, one or a branch of them as a parameter or the energy changes.

(require racket/flonum
         "branch-start.rkt" "branch.rkt" "curve-step.rkt" "orbit-equations.rkt"
         "symmetric-orbit.rkt"
         "../map/period-check.rkt"
         "../../error/failure.rkt" "../../error/refusal.rkt"
         "../../generic/compare.rkt" "../../generic/define-plain.rkt" "../../generic/describe.rkt"
         "../../generic/function.rkt" "../../generic/up-down.rkt" "../../generic/value-struct.rkt"
         "../../generic/wrong-argument.rkt"
         "../../motion/system/check.rkt"
         "../../numeric/flvector.rkt"
         "../../value/shape.rkt")

(provide continue-periodic-orbit find-periodic-orbit periodic-orbit?
         ;; for those that begin elsewhere
         orbits-from unknowns-at (rename-out [family-of orbit-family]))

;; multipliers : without those that are 1 for every orbit
(value-struct periodic-orbit (state period multipliers)
  #:text (lambda (o)
           (format "~a periodic orbit of period ~a through ~a\n  multipliers: ~a"
                   (if (periodic-orbit-stable? o) "stable" "unstable")
                   (periodic-orbit-period o) (value->text (periodic-orbit-state o))
                   (value->text (periodic-orbit-multipliers o)))))

(provide-parts periodic-orbit? "a periodic orbit, as find-periodic-orbit finds one"
  periodic-orbit-state periodic-orbit-period periodic-orbit-multipliers periodic-orbit-stable?)

(define (periodic-orbit-stable? o)
  (for/and ([l (in-list (periodic-orbit-multipliers o))]) (<= (magnitude l) (+ 1 1e-6))))

;; The orbit near the state; with an energy the one of the energy there
(define-plain (find-periodic-orbit derivative state period
                                   #:energy [energy #f] #:symmetry [R #f]
                                   #:tolerance [tolerance 1e-12])
  (define who 'find-periodic-orbit)
  (check-comes-first who (and (tuple? derivative) (pointwise? state)) "state derivative" "state")
  (check-derivative who derivative state)
  (when (and R (not (same-shape? (R state) state)))
    (complain-of-argument who "a symmetry, a function from states to states" R))
  (define o (orbits-from who (lambda (p) derivative) state period energy tolerance 0.0))
  (define p (if energy (real->double-flonum (comparand (energy state))) 0.0))
  (define x0 (unknowns-at o state period p))
  (define e (orbit-equations o x0 1.0))
  (define x
    (with-handlers ([exn:fail:mechanics? (lambda (_) (raise-no-orbit who o x0 state period))])
      (solution-near who (if R (symmetric-equations o R x0) e) x0)))
  (when (rests? o x x0) (raise-no-orbit who o x0 state period))
  (define f (family-of o e))
  (periodic-orbit ((family-state f) x) ((equations-period e) x)
                  ((evaluated-spectrum ((equations-evaluate e) x x)))))

;; family : parameter -> state derivative; or, with an energy, a state derivative
(define-plain (continue-periodic-orbit family state period from to
                                       #:energy [energy #f]
                                       #:step [step 0.05] #:longest-step [longest 0.5]
                                       #:most-steps [most 200] #:tolerance [tolerance 1e-12])
  (define who 'continue-periodic-orbit)
  (define l (make-limits who from to step longest most))
  (define systems (if energy (lambda (p) family) family))
  (check-family who systems state from)
  (define o (orbits-from who systems state period energy tolerance (limits-from l)))
  (define x0 (unknowns-at o state period (limits-from l)))
  (define e (orbit-equations o x0 (parameter-scale l)))
  (define (fail) (raise-no-orbit who o x0 state period))
  (define start (first-point who e l x0 fail))
  (when (rests? o (point-x start) x0) (fail))
  (branch-from (family-of o e) l start))

(define (family-of o e)
  (define n (length (start-of o)))
  (family e "periodic orbits" #t
          (lambda (x) (state-of o (part x 0 n)))
          #f (orbits-family o)))

;; ---------------------------------------------------------------------------

;; period : a number; or, of a driven system, a function of the parameter
(define (orbits-from who family state period energy tolerance from)
  (check-tolerance who tolerance)
  (define at (if (procedure? period) (period from) period))
  (check-duration who at)
  (when (and energy (not (and (pointwise? energy) (accepts? energy 1))))
    (complain-of-argument who "an energy, a function of the state" energy))
  (define f (family from))
  (define timed? (timed-state? f state))
  (define driven? (and timed? (changes-in-time? f state at)))
  (when driven? (check-period who f state at))
  (define flow (flow-over family state timed? tolerance))
  (define n (- (shape-length state) (if timed? 1 0)))
  (define o
    (orbits family state timed? (and driven? (if (procedure? period) period (lambda (p) period)))
            energy (make-flvector n) 1 flow))
  (define z (start-numbers o))
  (define gap (difference (flow-end (flow o z from (comparand at))) z))
  (struct-copy orbits o [turns (turns-of gap)]))

;; Do the rates change in the course of a period?
(define (changes-in-time? f state period)
  (define (rates share)
    (numbers-of (f (changed state (lambda (x k) (if (= k 0) (+ x (* share period)) (+ x 0.1)))))))
  (fl> (distance (rates 0.0) (rates 0.37)) 1e-9))

(define (start-numbers o) (numbers-of (apply up (start-of o))))

(define (unknowns-at o state period p)
  (define T (if (procedure? period) (period p) period))
  (orbit-unknowns o (start-numbers o) (real->double-flonum (comparand T)) p))

;; Has the orbit shrunk to an equilibrium, or its period, from that of x0, to no time?  That of a
;; driven system may rest.
(define (rests? o x x0)
  (define n (length (start-of o)))
  (define p (if (orbits-energy o) 0.0 (flvector-ref x (- (flvector-length x) 1))))
  (define z (part x 0 n))
  (and (not (orbits-period o))
       (or (fl< (norm (rates-at o z p)) (fl* 1e-6 (fl+ 1.0 (norm z))))
           (fl< (flabs (flvector-ref x n)) (fl* 1e-6 (flabs (flvector-ref x0 n)))))))

;; Does the state come back after several of these periods?
(define (raise-no-orbit who o x0 state period)
  (define z (start-numbers o))
  (define p (if (orbits-energy o) 0.0 (flvector-ref x0 (- (flvector-length x0) 1))))
  (define T (comparand (if (procedure? period) (period p) period)))
  (define (gap k)
    (if-raised refusal? +inf.0 (distance (flow-end ((orbits-advance o) o z p (* k T))) z)))
  (define once (gap 1))
  (define times (for/first ([k (in-list '(2 3 4))] #:when (fl< (gap k) (fl* 0.05 once))) k))
  (raise-not-convergent
   who
   (string-append "no periodic orbit was found near the state"
                  (if times (format "\n  after ~a of these periods it is back" times) ""))
   state once #:show? #f "state" state "period" T "after it the state is off by" once))
