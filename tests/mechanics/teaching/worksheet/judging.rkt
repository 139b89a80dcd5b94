#lang mechanics
;; Answers of every kind, judged: right ones, equivalent ones, slips of every sort, trivial ones,
;; and what is no answer.

(require mechanics/book
         mechanics/teaching/worksheet/answer-data
         mechanics/teaching/worksheet/exercise
         mechanics/teaching/worksheet/exercise-kind
         mechanics/teaching/worksheet/judge
         mechanics/teaching/worksheet/judgment
         mechanics/teaching/worksheet/make-exercise
         (only-in racket/string string-prefix?)
         (except-in "../../support/checks.rkt" check))

(define-syntax-rule (an-exercise kind clause ...)
  (make-exercise 'item 'kind "?" (list (list . clause) ...)))

(define (judgment-of e answer) (judge e (answer->datum answer (rounds-of e))))

;; [answer status share words ...] : the words are how what is said first begins
(define-syntax-rule (judges e [answer status share . words] ...)
  (begin (test-case (format "~s is ~a" 'answer 'status)
           (check-judgment (judgment-of e answer) 'status share . words)) ...))

(define (check-judgment j status share [words #f])
  (check-equal? (list (judgment-status j) (judgment-share j)) (list status share))
  (check-pred (lambda (v) (or (eq? v #f) (verdict? v))) (judgment-verdict j))
  (when words
    (check-true (and (pair? (judgment-words j)) (string-prefix? (car (judgment-words j)) words))
                (format "~s" (judgment-words j)))))

(define D2 (expt D 2))

;; ---------------------------------------------------------------------------
;; Equations of motion

(define L (L-pendulum 'g 'm 'l))
(define pendulum (an-exercise equations ('coordinates 'theta) ('of L)))

(define ((pendulum-with factor of-sine) theta)
  (lambda (t) (* factor (+ ((D2 theta) t) (* of-sine (sin (theta t)))))))

(judges pendulum
 [(Lagrange-equations L) right 1]
 [(pendulum-with 1 (/ 'g 'l)) right 1]
 [(pendulum-with (square 'l) (/ 'g 'l)) right 1]
 [(lambda (theta t) (+ ((D2 theta) t) (* (/ 'g 'l) (sin (theta t))))) right 1]
 [(pendulum-with 1 (/ 'g -1 'l)) wrong 0 "the sign is the opposite"]
 [(pendulum-with 1 (/ 'g 2 'l)) wrong 0 "one term has another factor than it should"]
 [(pendulum-with 1 (/ 'g 'L)) wrong 0 "it has L in it"]
 [(lambda (theta) (lambda (t) (+ ((D theta) t) (* (/ 'g 'l) (sin (theta t)))))) wrong 0
  "a first derivative stands where a second one should"]
 [(lambda (theta t) 0) trivial 0 "it is true of every motion"]
 [(lambda (theta t) ((D2 theta) t)) wrong 0]
 [(lambda (theta t) (up ((D2 theta) t) 0)) wrong 0 "the answer has 2 equations"]
 [(lambda (a b c) 1) failed 0 "answer: the function takes 3 arguments"]
 [car failed 0 "car: contract violation"]
 [unanswered unanswered 0])

;; Of x alone nothing is said by an equation with its velocity.
(define ((resisted of-what) x)
  (lambda (t) (+ (* 'm ((D2 x) t)) (* 'c ((of-what x) t)))))
(judges (an-exercise equations ('coordinates 'x) ('key (resisted D)))
 [(resisted identity) wrong 0 "a derivative is missing: a coordinate stands for its velocity"]
 [(resisted D) right 1])

;; An equation of first order says nothing of accelerations: it is compared as it stands.
(define ((fading factor) x) (lambda (t) (* factor (+ ((D x) t) (* 'c (x t))))))
(judges (an-exercise equations ('coordinates 'x) ('key (fading 1)))
 [(fading 1) right 1]
 [(fading 'm) right 1]
 [(lambda (x) (lambda (t) (- ((D x) t) (* 'c (x t))))) wrong 0])

;; Motions that obey the key obey these, too.
(define ((pendulum-times factor) theta)
  (lambda (t)
    (define a ((D2 theta) t))
    (define b (* (/ 'g 'l) (sin (theta t))))
    (* (factor a b) (+ a b))))

(judges pendulum
 [(pendulum-times (lambda (a b) (- a b))) partly 1/2
  "it is true of every motion, but it also holds for θ̈ = g sin(θ)/l"]
 [(pendulum-times (lambda (a b) (+ 1 a))) partly 1/2
  "it is true of every motion, but it also holds for θ̈ = −1"]
 [(pendulum-times (lambda (a b) (+ a b))) right 1]
 [(pendulum-times (lambda (a b) (sin b))) right 1]
 [(pendulum-times (lambda (a b) ((literal-function 'f) a))) undecided #f
  "every motion obeys it, but it is not linear in the accelerations"]
 [(pendulum-times (lambda (a b) (+ 1 (square b)))) right 1])

;; The assumption of the question leaves no room for x = -1.
(define ((oscillator-times factor) x)
  (lambda (t) (* (factor (x t)) (+ (* 'm ((D2 x) t)) (* 'k (x t))))))
(judges (an-exercise equations ('coordinates 'x) ('of (L-harmonic 'm 'k)) ('assuming '(> x 0)))
 [(oscillator-times (lambda (x) (+ x 1))) right 1]
 [(oscillator-times (lambda (x) (- x 1))) partly 1/2 "it is true of every motion, but it also"])

;; Of two zeros one is left, and found.
(judges (an-exercise equations ('coordinates 'x) ('of (L-harmonic 'm 'k)) ('assuming '(> x 3/2)))
 [(oscillator-times (lambda (x) (- (square (- x 3/2)) 6/25))) partly 1/2
  "it is true of every motion, but it also"])

;; Where r = 0 polar coordinates are singular, which is no motion more; a velocity that may be
;; anything is one.
(define planar-oscillator
  (an-exercise equations ('coordinates 'r 'phi)
               ('of (L-central-polar 'm (lambda (r) (* 1/2 'k (square r)))))))
(judges planar-oscillator
 ["[m r'' - m r phi'^2 + k r, r^3 phi'' + 2 r^2 r' phi']" right 1]
 ["[m r'' - m r phi'^2 + k r, phi' (r phi'' + 2 r' phi')]" right 1]
 ["[phi' (m r'' - m r phi'^2 + k r), r phi'' + 2 r' phi']" partly 3/4
  "it is true of every motion, but it also holds for φ̇ = 0"])

;; A factor that vanishes on a small circle of states only
(define ((oscillator-on-circle center) x)
  (lambda (t)
    (* (- (+ (square (- (x t) center)) (square (- ((D x) t) center))) 1/4)
       (+ (* 'm ((D2 x) t)) (* 'k (x t))))))
(judges (an-exercise equations ('coordinates 'x) ('of (L-harmonic 'm 'k)))
 [(oscillator-on-circle 3/2) partly 1/2 "it is true of every motion, but it also holds where"]
 [(oscillator-on-circle -3/2) partly 1/2 "it is true of every motion, but it also holds where"])

(define (L-two (up t (up x y) (up vx vy)))
  (- (* 1/2 'm (+ (square vx) (square vy))) (* 1/2 'k (+ (square x) (* 4 (square y))))))
(define two (an-exercise equations ('coordinates 'x 'y) ('of L-two)))
(define ((two-with f g) path)
  (lambda (t)
    (define-values (x y) (values (ref path 0) (ref path 1)))
    (define-values (a b) (values (+ (* 'm ((D2 x) t)) (* 'k (x t)))
                                 (+ (* 'm ((D2 y) t)) (* 4 'k (y t)))))
    (up (f a b) (g a b))))

(judges two
 [(two-with (lambda (a b) a) (lambda (a b) b)) right 1]
 [(two-with (lambda (a b) (+ a b)) (lambda (a b) (- a (* 2 b)))) right 1]
 [(two-with (lambda (a b) b) (lambda (a b) a)) right 1]
 [(two-with (lambda (a b) (* b b)) (lambda (a b) a)) undecided #f "every motion obeys it, but"]
 [(two-with (lambda (a b) a) (lambda (a b) a)) partly 1/2 "some of the equations say the same"]
 [(two-with (lambda (a b) a) (lambda (a b) (- b (* 'k 'y)))) partly 1/2]
 [(two-with (lambda (a b) (* a (+ a 1))) (lambda (a b) (- b (* 'k 'y)))) undecided #f
  "some of the equations are refuted, and one that holds is not linear"]
 [(two-with (lambda (a b) 0) (lambda (a b) (- b (* 'k 'y)))) wrong 0])

(define (L-three (up t (up x y z) (up vx vy vz)))
  (- (* 1/2 'm (+ (square vx) (square vy) (square vz))) (* 1/2 'k (square x))))
(define three (an-exercise equations ('coordinates 'x 'y 'z) ('of L-three)))
(define ((three-with f) path)
  (lambda (t)
    (define (a n) ((D2 (ref path n)) t))
    (up (+ (* 'm (a 0)) (* 'k ((ref path 0) t))) (f (a 1)) (a 2))))

;; An equation that repeats another, or is wrong, counts for nothing.
(judges three
 [(three-with (lambda (a) a)) right 1]
 [(three-with (lambda (a) (+ a 1))) partly 2/3]
 [(lambda (path) (lambda (t) (let ([a ((D2 (ref path 2)) t)]) (up a (* 2 a) (+ a 1)))))
  partly 1/3])

;; ---------------------------------------------------------------------------
;; Lagrangians

(define Lagrangian-of-pendulum (an-exercise Lagrangian ('coordinates 'theta) ('key L)))
(define (rate-of-something (up t theta thetadot)) (* theta thetadot))
(define (energy-of-pendulum (up t theta thetadot))
  (- (* 1/2 'm (square (* 'l thetadot))) (* 'm 'g 'l (cos theta))))

(judges Lagrangian-of-pendulum
 [L right 1]
 [(* 2 L) right 1]
 [(+ L rate-of-something) right 1]
 [rate-of-something trivial 0 "its equations of motion are 0 = 0"]
 [energy-of-pendulum wrong 0 "one term has the opposite sign"]
 [(- L) right 1]
 [(lambda (local) (up 1 2)) wrong 0])

;; ---------------------------------------------------------------------------
;; Motions and quantities

(define oscillator (L-harmonic 'm 'k))
(define (motion t) (* 'a (cos (+ (* (sqrt (/ 'k 'm)) t) 'phi))))
(define general
  (an-exercise solution ('coordinates 'x) ('of oscillator) ('constants 'a 'phi) ('key motion)))

(judges general
 [motion right 1]
 [(lambda (t) (+ (* 'a (cos (* (sqrt (/ 'k 'm)) t))) (* 'phi (sin (* (sqrt (/ 'k 'm)) t)))))
  right 1]
 [(lambda (t) (* 'a (cos (* (sqrt (/ 'k 'm)) t)))) partly 1/2 "it is a solution, but not the gen"]
 [(lambda (t) 0) trivial 0 "it is a solution, but nothing moves"]
 [(up (lambda (t) 't) 0) failed 0 "application: a tuple applies its components to the arguments"]
 [(lambda (t) (* 'a (cos (+ (* (sqrt (/ 'm 'k)) t) 'phi)))) wrong 0])

(define started
  (an-exercise solution ('coordinates 'x) ('of oscillator) ('starts (up 0 'x0 0))
               ('key (lambda (t) (* 'x0 (cos (* (sqrt (/ 'k 'm)) t)))))))
(judges started
 [(lambda (t) (* 'x0 (cos (* (sqrt (/ 'k 'm)) t)))) right 1]
 [(lambda (t) (* 'x0 (sin (* (sqrt (/ 'k 'm)) t)))) partly 1/3 "it is a solution, but does not"])

(define energy (Lagrangian->energy oscillator))
(define conserved
  (an-exercise conserved ('coordinates 'x) ('of oscillator) ('key energy)))
(judges conserved
 [energy right 1]
 [(square energy) right 1]
 [(lambda (local) 3) trivial 0 "it is the same whatever the state"]
 [velocity wrong 0])

(define planar (L-central-rectangular 'm (lambda (r) (* 1/2 'k (square r)))))
(define (angular-momentum (up t (up x y) (up vx vy))) (* 'm (- (* x vy) (* y vx))))
(define besides
  (an-exercise conserved ('coordinates 'x 'y) ('of planar)
               ('besides (Lagrangian->energy planar)) ('key angular-momentum)))
(judges besides
 [angular-momentum right 1]
 [(Lagrangian->energy planar) trivial 0 "it is conserved, but only what is known"])

(define canonical
  (an-exercise canonical ('coordinates 'q) ('key (lambda ((up t q p)) (up t p (- q))))))
(judges canonical
 [(lambda ((up t q p)) (up t (* 2 q) (/ p 2))) right 1]
 [(lambda ((up t q p)) (up t p q)) wrong 0 "it is not canonical"]
 [(lambda (s) s) trivial 0 "it leaves every state where it is"]
 [(lambda (s) 3) wrong 0 "its value is to be a state"])

(define (H (up t q p)) (+ (/ (square p) (* 2 'm)) (* 1/2 'k (square q))))
(define Hamiltonian-item (an-exercise Hamiltonian ('coordinates 'q) ('key H)))
(judges Hamiltonian-item
 [H right 1]
 [(lambda (s) (+ (H s) (cos (time s)))) right 1 "it differs by a term"]
 [(lambda ((up t q p)) (+ (/ (square p) (* 2 'm)) (* -1/2 'k (square q)))) wrong 0
  "one term has the opposite sign"])

;; ---------------------------------------------------------------------------
;; Values

(define sum (an-exercise expression ('key (+ (* 1/2 'm 'v 'v) (* 'm 'g 'x)))))
(judges sum
 [(* 'm (+ (* 1/2 (square 'v)) (* 'g 'x))) right 1]
 [(* 'm 'g 'x) wrong 0 "a term is missing"]
 [(- (* 1/2 'm 'v 'v) (* 'm 'g 'x)) wrong 0 "one term has the opposite sign"]
 [(+ (* 'm 'v 'v) (* 'm 'g 'x)) wrong 0 "one term has another factor"]
 [(* -1 'm (+ (* 1/2 'v 'v) (* 'g 'x))) wrong 0 "the sign is the opposite"]
 [(up 'a 'b) wrong 0]
 ["text" wrong 0 "it has text in it, of which the question does not speak"])

(define measured (an-exercise expression ('key (* (sqrt 2) 'x)) ('within 1/100)))
(judges measured
 [(* 1.41 'x) right 1 "as far as decimals tell, within 1 %"]
 [(* 1.5 'x) wrong 0]
 [(* 7/5 'x) wrong 0])

;; Where decimals leave it undecided, the exact numbers that they stand for decide.
(judges (an-exercise equations ('coordinates 'theta) ('of (L-pendulum 9.81 0.2 0.5)))
 ["θ'' + 19.62 sin θ = 0" right 1]
 ["0.5 θ'' = -9.81 sin θ" right 1])
(judges (an-exercise Lagrangian ('coordinates 'theta) ('key (L-pendulum 9.81 0.2 0.5)))
 ["0.025 θ'^2 + 0.981 cos θ" right 1])

;; Roots are exact in the key and in the answer.
(judges (an-exercise expression ('key (up (sqrt 12) (/ (+ 1 (sqrt 5)) 2))))
 [(up (* 2 (sqrt 3)) (/ 2 (- (sqrt 5) 1))) right 1]
 [(up (/ 6 (sqrt 3)) (sqrt (/ (+ 3 (sqrt 5)) 2))) right 1]
 [(up (* 3 (sqrt 2)) (/ (+ 1 (sqrt 5)) 2)) partly 1/2])
(judges (an-exercise expression ('key (* 'm (sqrt 1/2))))
 [(/ 'm (sqrt 2)) right 1] [(* 'm (expt 4 -1/4)) right 1] [(* 'm (sqrt 2)) wrong 0])

(define pair (an-exercise expression ('key (up 'a (* 2 'b)))))
(judges pair
 [(up 'a 'b) partly 1/2]
 [(down 'a (* 2 'b)) wrong 0 "the components are right, but up and down are exchanged"]
 [(up (* 2 'b) 'a) wrong 0 "the components are exchanged"])
(judges (an-exercise expression ('key (down 'a (up 'b 'c) 'd)))
 [(down 'b (up 'd 'a) 'c) wrong 0 "the components are exchanged"])
;; Other parts of as many components are none of these.
(judges (an-exercise expression ('key (up (up 'a 'b) 'c)))
 [(up 'a 'b 'c) wrong 0 "the answer is an up tuple of 3 where an up tuple of 2 is expected"])
;; Orders of more than four components are not tried.
(test-case "of five components that are exchanged no slip is told"
  (define j (judgment-of (an-exercise expression ('key (up 'a 'b 'c 'd 'e)))
                         (up 'b 'a 'c 'd 'e)))
  (check-judgment j 'partly 3/5)
  (check-false (member "the components are exchanged" (judgment-words j))))

(define number (an-exercise number ('key 1.42) ('within 1/100)))
(judges number
 [1.42 right 1] [(sqrt 2) right 1]
 [14.2 wrong 0 "it is off by a power of ten"]
 [-1.42 wrong 0 "the sign is the opposite"]
 [2.84 wrong 0 "it is off by a factor 2"]
 [1.5 wrong 0 "it is near, but not within the tolerance"]
 [(* 1.42 2 pi) wrong 0 "it is off by a factor 2π"]
 [(* 1.42 57.2957795) wrong 0 "degrees and radians are mixed up"]
 ['x failed 0 "it has x in it: give the number alone"])

(judges (an-exercise number ('key 5)) [(/ 1 5) wrong 0 "it is the reciprocal"])

;; A key below 0, and no answer at 0 or far away from it
(judges (an-exercise number ('key -5) ('within 1/1000))
 [-5.2 wrong 0 "it is near, but not within the tolerance"]
 [-50 wrong 0 "it is off by a power of ten"]
 [-0.5 wrong 0 "it is off by a power of ten"]
 [5 wrong 0 "the sign is the opposite"]
 [-2.5 wrong 0 "it is off by a factor 2"]
 [-1/5 wrong 0 "it is the reciprocal"]
 [25 wrong 0 "it is the square"])
(judges (an-exercise number ('key 5) ('within 1/1000))
 [(sqrt 5) wrong 0 "it is the square root"])
(test-case "of a number that is far away nothing is told"
  (for ([(key answers) (hash -5 '(-6 -4 0) 5 '(6 4 0) 0 '(1))])
    (define e (make-exercise 'item 'number "?" (list (list 'key key) '(within 1/1000))))
    (for ([x (in-list answers)])
      (define j (judgment-of e x))
      (check-equal? (list (judgment-status j) (judgment-words j)) '(wrong ()) (format "~a" x)))))

(define reason (an-exercise reason))
(test-case "a reason is kept and not judged, and is a text"
  (check-equal? (judgment-status (judge reason (text-answer->datum "because"))) 'kept)
  (check-equal? (text-answer->datum 5)
                '(failed "it is no text; a text stands in quotation marks"))
  (check-equal? (text-answer->datum "  ") '(unanswered)))

(define own
  (an-exercise expects ('arguments 'x) ('expects (lambda (answer) (verify-equal answer 'x)))))
(judges own [identity right 1] [(lambda (x) (* 2 x)) wrong 0])

;; ---------------------------------------------------------------------------
;; Slips of the teacher's

(define foreseen
  (an-exercise Lagrangian ('coordinates 'theta) ('key L)
               ('slip energy-of-pendulum "that is the energy" '#:credit 1/2)))
(judges foreseen
 [energy-of-pendulum partly 1/2 "that is the energy"]
 [(* 3 energy-of-pendulum) partly 1/2 "that is the energy"])

;; A slip leaves what the answer has earned without it, or gives more.
(define-syntax-rule (pair-with-slip credit)
  (an-exercise expression ('key (up 'a (* 2 'b))) ('slip (up 'a 'b) "half of b" '#:credit credit)))
(judges (pair-with-slip 0) [(up 'a 'b) partly 1/2 "half of b"])
(judges (pair-with-slip 1/4) [(up 'a 'b) partly 1/2 "half of b"])
(judges (pair-with-slip 3/4) [(up 'a 'b) partly 3/4 "half of b"])

;; A slip of a motion is a motion, compared with the answer; the key is none that must be met.
(judges (an-exercise solution ('coordinates 'x) ('of oscillator) ('constants 'a 'phi) ('key motion)
                     ('slip (lambda (t) (* 'a (sin (* (/ 'k 'm) t)))) "no root" '#:credit 1/3))
 [(lambda (t) (* 'a (sin (* (/ 'k 'm) t)))) partly 1/3 "no root"]
 [(lambda (t) (* 'a (cos (* (/ 'k 'm) t)))) wrong 0])

;; ---------------------------------------------------------------------------
;; Answers too large, and answers that the mathematics cannot tell

(define (status-of-datum e d) (judgment-status (judge e (list 'answer d))))

(test-case "data that would never be calculated are refused before"
  (for ([d (list '(expt 9 (expt 9 9)) '(expt (expt (expt (expt 10 99) 99) 99) 99)
                 '(expt (+ x y) 1000000) "text" '(quote . x) '((((f)))) '#s(a 1) '(+ . 2)
                 (for/fold ([d 'x]) ([i 1000]) (list 'sin d)))])
    (check-equal? (status-of-datum sum d) 'failed (format "~s" d))))

(test-case "a power with a symbol in its exponent is no large number"
  (define (power base) `(expt ,base (+ n 2)))
  (check-equal? (status-of-datum sum (power (power (power 'x)))) 'wrong))

(test-case "what cannot be decided is left to a person"
  (define decimals (an-exercise Hamiltonian ('coordinates 'q) ('key (lambda (s) (* 0.1 'q)))))
  (define j (judge decimals '(answer (* (+ (sin 0.1) 0.0001665833531718) q))))
  (check-equal? (list (judgment-status j) (judgment-share j)) '(undecided #f)))

;; ---------------------------------------------------------------------------
;; Failures of the judge are not the student's

(judges (an-exercise expects ('expects (lambda (answer) (car answer))))
 ['x undecided #f "it could not be judged: car: contract violation"]
 [(string->symbol "y") undecided #f "it could not be judged: car"])

(test-case "habits of other programs are told"
  (define (words answer) (judgment-words (judgment-of (an-exercise expression ('key 'a)) answer)))
  (check-equal? (words (list 1 2)) '("it is a list; what has components is a tuple, (up 1 2)"))
  (check-equal? (words (string->symbol "x**2"))
                '("x**2 in it is one name; powers are (expt x 2), or in a text \"x^2\"")))

(test-case "what is no expression is the student's"
  (check-judgment (judge (an-exercise expression ('key 'a)) '(answer "a")) 'failed 0))

(test-case "a slip that cannot be compared leaves the judgment as it is"
  (define e (an-exercise expression ('key 'a) ('slip 'b "no")))
  (define broken (struct-copy exercise e [slips (list (slip '(/ 1 0) "no" 0))]))
  (check-judgment (judge broken '(answer c)) 'wrong 0))
