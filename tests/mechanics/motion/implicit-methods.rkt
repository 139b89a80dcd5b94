#lang racket/base
;; Needs of implicit methods: derivatives of a system's rates, made of their own code.

(require racket/flonum
         mechanics
         (only-in mechanics/book L-pendulum)
         (only-in mechanics/motion/system/make-system make-system)
         (only-in mechanics/motion/system/parametric-system make-parametric-system)
         (only-in mechanics/motion/system/system system-make-jacobian! system-make-slope!)
         (only-in mechanics/numeric/ode/rates-with-jacobian differences differentiated)
         (only-in mechanics/numeric/ode/integrate integrate)
         (only-in mechanics/numeric/ode/radau radau-iia-5)
         (only-in mechanics/value/shape structure->flvector flvector->structure shape-length)
         "../support/checks.rkt")

(define (random-vector n) (for/flvector #:length n ([_ (in-range n)]) (+ 0.2 (random))))

;; The derivatives by the system are those of D, at random states.
(define (check-derivatives s f example)
  (define n (shape-length example))
  (define J (make-flvector (* n n)))
  (define jacobian! ((system-make-jacobian! s)))
  (for ([_ (in-range 3)])
    (define v (random-vector n))
    (jacobian! v J)
    (define expected (structure->flvector ((D f) (flvector->structure example v)) raise))
    (for ([x (in-flvector J)] [y (in-flvector expected)])
      (check-= x y (* 1e-9 (+ 1 (abs y)))))))

(define (flat-state n) (up 0.0 (vector->up (make-vector n 0.3)) (vector->up (make-vector n 0.1))))

;; A chain of n links, each a point mass at its end
(define ((L-chain n) s)
  (define-values (q v) (values (coordinate s) (velocity s)))
  (for/fold ([L 0] [y 0] [vx 0] [vy 0] #:result L) ([k (in-range n)])
    (define-values (a w) (values (ref q k) (ref v k)))
    (define-values (height along up) (values (- y (cos a)) (+ vx (* w (cos a)))
                                             (+ vy (* w (sin a)))))
    (values (+ L (- (* 1/2 (+ (square along) (square up))) (* 9.8 height))) height along up)))

(define ((van-der-pol mu) (up t x v)) (up 1 v (- (* mu (- 1 (square x)) v) x)))

(random-seed 41)

(test-case "the derivatives of a system are those of D"
  (define (check-plain f example) (check-derivatives (make-system 'test f example) f example))
  (check-plain (van-der-pol 3) (up 0 1 1))
  (check-plain (Lagrangian->state-derivative (L-pendulum 9.8 1 2)) (up 0 1 1))
  (check-plain (lambda (s) (up (sin (ref s 1)) (* (ref s 0) (exp (ref s 1))))) (up 1 2))
  (for ([n '(2 7)])                     ; the other way to the rates begins with six coordinates
    (check-plain (Lagrangian->state-derivative (L-chain n)) (flat-state n))))

(test-case "by the state, not by the parameters"
  (define ((f a b) s)
    (up 1 (* a (ref s 1) (ref b 0)) (* (ref s 0) (expt (ref s 1) (ref b 1)))))
  (for ([a (list 2 0.3)])
    (define s (make-parametric-system 'test f (list a (up 1.5 2.5)) (up 0 1 1)))
    (check-derivatives s (f a (up 1.5 2.5)) (up 0 1 1))))

(test-case "of rates that decide there are differences only"
  (check-false ((system-make-jacobian!
                 (make-system 'test (lambda (s) (up 1 (if (< (ref s 1) 0) 1 2))) (up 0 1))))))

;; The end of a motion, by an implicit method and by an explicit one
(define (check-methods-agree f start end tolerance difference)
  (define (final method)
    (structure->flvector
     (trajectory-final-state
      (evolve-trajectory f start end #:tolerance tolerance #:method method))
     raise))
  (for ([x (in-flvector (final 'Radau-IIA-5))] [y (in-flvector (final 'Dormand-Prince-853))])
    (check-= x y difference)))

(test-case "a long chain is no burden"
  (define n 20)
  (define f (Lagrangian->state-derivative (L-chain n)))
  (define start (up 0.0 (vector->up (make-vector n 1.0)) (vector->up (make-vector n 0.0))))
  (check-methods-agree f start 1/2 1e-8 1e-6))

(test-case "where derivatives would be a very long list, there are differences"
  (define f (Lagrangian->state-derivative (L-chain 90)))
  (define start (flat-state 90))
  (check-false ((system-make-jacobian! (make-system 'test f start))))
  (check-methods-agree f start 1/50 1e-7 1e-5))

;; ---------------------------------------------------------------------------
;; Stiff systems

(define (stiff-final f start end tolerance)
  (trajectory-final-state
   (evolve-trajectory f start end #:tolerance tolerance #:method 'Radau-IIA-5)))

;; Values of Hairer and Wanner's test set
(test-case "van der Pol's oscillator, and Robertson's reactions"
  (define end (stiff-final (van-der-pol 1000) (up 0 2 0) 2000 1e-9))
  (check-= (ref end 1) 1.7061677321704833 1e-8)
  (check-= (ref end 2) -8.928097010248257e-4 1e-10)
  (define (reactions s)
    (define-values (a b c) (values (ref s 1) (ref s 2) (ref s 3)))
    (define-values (slow fast back) (values (* 0.04 a) (* 3e7 b b) (* 1e4 b c)))
    (up 1 (- back slow) (- slow back fast) fast))
  (define mixture (stiff-final reactions (up 0 1 0 0) 40 1e-9))
  (for ([x (list (ref mixture 1) (ref mixture 2) (ref mixture 3))]
        [y '(0.7158270687193941 0.9185534764557338e-5 0.2841637457458413)])
    (check-= x y (* 1e-7 (abs y)))))

;; A mass on a damped spring that swings; the stiffer the spring, the nearer to a pendulum.
(define ((L-spring-pendulum k g) (up t (up r theta) (up rdot thetadot)))
  (+ (* 1/2 (+ (square rdot) (square (* r thetadot))))
     (* g r (cos theta))
     (* -1/2 k (square (- r 1)))))
(define ((loss c) s) (* 1/2 c (square (ref (velocity s) 0))))
(define (spring-pendulum k c) (Lagrangian->state-derivative (L-spring-pendulum k 9.8) (loss c)))

(test-case "a spring pendulum whose spring is stiff"
  (define start (up 0 (up 1 1) (up 0 0)))
  (define mild (spring-pendulum 1e4 1e3))
  (define other
    (trajectory-final-state (evolve-trajectory mild start 3 #:tolerance 1e-11
                                               #:method 'Dormand-Prince-853)))
  (define one (stiff-final mild start 3 1e-9))
  (for ([x (in-flvector (structure->flvector one raise))]
        [y (in-flvector (structure->flvector other raise))])
    (check-= x y 1e-7))
  (define tr (evolve-trajectory (spring-pendulum 1e10 1e8) start 3 #:tolerance 1e-7
                                #:method 'Radau-IIA-5))
  (define rigid
    (trajectory-final-state (evolve-trajectory (Lagrangian->state-derivative (L-pendulum 9.8 1 1))
                                               (up 0 1 0) 3)))
  (check-= (ref (coordinate (trajectory-final-state tr)) 1) (coordinate rigid) 1e-6)
  (check-true (< (length (trajectory-states tr)) 300)))

;; ---------------------------------------------------------------------------
;; Work

;; -> the state at the end, how many evaluations of the rates and of their derivatives
(define (count-work f start end tolerance exact?)
  (define s (make-system 'test f start))
  (define n (shape-length start))
  (define slope! ((system-make-slope! s)))
  (define-values (evaluations derivatives) (values 0 0))
  (define (rates! y dy)
    (set! evaluations (+ evaluations 1))
    (slope! y dy))
  (define jacobian! (if exact? ((system-make-jacobian! s)) (differences rates! n)))
  (define-values (t y)
    (integrate radau-iia-5
               (differentiated rates! (lambda (y J)
                                        (set! derivatives (+ derivatives 1))
                                        (jacobian! y J)))
               (structure->flvector start raise) 0.0 end #:tolerance tolerance
               #:visit void))
  (values y evaluations derivatives))

(test-case "the same motion as by differences, for fewer evaluations"
  (for ([f (list (van-der-pol 1000) (spring-pendulum 1e6 1e4))]
        [start (list (up 0 2 0) (up 0 (up 1 1) (up 0 0)))]
        [end '(2000.0 3.0)])
    (define-values (y rates derivatives) (count-work f start end 1e-8 #t))
    (define-values (z rates* derivatives*) (count-work f start end 1e-8 #f))
    (for ([a (in-flvector y)] [b (in-flvector z)]) (check-= a b 1e-6))
    (check-true (< rates rates*) (format "~a, ~a" rates rates*))
    (check-true (<= derivatives (* 1.1 derivatives*)) (format "~a, ~a" derivatives derivatives*))))

;; ---------------------------------------------------------------------------
;; Changes and failures

(test-case "a variable that was set anew is noticed, and another parameter"
  (define k 1e4)
  (define (honey s) (up 1 (ref s 2) (- (* -1 (sin (ref s 1))) (* k (ref s 2)))))
  (define (fallen f) (ref (stiff-final f (up 0 1 0) 100 1e-9) 1))
  (define (expected k) (* 2 (atan (* (tan 0.5) (exp (- (/ 100 k)))))))
  (for ([value '(1e4 1e3 1e4)])
    (set! k value)
    (check-= (fallen honey) (expected k) 1e-4))
  (define ((with k g) s) (up 1 (ref s 2) (- (* -1 g (sin (ref s 1))) (* k (ref s 2)))))
  (for ([k '(1e4 1e3)])
    (check-= (ref ((state-advancer with k 1) (up 0 1 0) 100 1e-9 #:method 'Radau-IIA-5) 1)
             (expected k)
             1e-4)))

(struct spilled (where))

(test-case "what the rates raise reaches their author, with or without code"
  (define (raising s)
    (define x (ref s 1))
    (when (and (real? x) (> x 1.5)) (raise (spilled x)))
    (up 1 x))
  (check-exn spilled? (lambda () (stiff-final raising (up 0 1) 1 1e-8)))
  (check-exn #rx"no inertia"
             (lambda ()
               (define (L s) (* 1/2 (square (ref (velocity s) 0))))
               (stiff-final (Lagrangian->state-derivative L) (up 0 (up 1 1) (up 0 0)) 1 1e-8))))

;; ---------------------------------------------------------------------------
;; Symplectic methods

(test-case "Gauss–Legendre methods follow stiff systems, by the same derivatives"
  (define (stiff s) (up 1 (velocity s) (* -1e6 (coordinate s))))
  (define L (L-spring-pendulum 1e8 9.8))
  (define E (Lagrangian->energy L))
  (for ([make (list Gauss-Legendre-2 Gauss-Legendre-4 Gauss-Legendre-6)])
    (define end
      (trajectory-final-state (evolve-trajectory stiff (up 0 1 0) 10 #:method (make 0.1))))
    (check-= (+ (square (coordinate end)) (* 1e-6 (square (velocity end)))) 1 1e-10)
    (define start (up 0 (up (+ 1 (* 9.8e-8 (cos 1))) 1) (up 0 0)))
    (define tr
      (evolve-trajectory (Lagrangian->state-derivative L) start 5 #:method (make 0.01)))
    (check-= (E (trajectory-final-state tr)) (E start) 1e-3)
    (define rigid (evolve-trajectory (Lagrangian->state-derivative (L-pendulum 9.8 1 1))
                                     (up 0 1 0) 5))
    (check-= (ref (coordinate (tr 5)) 1) (coordinate (rigid 5)) 1e-3)))
