#lang racket/base
;; The values of which it is kept how they are typeset, each with a label.

(require mechanics)

(provide values-to-typeset)

(define (labelled data)
  (for/list ([d (in-list data)]) (cons (format "~s" d) (read-expression d))))

(define-syntax-rule (programs expression ...)
  (list (cons (format "~s" 'expression) expression) ...))

(define expressions
  (labelled
   '(;; names
     m theta theta_1 thetadot thetadot_1 xdotdot xdotdotdot v^x_r p_phi omega0 omega_12 mass
     a-very-long-name-of-a-moment-of-inertia_principal Gamma Delta_max x_max :pi pi GMm lambda
     ;; names with odd characters
     |a b| |</mi><script>| |\\input{x}| |$| |a_{b}^c%#&~| |"quoted"| |x->y| || |#| |\u1b[31m|
     ;; numbers
     0 -1 12 1/2 3/7 -22/7 1.5 -0.5 6.67e-11 1e22 -1e-300 1+2i 0-3/2i
     ;; sums and products
     (+ a b) (- a b) (- (+ a b) (- c d)) (* -1 (+ a b)) (+ (* -1 a) b) (* 1/2 m (expt xdot 2))
     (* 3/7 m (sqrt x)) (* (+ a b) (- c d) 2) (* (sin x) k (+ a b) 3) (* a (* b (+ c d)))
     ;; quotients
     (/ a b) (/ (/ a b) (/ c d)) (/ (+ a b) (* 2 c)) (* a (expt b -1)) (* 1/2 (expt x -1))
     (/ (+ a (/ b (+ c (/ d e)))) f) (/ -1 (sqrt (+ 1 (expt x 2))))
     ;; powers and roots
     (expt x 2) (expt x -2) (expt x 1/2) (expt x -3/2) (expt x n) (expt x (* -1 n))
     (expt (expt x 2) n) (expt (+ a b) 2) (expt (* -1 x) 3) (expt (/ a b) 3) (expt 2 1/2)
     (sqrt 2) (sqrt (+ 1 (sqrt (+ 1 (sqrt x))))) (sqrt (/ a b)) (expt v^x_r 2) (expt (sqrt x) 3)
     ;; functions
     (sin theta) (expt (sin theta) 2) (cos (+ theta phi)) (/ (sin theta) (cos theta))
     (* (sin theta) (cos phi)) (exp (* -1 gamma t)) (exp (/ x y)) (expt (exp x) 2) (abs (- a b))
     (log (/ a b)) (atan y x) (expt (cos (* 2 x)) n) (asin x) (cosh (sqrt x))
     ;; unknown functions
     (x t) ((D x) t) (((expt D 2) x) t) (((expt D 3) x) t) (((expt D 4) x) t) ((D x) s)
     ((D xdot) t) (expt ((D theta) t) 2) (((partial 1) F) x y)
     (((* (partial 0) (expt (partial 1) 2)) F) x y) (((partial 1 0) F) (up t (up x y)))
     (((* (partial 0 1) (partial 1)) H) (up x (down p q)) y)
     (f (up) (down a) (up (up 1 2) (down 3)))
     ((D p_x) t) ((D v^x) t) (((expt D 2) theta_1) t)
     (expt ((D f) x) 2) (expt (((partial 0) F) x y) 3)
     ((D f) (g s))
     ;; functions beside what they do not hold
     (* (sin x) (f x)) (* (sin theta) ((D x) t)) (* (expt (cos x) 2) (f x) (sin y))
     (* (sin x) (up a b))
     ;; structures
     (up) (down) (up x) (down x) (up a b) (down a b) (up (down a b) (down c d))
     (up t (up x y) (down p_x p_y)) (up (/ a b) (sqrt (/ 1 x)))
     (matrix-by-rows (list 1 a) (list 0 (/ 1 b)))
     (up (down (matrix-by-rows (list 1 2) (list 3 4)) 0) (matrix-by-rows (list x)))
     ;; long
     (+ aaaaaaaaaa bbbbbbbbbb (* -1 cccccccccc) dddddddddd eeeeeeeeee ffffffffff gggggggggg
        (/ hhhhhhhhhh iiiiiiiiii))
     (* k (+ aaaaaaaaaa bbbbbbbbbb (* -1 cccccccccc) dddddddddd eeeeeeeeee ffffffffff gggggggggg))
     (/ (+ aaaaaaaaaa bbbbbbbbbb (* -1 cccccccccc) dddddddddd eeeeeeeeee ffffffffff gggggggggg)
        (+ 1 x))
     (* aaaaaaaaaa bbbbbbbbbb cccccccccc dddddddddd eeeeeeeeee ffffffffff gggggggggg hhhhhhhhhh)
     (sqrt (+ aaaaaaaaaa bbbbbbbbbb cccccccccc dddddddddd eeeeeeeeee ffffffffff gggggggggg))
     (down (+ aaaaaaaaaa bbbbbbbbbb cccccccccc) (+ dddddddddd eeeeeeeeee ffffffffff)
           (- gggggggggg hhhhhhhhhh)))))

(define (L-central local)
  (define-values (r v) (values (coordinate local) (velocity local)))
  (- (* 1/2 'm (+ (square (ref v 0)) (square (* (ref r 0) (ref v 1))))) (/ 'GMm (ref r 0))))
(define polar (up (literal-function 'r) (literal-function 'phi)))
(define (L-harmonic local)
  (- (* 1/2 'm (square (velocity local))) (* 1/2 'k (square (coordinate local)))))
(define (L-ring local)
  (define-values (theta rate) (values (coordinate local) (velocity local)))
  (+ (* 1/2 'm (square 'R) (+ (square rate) (square (* 'Omega (sin theta)))))
     (* 'm 'g 'R (cos theta))))
(define (L-two-springs local)
  (define q (coordinate local))
  (- (* 1/2 (square (velocity local)))
     (+ (* 'a (square (ref q 0))) (* 'b (square (ref q 1))))))
(define x (literal-function 'x))
(define F (literal-function 'F (-> (UP Real Real) Real)))

(define others
  (programs
   (simplify (((Lagrange-equations L-central) polar) 't))
   (expand (expt (+ 'a 'b 'c) 6))
   x F (D x) ((expt D 2) x) D (partial 1 0) (+ D 1) (* (+ D 1) (- D x)) (exp (* 'eps D))
   (+ x sin) (compose x sin) sin (lambda (a) a) (up sin x)
   (power-series 1 'x 0 (/ 1 'a)) (series 'a 'b) (sin (power-series 0 1))
   (quaternion 1 'a (- 'b) 0)
   '(> m 0) (list 1 (list 'a (/ 'b 'c)))
   (verify-equal (sin 'x) (cos 'x)) (verify-equal (sqrt (square 'x)) 'x)
   (verify-conserved L-central (lambda (l) (ref (velocity l) 0))
                     (up 't (up 'r 'phi) (up 'rdot 'phidot)))
   (verify-solution L-harmonic (lambda (t) (* 'a (cos (* (sqrt (/ 'k 'm)) t)))))
   (equilibria (lambda (l) (+ (* 1/2 (square (velocity l))) (cos (coordinate l))))
               (up 't 'theta 'thetadot))
   (equilibrium-stability L-harmonic 0)
   (normal-modes L-harmonic 0)
   (equilibria L-ring (up 't 'theta 'thetadot)) (equilibrium-stability L-ring 0)
   (equilibrium-stability L-two-springs (up 0 0))
   (event (lambda (s) (coordinate s)) #:name 'landing)
   (compare-Lagrangians L-harmonic (lambda (l) (* 2 (L-harmonic l))) (up 't 'x 'xdot))
   "text" #t (void)))

(define values-to-typeset (append expressions others))
