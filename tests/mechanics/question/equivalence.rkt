#lang racket/base
;; Lagrangians with equivalent equations: the same, proportional, combined, or not.

(require mechanics
         (only-in mechanics/book L-harmonic)
         (only-in mechanics/generic/value-tree value->tree)
         (only-in mechanics/show/typesetting/drawn-text tree->text)
         "../support/checks.rkt" "../support/messages.rkt" "../support/random.rkt")

(define line (up 't 'x 'v))
(define plane (up 't (up 'x 'y) (up 'vx 'vy)))

(define (text x) (format "~a" x))

(test-case "a total time derivative added"
  (define f (* time (compose square coordinate)))
  (define L (L-harmonic 'm 'k))
  (define e (compare-Lagrangians L (+ L (Dt f)) line))
  (check-eq? (equivalence-kind e) 'total-derivative)
  (check-eqv? (equivalence-factor e) 1)
  (check-equal? (expression (equivalence-gauge e)) '(* t (expt x 2)))
  (check-equal? (text e) (string-append "equivalent: the second is the first, plus "
                                        "the total time derivative of\n  (* t (expt x 2))"))
  (check-equal? (text (compare-Lagrangians L L line)) "equivalent: the second is the first"))

(test-case "one without a formula for its integral"
  (define L (L-harmonic 'm 'k))
  (define (F (up t x v)) (* (exp (square x)) v))
  (define e (compare-Lagrangians L (+ L F) line))
  (check-false (equivalence-gauge e))
  (check-equal? (text e) "equivalent: the second is the first, plus a total time derivative")
  ;; typeset as well
  (for ([c '(1 2)])
    (define e (compare-Lagrangians L (+ (* c L) F) line))
    (check-equal? (tree->text (value->tree e #t)) (text e))))

(test-case "a constant factor, and a total time derivative as well"
  (define L (L-harmonic 'm 'k))
  (define e (compare-Lagrangians L (+ (* 'c L) (Dt (compose sin coordinate))) line))
  (check-eq? (equivalence-kind e) 'proportional)
  (check-eqv? (equivalence-factor e) 'c)
  (check-equal? (expression (equivalence-gauge e)) '(sin x))
  (check-pred proved? (equivalence-verdict e))
  (check-equal? (text (compare-Lagrangians L (* 2 L) line))
                "equivalent: the second is 2 times the first"))

(test-case "equations that are combined: a matrix, a growing factor, a factor of the state"
  (define (L (up t (up x y) (up vx vy)))
    (- (* 1/2 (+ (square vx) (square vy))) (* 1/2 'k (+ (square x) (square y)))))
  (define (L-crossed (up t (up x y) (up vx vy))) (- (* vx vy) (* 'k x y)))
  (define e (compare-Lagrangians L L-crossed plane))
  (check-eq? (equivalence-kind e) 'combination)
  (check-equal? (expression (equivalence-factor e)) '(matrix-by-rows (list 0 1) (list 1 0)))
  (define (L-growing local) (* (exp (* 'b (time local))) ((L-harmonic 'm 'k) local)))
  (check-pred refuted? (verify-equivalent-Lagrangians (L-harmonic 'm 'k) L-growing line))
  (define (L-square (up t x v))
    (+ (* 1/12 (square 'm) (expt v 4))
       (* 1/2 'm 'k (square v) (square x))
       (* -1/4 (square 'k) (expt x 4))))
  (define by-energy (compare-Lagrangians (L-harmonic 'm 'k) L-square line))
  (check-equal? (expression (equivalence-factor by-energy)) '(+ (* k (expt x 2)) (* m (expt v 2)))))

(test-case "the damped oscillator, in a coordinate that grows against the damping"
  (define ((L-damped b) (up t x v))
    (* (exp (* b t)) (- (* 1/2 (square v)) (* 1/2 'k (square x)))))
  (define ((L-slow b) (up t y w))        ; x = e^{-bt/2} y
    (- (* 1/2 (square w)) (* 1/2 (- 'k (* 1/4 (square b))) (square y))))
  (define (slow->x (up t y w)) (* (exp (* -1/2 'b t)) y))
  (define L (compose (L-damped 'b) (F->C slow->x)))
  (define e (compare-Lagrangians (L-slow 'b) L line))
  (check-eq? (equivalence-kind e) 'total-derivative)
  (check-equal? (expression (equivalence-gauge e)) '(* -1/4 b (expt x 2))))

(test-case "not equivalent, with a witness, and the condition under which it would be"
  (define e (compare-Lagrangians (L-harmonic 'm 'k) (L-harmonic 1 (square 'omega)) line))
  (check-false (equivalence-kind e))
  (check-equal? (map expression (verdict-conditions (equivalence-verdict e)))
                '((= k (* m (expt omega 2)))))
  (check-true (pair? (verdict-witness (equivalence-verdict e))))
  (check-regexp-match
   #rx"^not equivalent: motions of one Lagrangian leave a residual of the other\nrefuted: "
   (text e)))

(test-case "Lagrangians without inertia in some direction"
  (define (L (up t (up x y) (up vx vy))) (- (* 1/2 (square vx)) (* 1/2 (square (- x y)))))
  (define (L-solved (up t (up x y) (up vx vy))) (* vx (- x y)))
  (define (L-free (up t q v)) (* 1/2 (square v)))
  (define (mixed (up t (up x y) (up vx vy)))
    (+ (* 3 (L (up t (up x y) (up vx vy)))) (* x vy) (* y vx)))
  (check-eq? (equivalence-kind (compare-Lagrangians L mixed plane)) 'proportional)
  ;; both restrict states, the one to x = y and the other to rest
  (check-exn #rx"^compare-Lagrangians: the equations of both Lagrangians restrict"
             (lambda () (compare-Lagrangians L L-solved plane)))
  (for ([other (list L-free (lambda (local) 0))])
    (check-pred refuted? (verify-equivalent-Lagrangians L other plane))
    (check-pred refuted? (verify-equivalent-Lagrangians other L plane))))

(test-case "a Galilean transformation leaves the free particle's equations (exercise 1.29)"
  (define (L (up t q v)) (* 1/2 'm (square v)))
  (define (moving (up t (up x y) v)) (up (+ x (* 'V t)) (+ y 'b)))
  (define e (compare-Lagrangians L (compose L (F->C moving)) plane))
  (check-eq? (equivalence-kind e) 'total-derivative)
  (check-equal? (expression (equivalence-gauge e)) '(+ (* 1/2 (expt V 2) m t) (* V m x)))
  (define (turning (up t q v)) (* (Rz2 (* 'Omega t)) q))
  (define (Rz2 angle) (down (up (cos angle) (sin angle)) (up (* -1 (sin angle)) (cos angle))))
  (check-pred refuted? (verify-equivalent-Lagrangians L (compose L (F->C turning)) plane)))

(test-case "random total time derivatives change no equation, and other terms do"
  (with-seed 1428
    (for ([_ (in-range 10)])
      (define (factor)
        (define wave (random-choice sin cos exp square))
        (define argument (random-choice time coordinate (* 'a time coordinate)))
        (compose wave argument))
      (define f (* (random-rational) (factor) (factor)))
      (define c (random-rational))
      (define L (L-harmonic 'm 'k))
      (check-pred proved? (verify-equivalent-Lagrangians L (+ (* c L) (Dt f)) line))
      (check-pred refuted?
                  (verify-equivalent-Lagrangians L (+ L (Dt f) (compose square velocity)) line)))))

(define L (L-harmonic 'm 'k))

(says
 [(compare-Lagrangians L 3 line)
  "compare-Lagrangians: a Lagrangian is a function of the local tuple (up t q v); given the number 3"]
 [(verify-equivalent-Lagrangians L L (up 0 'x 'v))
  "verify-equivalent-Lagrangians: the local tuple must be made of symbols, each there once, "
  "to stand for any state\n  given: (up 0 x v)\n  no symbol: 0"])

;; They are total derivatives, of |x| and x |x|/2, but at x = 0, of which the equations do not tell.
(test-case "kinks of the difference are none of a proof, those that both have are"
  (define (L s) (* 1/2 (square (velocity s))))
  (define ((with-more f) s) (+ (L s) (f s)))
  (for ([f (list sgn abs)] [sort '(jump kink)])
    (define v (verify-equivalent-Lagrangians
               L (with-more (lambda (s) (* (f (coordinate s)) (velocity s)))) line))
    (check-pred undecided? v)
    (check-equal? (map car (verdict-kinks v)) (list sort)))
  (check-pred proved?
              (verify-equivalent-Lagrangians
               (with-more (compose abs coordinate))
               (with-more (+ (compose abs coordinate) velocity))
               line))
  ;; where L has no real value there are no motions
  (define fenced (with-more (lambda (s) (log (coordinate s)))))
  (for ([x0 '(-1 1)] [fine? (list proved? undecided?)])
    (define (jump s) (* (sgn (- (coordinate s) x0)) (velocity s)))
    (check-pred fine? (verify-equivalent-Lagrangians fenced (+ fenced jump) line))))
