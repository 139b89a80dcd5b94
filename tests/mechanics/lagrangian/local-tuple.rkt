#lang racket/base
;; Local tuples: Γ, its lengths, selectors and their errors.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/value/compose
         mechanics/value/structure
         mechanics/calculus/derivative
         mechanics/calculus/literal-function
         mechanics/value/signature
         mechanics/lagrangian/local-tuple
         mechanics/scmutils
         "../support/checks.rkt" "../support/messages.rkt" "../support/same.rkt")

(define q (literal-function 'q))
(define path-xy (up (literal-function 'x) (literal-function 'y)))

;; ---------------------------------------------------------------------------
;; Γ

(test-case "Γ of a path is time, coordinates and velocities"
  (check-equal? ((Gamma q) 't) (up 't (q 't) ((D q) 't)))
  (check-equal? ((Gamma path-xy) 't)
                (up 't (path-xy 't) ((D path-xy) 't)))
  (check-equal? ((Gamma (lambda (t) (g:square t))) 3) (up 3 9 6))
  (check-equal? (format "~a" (Gamma q)) "(Gamma q)"))

(test-case "Γ with a length gives that many components"
  (for ([n (in-range 2 7)])
    (define local ((Gamma q n) 't))
    (check-equal? (s:length local) n)
    (for ([k (in-range 1 n)])
      (check-equal? (ref local k) (((g:expt D (sub1 k)) q) 't))))
  (check-equal? ((Gamma (lambda (t) (g:expt t 4)) 5) 2) (up 2 16 32 48 48))
  (check-equal? (format "~a" (Gamma q 4)) "(Gamma q 4)"))

(test-case "Γ of a path of any shape: literal structures, functions returning tuples, nested"
  (define literal (literal-function 'q (-> Real (UP Real (UP Real Real)))))
  (check-equal? (s:length (ref ((Gamma literal) 't) 2 1)) 2)
  (check-equal? ((Gamma (lambda (t) (up t (down (g:square t) 1)))) 3)
                (up 3 (up 3 (down 9 1)) (up 1 (down 6 0)))))

(test-case "Γ composes with functions of local tuples"
  (check-true (same? ((compose (g:square velocity) (Gamma q)) 't) (g:square ((D q) 't))))
  (check-true (same? (D (compose coordinate (Gamma q))) (D q)))
  (check-equal? ((path->state-path q) 't) ((Gamma q) 't)))

(test-case "what is no path is refused with the way to make one"
  (check-message
   "Gamma: a path is a function of time, or a tuple of such functions; given the symbol q\n  (literal-function 'q) makes a path of that name"
   (Gamma 'q))
  (check-message
   "Gamma: a path is a function of time, or a tuple of such functions; given the number 3\n  a path is written (lambda (t) ...), with t where the time stands"
   (Gamma 3))
  (check-message
   "Gamma: a path is a function of time, or a tuple of such functions; given (q q), a list\n  a list is not a tuple; use (up x y ...)"
   (Gamma (list q q)))
  (check-exn #rx"the length of the local tuples, an integer of at least 2\n  given: the number 1"
             (lambda () (Gamma q 1)))
  (check-exn #rx"the length of the local tuples" (lambda () (Gamma q 2.5))))

;; ---------------------------------------------------------------------------
;; Building and taking apart

(define local (up 't (up 'x 'y) (up 'vx 'vy) (up 'ax 'ay)))

(test-case "local tuples are up tuples, of any length"
  (for ([make (list ->local ->state ->L-state)])
    (check-equal? (make 't 'q 'v) (up 't 'q 'v))
    (check-equal? (make 't (up 'x 'y)) (up 't (up 'x 'y)))
    (check-equal? (make 't 'q 'v 'a 'j) (up 't 'q 'v 'a 'j))))

(test-case "every selector by each of its names"
  (for ([select (list time state->t)]) (check-equal? (select local) 't))
  (for ([select (list coordinate coordinates state->q Q)])
    (check-equal? (select local) (up 'x 'y)))
  (for ([select (list velocity velocities state->qdot Qdot)])
    (check-equal? (select local) (up 'vx 'vy)))
  (for ([select (list acceleration accelerations state->qddot Qdotdot)])
    (check-equal? (select local) (up 'ax 'ay)))
  (check-equal? (state->n-dof local) 2)
  (check-equal? (state->n-dof (up 't 'q 'v)) 1))

(test-case "the parts of local tuples have constructors; momenta are down"
  (for ([make (list coordinate-tuple velocity-tuple acceleration-tuple)])
    (check-equal? (make 'x 'y) (up 'x 'y))
    (check-equal? (make 'x) (up 'x)))
  (check-equal? (momentum-tuple 'p_x 'p_y) (down 'p_x 'p_y))
  (check-true (same? (g:* (momentum-tuple 'p_x 'p_y) (velocity-tuple 'vx 'vy))
                     (g:+ (g:* 'p_x 'vx) (g:* 'p_y 'vy)))))

(test-case "selectors take part in the arithmetic of functions"
  (check-true (same? ((g:* 1/2 'm (g:square velocity)) local)
                     (g:* 1/2 'm (g:+ (g:square 'vx) (g:square 'vy)))))
  (check-equal? (((partial 2) (g:square velocity)) (up 't 'q 'v)) (g:* 2 'v))
  (check-equal? (format "~a" (g:square velocity)) "(square velocity)"))

(test-case "a vector counts as a local tuple"
  (check-equal? (velocity (vector 't 'q 'v)) 'v))

(test-case "a selector says what it wanted and what it got"
  (check-message
   (string-append "time: expected a local tuple (up t q v ...) with the time; given the number 3\n"
                  "  time is the book's selector; (show-time expression) tells how long one takes\n"
                  "  Racket's form for timing an expression is in racket/base under the same name: (require (only-in racket/base [time racket:time]))")
   (time 3))
  (check-message
   "coordinate: expected a local tuple (up t q v ...) with coordinates; given (up t), an up tuple of 1"
   (coordinate (up 't)))
  (check-message
   "velocity: expected a local tuple (up t q v ...) with velocities; given the symbol v"
   (velocity 'v))
  (check-message
   "velocity: expected a local tuple (up t q v ...) with velocities; given (down t q v), a down tuple of 3"
   (velocity (down 't 'q 'v)))
  (check-message
   "acceleration: expected a local tuple (up t q v ...) with accelerations; given (up t q v), an up tuple of 3"
   (acceleration (up 't 'q 'v)))
  (check-exn #rx"^coordinate: .*given the procedure `sin`" (lambda () (coordinate sin))))

(test-case "literal local tuples name their components"
  (check-equal? (literal-Lagrangian-state 1) (up 't 'q 'qdot))
  (check-equal? (literal-Lagrangian-state 2) (up 't (up 'q^0 'q^1) (up 'qdot^0 'qdot^1))))

(test-case "local-tuple? wants an up of at least time and coordinates"
  (for ([x (list (up 't 'q) local (vector 't 'q 'v))]) (check-true (local-tuple? x)))
  (for ([x (list (up 't) (down 't 'q) 't 3 sin '(t q v))]) (check-false (local-tuple? x))))
