#lang racket/base
;; A condition of a verdict imposed: on values and functions, and on the question itself.

(require mechanics
         (only-in mechanics/book L-harmonic L-pendulum L-rotating-polar L-uniform-acceleration)
         "../support/checks.rkt" "../support/messages.rkt"
         (only-in "../support/systems.rkt" L-Foucault))

(define (oscillation t) (* 'a (cos (+ (* 'omega t) 'phi))))
(define v (verify-solution (L-harmonic 'm 'k) oscillation))
(define condition '(= k (* m (expt omega 2))))
(define line (up 't 'x 'v))
(define polar (up 't (up 'r 'phi) (up 'rdot 'phidot)))

;; ---------------------------------------------------------------------------
;; On values

(test-case "on expressions, tuples, matrices and lists of them"
  (check-equal? (impose (* 'k 'x) '(= k 3)) (* 3 'x))
  (check-equal? (impose (up 'k (down 'x 2.5)) '(= k 3)) (up 3 (down 'x 2.5)))
  (check-equal? (impose (matrix-by-rows '(k 1) '(1 k)) '(= k 3)) (matrix-by-rows '(3 1) '(1 3)))
  (check-equal? (impose '(> k 0) '(= k 3)) '(> 3 0))
  (check-equal? (impose ((literal-function 'V) 'k) '(= k 3)) ((literal-function 'V) 3))
  (check-equal? (simplify (impose (verdict-residual v) v)) 0))

(test-case "a condition is an equation, several, or a verdict"
  (define same (* 'm (square 'omega)))
  (for ([c (list condition (list condition) v (verdict-conditions v)
                 (car (verdict-alternatives v)) (read-expression "(= k (* m (expt omega 2)))"))])
    (check-equal? (simplify (impose 'k c)) (simplify same)))
  (check-equal? (impose (+ 'k 'b) '((= k (* b c)) (= b 2))) (+ (* 2 'c) 2)))

(test-case "what stands left need not be a symbol"
  (check-equal? (impose 'm '(= (* m v) p)) (/ 'p 'v))
  (check-equal? (impose (+ 1 (sin 'beta)) '(= (sin beta) 0)) 1)
  (check-equal? (impose (+ 1 'nu) '(= (* 2 :pi nu) 0)) 1))

;; ---------------------------------------------------------------------------
;; On functions

(test-case "on a Lagrangian and on a path, as on their values"
  (define L (impose (L-harmonic 'm 'k) condition))
  (check-equal? (simplify (L line))
                (simplify ((L-harmonic 'm (* 'm (square 'omega))) line)))
  (check-pred proved? (verify-solution L oscillation))
  (check-pred proved? (verify-solution (impose (L-harmonic 'm 'k) v) (impose oscillation v)))
  (check-pred refuted? (verify-solution (impose (L-harmonic 'm 'k) '(= k m)) oscillation)))

(test-case "on tuples of functions, functions of functions, and literal functions"
  (define f (impose (up (lambda (t) (* 'a t)) (literal-function 'x)) '(= a 2)))
  (check-equal? (f 't) (up (* 2 't) ((literal-function 'x) 't)))
  (check-equal? (((impose (lambda (x) (lambda (y) (* 'a x y))) '(= a 2)) 'u) 'v) (* 2 'u 'v)))

(test-case "derivatives of every sort see the condition"
  (define (f x) (* 'k (expt x 3)))
  (define g (impose f '(= k (* 2 c))))
  (check-equal? (simplify ((D g) 'x)) (simplify (* 6 'c (square 'x))))
  (check-equal? (simplify (((expt D 2) g) 'x)) (simplify (* 12 'c 'x)))
  (check-equal? (simplify ((gradient g) 'x)) (simplify (* 6 'c (square 'x))))
  (define (h p) (sin (* 'k (ref p 0) (ref p 1))))
  (check-equal? (simplify ((gradient (impose h '(= k 2))) (up 'x 'y)))
                (simplify ((gradient (lambda (p) (sin (* 2 (ref p 0) (ref p 1))))) (up 'x 'y))))
  (check-equal? ((D (lambda (k) ((impose (lambda (x) (* 'c k x)) '(= c 3)) 'x))) 2) (* 3 'x)))

(test-case "a function with a condition is numeric where that leaves numbers"
  (check-equal? ((impose (lambda (x) (* 'm x)) '(= m 2)) 3) 6)
  (check-equal? (format "~a" (impose sin '(= m 2))) "(impose sin ((= m 2)))"))

;; ---------------------------------------------------------------------------
;; The question again

(define (momentum (up t (up r phi) (up rdot phidot))) (* 'm (square r) phidot))
(define ((L-free m) (up t q v)) (* 1/2 m (square v)))
(define circle (holonomic (lambda (t q) (- (square q) (square 'R)))))
(define (damped t) (* (exp (* -1 'gamma t)) (cos (* 'omega t))))

;; The verdicts of the book's text, of the examples and of the manual that name conditions.
(define verdicts
  (list
   v
   (prove-zero (* 'a (- 'k (* 'm (square 'omega)))))
   (prove-zero (* 'c (- 'k 'm) (- 'a 'b)))
   (prove-zero (up (- 'a 'b) (- 'b 'a)))
   (prove-zero (- (* 'k 'x) (* 'm (square 'omega) 'x)) #:variables '(x))
   (verify-equal (lambda (t) (* 'a (sin t))) (lambda (t) (* 'b (sin t))))
   (verify-solution (L-harmonic 'm 'k) damped
                    #:force (lambda (local) (* -1 'b (velocity local))))
   (verify-solution (L-harmonic 'm 'k) (lambda (t) (* 'A t)))
   (verify-solution (L-uniform-acceleration 'm 'g) (lambda (t) (up (* 'a t) (* 'b t))))
   (verify-solution (L-free 'm) (lambda (t) (+ (* 'b t) (* 'c t t))))
   (verify-solution (L-free 'm) (lambda (t) (* 1/2 'a (square t)))
                    #:force (lambda (local) (* 'm 'g)))
   (verify-solution (L-Foucault 'm 'k 'Omega 'beta)
                    (lambda (t)
                      (* 'a (cos (* 'w t)) (up (cos (* 'p t)) (sin (* 'p t))))))
   (verify-solution (L-free 'm) (lambda (t) (up (* 'S (cos t)) (* 'S (sin t))))
                    #:constraints circle)
   (verify-conserved (L-Foucault 'm 'k 'Omega 'beta)
                     (lambda (local)
                       (define q (coordinate local))
                       (define w (velocity local))
                       (- (* (ref q 0) (ref w 1)) (* (ref q 1) (ref w 0))))
                     (up 't (up 'x 'y) (up 'vx 'vy)))
   (verify-conserved (L-rotating-polar 'm 'Omega) momentum polar)
   (verify-conserved (L-pendulum 'g 'm 'l) velocity line)
   (verify-conserved (L-harmonic 'm 'k) (Lagrangian->energy (L-harmonic 'm 'k)) line
                     #:force (lambda (l) (* -1 'b (velocity l))))
   (verify-ignorable (L-harmonic 'm 'k) 'x line)
   (verify-equilibrium (L-pendulum 'g 'm 'l) 'theta)))

(test-case "under each of its choices what a verdict was asked is proved"
  (define judged
    (for*/sum ([v verdicts] [way (verdict-alternatives v)])
      (with-check-info (['verdict v] ['way way])
        (check-pred proved? (verify-again v way)))
      1))
  (check-true (>= judged 19) (format "~a" judged)))

(test-case "without a condition it is the first of them"
  (check-pred proved? (verify-again v))
  (check-equal? (verdict-residual (verify-again v)) 0))

(test-case "the new verdict tells its condition"
  (check-equal? (format "~a" (verify-again v))
                (string-append "proved: the residual is zero\n"
                               "  note: under the condition k = (* m (expt omega 2))"))
  (check-equal? (verdict-remarks (verify-again v '((= k 2) (= m 1))))
                '("under the condition k = 2, m = 1")))

(test-case "of two roots it tells which is taken"
  (define w (prove-zero (- 'x 2)))
  (check-equal? (verdict-remarks (verify-again w '(= (expt x 2) 4)))
                '("under the condition (expt x 2) = 4, with x = 2"))
  (check-equal? (verdict-remarks (verify-again w '((= m 1) (= (* m (expt x 2)) k))))
                '("under the condition m = 1, (* m (expt x 2)) = k, with x = (sqrt k)"))
  (check-equal? (verdict-remarks (verify-again w '(= (expt x 2) 0)))
                '("under the condition (expt x 2) = 0")))

(test-case "under another condition the answer is what that makes it"
  (check-pred refuted? (verify-again v '(= k m)))
  (check-equal? (verdict-alternatives (verify-again v '(= k (* c m))))
                '(((= c (expt omega 2)))))
  (check-pred proved? (verify-again v '((= k (* c m)) (= c (expt omega 2))))))

(test-case "what was declared is known of what takes the place of a symbol"
  (define w
    (assuming ('(> k 0))
      (prove-zero (* (- 'k 'n) (- (sqrt (square 'k)) 'c)))))
  (define again (verify-again w '(= c n)))
  (check-not-false (member '(> k 0) (verdict-assumptions again)))
  (define y (assuming ('(> c 0)) (prove-zero (- (abs 'c) (* 'd 'a)))))
  (check-equal? (verdict-assumptions (verify-again y '((= c (* d a)))))
                '((> (* d a) 0))))

(test-case "what was declared may contradict the condition"
  (define w (assuming ('(> k 0)) (prove-zero (- (sqrt (square 'k)) 'c))))
  (check-message "verify-again: the relation cannot hold: (> -1 0)" (verify-again w '(= k -1)))
  (check-equal? (verdict-alternatives (verify-again w '(= k 3))) '(((= c 3)))))

(test-case "a condition that makes a kink leaves the question open"
  (define w (verify-solution (L-free 'm) (lambda (t) (+ (* 'c (square t)) (abs (- t 'b))))))
  (check-false (proved? (verify-again w '(= c 0)))))

;; ---------------------------------------------------------------------------
;; Mistakes

(define proved (prove-zero 0))

(says
 [(impose 'k proved)
  "impose: the verdict names no condition: what was asked is proved\n  verdict: proved"]
 [(verify-again (prove-zero (+ 1 (square 'x))))
  "verify-again: the verdict names no condition\n  verdict: refuted"]
 [(verify-again 3) "verify-again: expected a verdict, then perhaps a condition\n"
  "  given: the number 3"]
 [(impose 'k '(> k 0))
  "impose: expected a verdict, an equation '(= k 1) or a list of them\n  given: (> k 0), a list\n"
  "  an inequality is declared by assume"]
 [(impose condition (L-harmonic 'm 'k))
  "impose: expected a verdict, an equation '(= k 1) or a list of them\n"
  "  given: the procedure `L-harmonic`\n"
  "  the value comes first, then the condition, as in (impose L '(= k 1))"]
 [(impose 'k (list (list condition) '((= a 0))))
  "impose: expected a verdict, an equation '(= k 1) or a list of them\n"
  "  given: (((= k (* m (expt omega 2)))) ((= a 0))), a list\n"
  "  these are alternatives: choose one, as (car (verdict-alternatives v))"]
 [(impose 'k '(= 1 2)) "impose: the equations cannot hold together\n  equations: ((= 1 2))"]
 [(impose 'a '(= (+ a b) (+ c d)))
  "impose: the equation cannot be solved for one of its symbols\n"
  "  equation: (= (+ a b) (+ c d))\n  write it as (= symbol expression)"]
 [(impose 'y '(= (* 2 x y) 0))
  "impose: a product is zero with any of its factors\n"
  "  equation: (= (* 2 x y) 0)\n  write the factor that is meant, as (= x 0)"]
 [(verify-again (prove-zero 'x) '(= 0 (* x (sin y))))
  "verify-again: a product is zero with any of its factors\n"
  "  equation: (= 0 (* x (sin y)))\n  write the factor that is meant, as (= x 0)"]
 [(impose 'a '(= a (up 1 2)))
  "impose: an equation is between numbers or expressions\n  given: (= a (up 1 2))"]
 [(impose 'a '(= a))
  "impose: expected a verdict, an equation '(= k 1) or a list of them\n  given: (= a), a list"]
 [(impose v v) "impose: a verdict's question is asked again by (verify-again v condition)"]
 [(impose "a" '(= a 1))
  "impose: expected a value, a function or a constraint\n  given: \"a\", a string"])

(test-case "a quotient or a root is solved for what is divided, or under the root"
  (check-equal? (impose (+ 'x 'y) '(= (/ x y) 0)) 'y)
  (check-equal? (impose 'x '(= (/ x y) z)) (* 'y 'z))
  (check-equal? (impose 'x '(= 3 (/ x y))) (* 3 'y))
  (check-equal? (impose (+ 'x 'y) '(= 0 x)) 'y)
  (check-equal? (impose (+ 'x 'y) '(= (sqrt x) 3)) (+ 9 'y))
  (check-true (= (impose 'x '(= (/ (sqrt x) y) 2)) (square (* 2 'y))))
  (check-pred proved? (verify-again v '(= (/ k m) (expt omega 2))))
  (check-pred proved? (verify-again v '(= (sqrt (/ k m)) omega)))
  (check-exn #rx"^impose: a product is zero with any of its factors"
             (lambda () (impose 'x '(= (/ (* x z) y) 0))))
  (check-exn #rx"^impose: the equation cannot be solved" (lambda () (impose 'y '(= (/ 1 y) 0))))
  (check-exn #rx"^impose: the equation cannot be solved" (lambda () (impose 'x '(= (sqrt x) -3)))))

(test-case "a factor that both sides of a condition have is told not to be 0"
  (define (told claim condition) (verdict-remarks (verify-again claim condition)))
  (check-equal? (told (verify-equal 'y 'z) '(= (* x y) (* x z)))
                '("under the condition (* x y) = (* x z), with x not 0"))
  (check-equal? (told (verify-equal 'y 1) '(= (* x y) x))
                '("under the condition (* x y) = x, with x not 0"))
  (check-equal? (told (verify-equal 'y 'z) '(= (* x (square y)) (* (square z) x)))
                '("under the condition (* x (expt y 2)) = (* (expt z 2) x), with y = z, x not 0"))
  (check-equal? (told (verify-equal (* 'c 'y) (* 'c 'z)) '(= (/ y c) (/ z c)))
                '("under the condition (/ y c) = (/ z c)")))

(test-case "a condition that changes nothing is refused"
  (check-message (string-append
                  "verify-again: the symbol z does not occur in what was asked, "
                  "so that the condition changes nothing\n"
                  "  symbols of the residual: (a k m omega phi t)")
                 (verify-again v '(= z 3)))
  (check-exn #rx"the symbol z does not occur" (lambda () (verify-again v '((= k m) (= z 3)))))
  (check-pred refuted? (verify-again v '((= z 3) (= k (* z m))))))

(test-case "what a condition is imposed on comes before it"
  (check-message (string-append "verify-again: the verdict comes first, then the condition: "
                                "(verify-again v '(= k m))")
                 (verify-again '(= k m) v))
  (define hint
    #rx"\n  the value comes first, then the condition, as in [(]impose L '[(]= k 1[)][)]$")
  (check-exn hint (lambda () (impose '(= k 3) (* 'k 'x))))
  (check-exn hint (lambda () (impose '((= k 3)) (* 'k 'x))))
  (check-exn hint (lambda () (impose v 'k)))
  (check-message (string-append
                  "impose: expected a verdict, an equation '(= k 1) or a list of them\n"
                  "  given: (((= k 3)) 4), a list")
                 (impose 'k '(((= k 3)) 4))))
