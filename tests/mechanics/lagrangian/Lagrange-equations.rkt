#lang racket/base
;; Lagrange's equations as residuals: known systems, forces, higher order, and
;; what is said of bad Lagrangians and paths.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/value/compose
         mechanics/value/structure
         mechanics/calculus/derivative
         mechanics/calculus/literal-function
         mechanics/value/signature
         mechanics/lagrangian/Lagrange-equations
         mechanics/lagrangian/generalized-LE
         mechanics/lagrangian/local-tuple
         (only-in mechanics/hamiltonian/Hamiltonian make-Hamiltonian)
         (only-in mechanics/book L-free-particle L-harmonic L-central-polar)
         "../support/checks.rkt"
         "../support/messages.rkt" "../support/same.rkt" "../support/systems.rkt")

(define x (literal-function 'x))
(define y (literal-function 'y))
(define (second f) (((g:expt D 2) f) 't))
(define (residual L q) (((Lagrange-equations L) q) 't))

;; ---------------------------------------------------------------------------
;; Known systems (V2-V4)

(test-case "V2: a free particle: m ẍ, and 0 on a straight line"
  (check-same (residual (L-free-particle 'm) x) (g:* 'm (second x)))
  (check-same (residual (L-free-particle 'm) literal-plane-path)
              (down (g:* 'm (second x)) (g:* 'm (second y))))
  (check-equal? (residual (L-free-particle 'm) straight-line) (down 0 0 0)))

(test-case "V3: the harmonic oscillator, on a literal path and on a proposed solution"
  (check-same (residual (L-harmonic 'm 'k) x) (g:+ (g:* 'm (second x)) (g:* 'k (x 't))))
  (define (proposed t) (g:* 'a (g:cos (g:+ (g:* 'omega t) 'phi))))
  (define at (g:cos (g:+ (g:* 'omega 't) 'phi)))
  (check-same (residual (L-harmonic 'm 'k) proposed)
              (g:* 'a (g:- 'k (g:* 'm (g:square 'omega))) at))
  (check-same (residual (L-harmonic 'm (g:* 'm (g:square 'omega))) proposed) 0)
  (check-false (same? (residual (L-harmonic 'm 'k) proposed) 0)))

(test-case "V4: orbital motion, and the circular orbit that solves it exactly when m ω² R³ = μ"
  (define r^3 (g:expt (g:+ (g:square (x 't)) (g:square (y 't))) 3/2))
  (check-same (residual (L-orbital 'm 'mu) literal-plane-path)
              (down (g:+ (g:* 'm (second x)) (g:/ (g:* 'mu (x 't)) r^3))
                    (g:+ (g:* 'm (second y)) (g:/ (g:* 'mu (y 't)) r^3))))
  (define (circle t) (up (g:* 'R (g:cos (g:* 'omega t))) (g:* 'R (g:sin (g:* 'omega t)))))
  (check-same (residual (L-orbital 'm (g:* 'm (g:square 'omega) (g:cube 'R))) circle) (down 0 0))
  (check-false (same? (residual (L-orbital 'm 'mu) circle) (down 0 0))))

(test-case "central force in polar coordinates"
  (define r (literal-function 'r))
  (define phi (literal-function 'phi))
  (define U (literal-function 'U))
  (check-same (residual (L-central-polar 'm U) (up r phi))
              (down (g:+ (g:- (g:* 'm (second r)) (g:* 'm (r 't) (g:square ((D phi) 't))))
                         ((D U) (r 't)))
                    (g:+ (g:* 'm (g:square (r 't)) (second phi))
                         (g:* 2 'm (r 't) ((D r) 't) ((D phi) 't))))))

(test-case "a pendulum with a driven pivot (SICM p. 52)"
  (define ((L-driven m l g ys) local)
    (define t (time local))
    (define theta (coordinate local))
    (define v (velocity local))
    (g:- (g:* 1/2 m (g:+ (g:square (g:* l v)) (g:square ((D ys) t))
                         (g:* 2 ((D ys) t) l v (g:sin theta))))
         (g:* m g (g:- (ys t) (g:* l (g:cos theta))))))
  (define ys (literal-function 'y_s))
  (define theta (literal-function 'theta))
  (check-same (residual (L-driven 'm 'l 'g ys) theta)
              (g:+ (g:* 'm (g:square 'l) (second theta))
                   (g:* 'm 'l (g:+ 'g (second ys)) (g:sin (theta 't))))))

(test-case "a literal Lagrangian: the equation in full"
  (define L (literal-function 'L (Lagrangian)))
  (define local ((Gamma x) 't))
  (define (d . indices)
    ((for/fold ([f L]) ([i indices]) ((partial i) f)) local))
  (check-same (residual L x)
              (g:- (g:+ (d 2 0) (g:* (d 2 1) ((D x) 't)) (g:* (d 2 2) (second x)))
                   (d 1))))

(test-case "the path may be a structure of functions, a function to structures, or a vector"
  (define together (lambda (t) (up (x t) (y t))))
  (check-same (residual (L-orbital 'm 'mu) together)
              (residual (L-orbital 'm 'mu) literal-plane-path))
  (check-same (residual (L-orbital 'm 'mu) (vector x y))
              (residual (L-orbital 'm 'mu) literal-plane-path)))

(test-case "numbers in, numbers out"
  (check-= (((Lagrange-equations (L-harmonic 2 8)) g:cos) 0.3) (* 6 (cos 0.3)) 1e-14))

(test-case "nested coordinates: two particles, each a tuple"
  (define ((L-pair m1 m2 k) local)
    (define q (coordinate local))
    (define v (velocity local))
    (g:- (g:+ (g:* 1/2 m1 (g:square (ref v 0))) (g:* 1/2 m2 (g:square (ref v 1))))
         (g:* 1/2 k (g:square (g:- (ref q 1) (ref q 0))))))
  (define x1 (literal-function 'x1)) (define y1 (literal-function 'y1))
  (define x2 (literal-function 'x2)) (define y2 (literal-function 'y2))
  (check-same (residual (L-pair 'm1 'm2 'k) (up (up x1 y1) (up x2 y2)))
              (down (down (g:+ (g:* 'm1 (second x1)) (g:* 'k (g:- (x1 't) (x2 't))))
                          (g:+ (g:* 'm1 (second y1)) (g:* 'k (g:- (y1 't) (y2 't)))))
                    (down (g:+ (g:* 'm2 (second x2)) (g:* 'k (g:- (x2 't) (x1 't))))
                          (g:+ (g:* 'm2 (second y2)) (g:* 'k (g:- (y2 't) (y1 't))))))))

;; ---------------------------------------------------------------------------
;; Properties

(test-case "the equations are linear in the Lagrangian"
  (define L1 (L-orbital 'm 'mu))
  (define L2 (L-planar 'm (lambda (x y) (g:* x y))))
  (check-same (residual (g:+ L1 (g:* 'c L2)) literal-plane-path)
              (g:+ (residual L1 literal-plane-path) (g:* 'c (residual L2 literal-plane-path)))))

(test-case "a total time derivative adds nothing (SICM 1.6.4)"
  (define F (literal-function 'F (-> (X Real Real) Real)))
  (define (DtF local)
    (g:+ (((partial 0) F) (time local) (coordinate local))
         (g:* (((partial 1) F) (time local) (coordinate local)) (velocity local))))
  (check-same (residual DtF x) 0)
  (check-same (residual (g:+ (L-harmonic 'm 'k) DtF) x) (residual (L-harmonic 'm 'k) x)))

;; ---------------------------------------------------------------------------
;; Forces

(test-case "a force outside the potential is taken from the residual"
  (define (friction local) (g:* -1 'b (velocity local)))
  (check-same (((Lagrange-equations (L-harmonic 'm 'k) #:force friction) x) 't)
              (g:+ (g:* 'm (second x)) (g:* 'k (x 't)) (g:* 'b ((D x) 't))))
  (define (drag local) (flip (g:* -1 'b (velocity local))))
  (check-same (((Lagrange-equations (L-free-particle 'm) #:force drag) literal-plane-path) 't)
              (down (g:+ (g:* 'm (second x)) (g:* 'b ((D x) 't)))
                    (g:+ (g:* 'm (second y)) (g:* 'b ((D y) 't))))))

(test-case "a force from a potential term or from #:force is the same residual"
  (define F (literal-function 'F))
  (define (pushed local)
    (g:+ ((L-free-particle 'm) local) (g:* (F (time local)) (coordinate local))))
  (check-same (residual pushed x)
              (((Lagrange-equations (L-free-particle 'm) #:force (compose F time)) x) 't)))

(test-case "a force that is no function is refused"
  (check-exn
   #rx"^Lagrange-equations: expected a force: a function of the local tuple\n  given: the number 3"
   (lambda () (Lagrange-equations (L-free-particle 'm) #:force 3))))

(test-case "a force of the wrong orientation does not subtract"
  (check-exn
   #rx"^Lagrange-equations: the force must be a down tuple of 2, like the momenta; given [(]up .*an up tuple of 2$"
   (lambda () (((Lagrange-equations (L-free-particle 'm) #:force velocity)
                literal-plane-path) 't))))

;; ---------------------------------------------------------------------------
;; Higher order (V7)

(test-case "V7: L = -½ m x ẍ - ½ k x² is the harmonic oscillator"
  (define (L local)
    (g:- (g:* -1/2 'm (coordinate local) (acceleration local))
         (g:* 1/2 'k (g:square (coordinate local)))))
  (check-same (((Lagrange-equations L #:order 2) x) 't)
              (g:+ (g:* 'm (second x)) (g:* 'k (x 't))))
  ;; scmutils' sign: the highest derivative counts as positive
  (for ([n (in-list '(2 3))])
    (check-same (((generalized-LE L #:order n) x) 't)
                (g:* (if (even? n) -1 1) (((Lagrange-equations L #:order n) x) 't))))
  (check-same ((generalized-LE L) (up 't 'q 'v 'a 'j 's)) (g:- (g:+ (g:* 'm 'a) (g:* 'k 'q))))
  (check-same (((generalized-LE (lambda (s) (g:* 1/2 (g:square (acceleration s))))) x) 't)
              (((g:expt D 4) x) 't))
  (check-same ((generalized-LE (lambda (s) (g:* 1/2 (g:square (ref s 4)))))
               (up 't 'q 'v 'a 'j 's 'c 'p))
              'p)
  (check-equal? (format "~a" (generalized-LE (literal-function (quote L)))) "(generalized-LE L)"))

(test-case "a local tuple has an even number of components"
  (check-message
   (string-append "generalized-LE: expected a path or a local tuple of 4 or 6 or ... components: "
                  "(up t q v a)\n  given: (up t q v a j), an up tuple of 5")
   ((generalized-LE (L-free-particle 'm)) (up 't 'q 'v 'a 'j))))

(test-case "V7: the general form for an unknown Lagrangian with accelerations"
  ;; -D²(∂₃L) + D(∂₂L) - ∂₁L, along the path
  (define L (literal-function 'L (-> (UP Real Real Real Real) Real)))
  (define path (Gamma x 4))
  (define (along i) (compose ((partial i) L) path))
  (check-same (((Lagrange-equations L #:order 2) x) 't)
              (g:- (g:- ((D (along 2)) 't) (((g:expt D 2) (along 3)) 't)) ((along 1) 't))))

(test-case "an order higher than needed changes nothing"
  ;; of local tuples of any length, as the book's L-harmonic is not
  (define (L local)
    (g:- (g:* 1/2 'm (g:square (velocity local))) (g:* 1/2 'k (g:square (coordinate local)))))
  (for ([n '(2 3)])
    (check-same (((Lagrange-equations L #:order n) x) 't)
                (residual (L-harmonic 'm 'k) x))))

(test-case "third order: L = ½ (x⃛)² gives D⁶x"
  (define (L local) (g:* 1/2 (g:square (ref local 4))))
  (check-same (((Lagrange-equations L #:order 3) x) 't)
              (((g:expt D 6) x) 't))
  (check-equal? (((Lagrange-equations L #:order 3) (lambda (t) (g:expt t 6))) 2) 720))

(test-case "an order is a positive integer"
  (for ([n (list 0 -1 1.5 'n)])
    (check-exn
     #rx"^Lagrange-equations: expected an order, a positive integer"
     (lambda () (Lagrange-equations (L-free-particle 'm) #:order n)))))

;; ---------------------------------------------------------------------------
;; Bad Lagrangians and paths

(test-case "a Lagrangian that is no function"
  (check-message
   "Lagrange-equations: a Lagrangian is a function of the local tuple (up t q v); given the number 3"
   (Lagrange-equations 3))
  (check-message
   "Lagrange-equations: a Lagrangian is a function of the local tuple (up t q v); given the symbol L\n  with its quote it is only a name; the function itself is L"
   (Lagrange-equations 'L)))

(test-case "a function that is known to be a Hamiltonian"
  (define (H s) (g:square (ref s 2)))
  (check-message
   (string-append "Lagrange-equations: expected a Lagrangian; "
                  "this is known to be a Hamiltonian: H\n"
                  "  its equations of motion are (Hamilton-equations H)")
   (Lagrange-equations (make-Hamiltonian H))))

(test-case "a Lagrangian whose parameters were forgotten"
  (define (L m local) 0)
  (check-message
   (string-append
    "Lagrange-equations: a Lagrangian takes one argument, the local tuple, but L does not.\n"
    "  If it takes parameters first, supply them: (Lagrange-equations (L ...))")
   (Lagrange-equations L))
  (define (L-parametric m) (L-free-particle m))
  (check-exn
   #rx"^Lagrange-equations: the value of a Lagrangian is a number, but that of L-parametric is .*\n  was a parameter left out, as the mass in [(]L-free-particle 'm[)][?]$"
   (lambda () (residual L-parametric x))))

(test-case "a Lagrangian whose value is a tuple"
  (define (L local) (g:* 1/2 (velocity local)))
  (check-message
   "Lagrange-equations: the value of a Lagrangian is a number, but that of L is (up (* 1/2 ((D x) t)) (* 1/2 ((D y) t))), an up tuple of 2"
   (residual L literal-plane-path)))

(test-case "a path that is a symbol, a number, or a list of functions"
  (define equations (Lagrange-equations (L-free-particle 'm)))
  (check-message
   "Lagrange-equations: a path is a function of time, or a tuple of such functions; given the symbol x\n  (literal-function 'x) makes a path of that name"
   (equations 'x))
  (check-message
   "Lagrange-equations: a path is a function of time, or a tuple of such functions; given the number 3\n  a path is written (lambda (t) ...), with t where the time stands"
   (equations 3))
  (check-message
   "Lagrange-equations: a path is a function of time, or a tuple of such functions; given (x y), a list\n  a list is not a tuple; use (up x y ...)"
   (equations (list x y))))

(test-case "a path whose value is a list"
  (check-message
   "D: the function returned a value that has no derivative: (t (* 2 t)), a list\n  a list is not a tuple; use (up x y ...)"
   (residual (L-free-particle 'm) (lambda (t) (list t (g:* 2 t))))))

;; ---------------------------------------------------------------------------
;; Printing

(test-case "equations, residuals and their parts print as what was typed"
  (define (L local) 0)
  (define (friction local) 0)
  (for ([e (list (Lagrange-equations L) ((Lagrange-equations L) x)
                 (Lagrange-equations L #:force friction) (Lagrange-equations L #:order 2))]
        [text '("(Lagrange-equations L)" "((Lagrange-equations L) x)"
                "(Lagrange-equations L #:force friction)" "(Lagrange-equations L #:order 2)")])
    (check-equal? (format "~a" e) text)
    (check-equal? (format "~s" e) text)
    (check-equal? (format "~v" e) text)))

(test-case "equations keep what they were made of"
  (define L (L-free-particle 'm))
  (define e (Lagrange-equations L #:order 2))
  (check-true (equations? e))
  (check-eq? (equations-Lagrangian e) L)
  (check-equal? (list (equations-force e) (equations-order e)) '(#f 2)))
