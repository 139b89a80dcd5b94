#lang racket/base
;; Where a Hamiltonian is at rest in phase space, and its second derivatives there.
;;
;; At an equilibrium all first derivatives vanish: exactly, or, of decimals, up to rounding beside
;; the second ones.  From a place that is near one, Newton's method finds it.

(require "../../algebra/expression/expression.rkt" "../../algebra/expression/symbols.rkt"
         "../../calculus/derivative.rkt"
         "../../error/complain.rkt" "../../error/failure.rkt" "../../error/refusal.rkt"
         "../../generic/describe.rkt" "../../generic/irrational.rkt"
         (only-in "../../generic/number-argument.rkt" known-number)
         "../../hamiltonian/H-state.rkt" "../../hamiltonian/Hamiltonian.rkt"
         "../../lagrangian/generic-state.rkt" "../../lagrangian/local-tuple.rkt"
         "../../numeric/linear-algebra/row-matrix.rkt"
         "../../search/find-root.rkt"
         "../../value/shape.rkt" "../../value/simplify.rkt" "../../value/structure.rkt")

(provide equilibrium-of second-derivatives place->state raise-no-number)

;; state : of symbols;  at : a state of numbers near one, or #f for the origin
;; -> coordinates and momenta, a list of numbers
(define (equilibrium-of who H state given)
  (define at (and given (s:map/r irrational-as-decimal given)))
  (check-Hamiltonian-and-state who H state)
  (check-symbols who state "state")
  (check-parameters who H state "state")
  (check-time-free who H state)
  (when at
    (check-state-like who state at)
    (unless (numeric? at)
      (complain who "the equilibrium is a state of numbers; given ~a" (describe-with-value at))))
  (define start (if at (cdr (scalars at)) (map (lambda (x) 0) (cdr (scalars state)))))
  (cond [(at-rest? who H state start) start]
        [else
         (define found (root-near who H state start at))
         (define simple
           (for/list ([x (in-list found)]) (rationalize (inexact->exact x) 1/1000000000)))
         (if (andmap (lambda (g) (eqv? g 0)) (gradient who H state simple)) simple found)]))

(define (place->state state xs) (list->structure state (cons (time state) xs)))

(define (at-rest? who H state place)
  (define steepest (apply max (map magnitude (gradient who H state place))))
  (or (eqv? steepest 0)
      (and (inexact? steepest)
           (<= steepest (* 1e-13 (greatest-entry (second-derivatives who H state place)))))))

(define (root-near who H state start at)
  (define (slopes z) (gradient-up H state z))
  (define found
    (with-handlers ([exn:fail:mechanics? (lambda (e) (raise-none who H state start))])
      (scalars (find-root slopes (list->up start)))))
  (when (and at (for/or ([x (in-list start)] [y (in-list found)])
                  (> (abs (- x y)) (* 1/10 (+ 1 (abs x))))))
    (raise-none who H state start
                (format "\n  one is at ~a" (value->text (place->state state found)))))
  found)

(define (raise-none who H state start [more ""])
  (complain who "there is no equilibrium of ~a at ~a\n  derivatives there: ~a~a"
            (value->text H) (value->text (place->state state start))
            (value->text (gradient who H state start))
            (if (equal? more "") "\n  give a state near one by #:at" more)))

;; ---------------------------------------------------------------------------
;; Derivatives, by coordinates and momenta in a row

(define ((energy-at H state) z) (H (place->state state (scalars z))))
(define (gradient-up H state z)
  (list->up (scalars (derivative-at (energy-at H state) z))))

(define (gradient who H state place)
  (numbers-of who H place (lambda () (scalars (gradient-up H state (list->up place))))))

;; -> rows
(define (second-derivatives who H state place)
  (define n (length place))
  (define all
    (numbers-of who H place
                (lambda ()
                  (scalars (derivative-at (lambda (z) (gradient-up H state z))
                                          (list->up place))))))
  (for/vector ([i (in-range n)])
    (for/vector ([x (in-list (list-tail all (* i n)))] [_ (in-range n)]) x)))

(define (numbers-of who H place derivatives)
  (define found
    (with-handlers ([divided-by-zero?
                     (lambda (e)
                       (complain who "~a has no Taylor series at ~a: it divides by zero there"
                                 (value->text H)
                                 (if (andmap zero? place) "the origin" (value->text place))))])
      (derivatives)))
  (for/list ([x (in-list found)])
    (if (real? x) x
        (let ([y (simplify x)]) (or (known-number y) (raise-no-number who H y))))))

;; part : an expression that is no number; the first symbol in it is named
(define (raise-no-number who H part)
  (define names (if (expression? part) (symbols-in part) '()))
  (complain who
            (string-append "the coefficients of the series of ~a are to be numbers; there is ~a"
                           "\n  give the parameters as numbers")
            (value->text H) (value->text (if (null? names) part (car names)))))

(define (check-time-free who H state)
  (define e (simplify-strictly (H state)))
  (when (occurs? (time state) e)
    (complain who "~a depends on the time ~a, and has no normal form; its value: ~a"
              (value->text H) (time state) (value->text e))))
