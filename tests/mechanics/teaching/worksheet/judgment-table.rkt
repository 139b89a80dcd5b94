#lang mechanics
;; Answers as they stand on paper, with the judgment that a teacher gives by hand.  No answer may be
;; judged otherwise; at most 3 of 100 may be left undecided.

(require mechanics/book
         mechanics/teaching/worksheet/answer-data
         mechanics/teaching/worksheet/exercise-kind
         mechanics/teaching/worksheet/judge
         mechanics/teaching/worksheet/judgment
         mechanics/teaching/worksheet/make-exercise
         (except-in "../../support/checks.rkt" check))

(define-syntax-rule (an-exercise kind clause ...)
  (make-exercise 'item 'kind "?" (list (list . clause) ...)))

(define counts (make-hasheq))
(define (count! status) (hash-update! counts status add1 0))

;; rows : status text ...
(define-syntax-rule (table e [status text ...] ...)
  (begin (judges e 'status (list text ...)) ...))

(define (judges e wanted texts)
  (for ([text texts])
    (define j (judge e (answer->datum text (rounds-of e))))
    (count! (judgment-status j))
    (unless (eq? 'undecided (judgment-status j))
      (test-case (format "~a: ~a" wanted text)
        (check-true (fits? j wanted)
                    (format "~a: ~s, ~s" text (judgment-status j) (judgment-words j)))))))

;; Nonsense gets no points, and is no answer or a refuted one.
(define (fits? j wanted)
  (if (eq? wanted 'nonsense)
      (and (memq (judgment-status j) '(failed wrong)) (eqv? 0 (judgment-share j)))
      (eq? wanted (judgment-status j))))

;; ---------------------------------------------------------------------------
;; Expressions

(table (an-exercise expression ('key (+ (* 1/2 'm 'v 'v) (* 'm 'g 'x))))
 [right "1/2 m v^2 + m g x" "m v^2/2 + m g x" "m (v^2/2 + g x)" "½ m v² + m g x" "0.5 m v^2 + mgx"
        "\\frac{1}{2} m v^2 + m g x" "m*v**2/2 + m*g*x" "E = 1/2 m v^2 + m g x"
        "(1/2)mv^2 + mgx"]
 [wrong "1/2 m v^2 - m g x" "m v^2 + m g x" "m g x" "1/2 m v^2" "1/2 m v + m g x"
        "1/2 m V^2 + m g x" "1/2 m v^2 + m g h" "-(1/2 m v^2 + m g x)" "0" "x"]
 [failed "1/2x" "m v^" "((m v^2)/2" "?" "f(x+1)"]
 [nonsense "half m v squared" "a lot"])

(table (an-exercise expression ('key (sqrt (/ 'g 'l))))
 [right "sqrt(g/l)" "√(g/l)" "\\sqrt{g/l}" "\\sqrt{\\frac{g}{l}}" "(g/l)^(1/2)" "g/sqrt(g l)"
        "sqrt(g)/sqrt(l)" "(g/l)^0.5" "omega = sqrt(g/l)"]
 [wrong "sqrt(l/g)" "-sqrt(g/l)" "g/l" "2 pi sqrt(l/g)" "sqrt(2 g/l)" "sqrt(g)/l" "sqrt(g l)"]
 [failed "1/(2 pi) sqrt(g/l)" "sqrt(g/l" "√g/l" "g/l^1/2" "sqrt"])

(table (an-exercise expression ('arguments 'theta) ('key (lambda (theta) (square (sin theta)))))
 [right "sin^2 theta" "sin²θ" "\\sin^2\\theta" "1 - cos^2 theta" "(1 - cos 2θ)/2" "sin(theta)^2"
        "\\frac{1-\\cos(2\\theta)}{2}"]
 [wrong "cos^2 theta" "sin theta" "1 + cos^2 theta" "1 - cos θ" "2 sin^2 theta" "-sin^2 θ"
        "sin 2θ"]
 [failed "sin theta^2" "sin θ/2 x" "sin^ theta"])

;; Decimals: as far as they tell, within the tolerance
(table (an-exercise expression ('key (* (sqrt 2) 'a 'x)) ('within 1/100))
 [right "sqrt(2) a x" "1.41 a x" "1.414 a x" "√2 x a" "a x \\sqrt{2}" "1.4142135 x a" "2 a x/1.414"]
 [wrong "1.5 a x" "-1.41 a x" "1.41 a" "1.41 a x + 0.2 x" "14.1 a x" "sqrt(3) a x" "1.41 a x^2"]
 [failed "1,41 a x"])

(table (an-exercise expression ('key (+ (* 9.81 't 't) (* 2.5 't))))
 [right "9.81 t^2 + 2.5 t" "t (9.81 t + 2.5)" "9.81 t² + 5/2 t" "2.5 t + 9.81 t^2"]
 [wrong "9.81 t^2 - 2.5 t" "9.81 t^2" "4.9 t^2 + 2.5 t" "2.5 t" "-9.81 t^2 - 2.5 t"
        "10.5 t^2 + 2.5 t"])

(table (an-exercise expression ('key (* 2 'A (cos (* 3.14159 'f 't)))))
 [right "2 A cos(π f t)" "2 A cos(3.14 f t)" "2A cos(3.1416 f t)"]
 [wrong "2 A sin(3.14 f t)" "2 A cos(f t)" "A cos(3.14 f t)" "2 A cos(3.14 t)" "2 A cos(3.3 f t)"
        "2 A cos(3.14 f t) + cos(1000000.5 f)" "2000.5 A - 1998.5 A"])
(table (an-exercise expression ('key (* 2 'A (cos (* ':pi 'f 't)))))
 [right "2 A cos(π f t)" "2 A cos(3.14 f t)"]
 [wrong "2 A cos(3 f t)" "2.0 A cos(3 f t)" "2.5 A cos(π f t)"])

;; Where an answer is proved, decimals are the exact numbers that they stand for.
(table (an-exercise Lagrangian ('coordinates 'theta) ('key (L-pendulum 9.81 0.2 0.5)))
 [right "0.025 θ'^2 + 0.981 cos θ" "θ'^2/40 + 0.981 cos θ"]
 [wrong "0.025 θ'^2 - 0.981 cos θ" "0.025 θ'^2 + 0.98 cos θ"])

(table (an-exercise equations ('coordinates 'theta) ('of (L-pendulum 9.81 0.2 0.5)))
 [right "θ'' + 19.62 sin θ = 0" "0.5 θ'' = -9.81 sin θ"]
 [partly "θ' (θ'' + 19.62 sin θ) = 0"]
 [wrong "θ'' - 19.62 sin θ = 0" "θ'' + 19.62 θ = 0" "θ'' + 18 sin θ"])

(define (L-falling (up t x v)) (- (* 0.5 v v) (* 9.81 x)))
(table (an-exercise solution ('coordinates 'x) ('of L-falling) ('starts (up 0 2.5 0))
                    ('key (lambda (t) (- 2.5 (* 4.905 t t)))))
 [right "2.5 - 4.905 t^2" "5/2 - 9.81 t²/2"]
 [partly "2.5 + t - 4.905 t^2"]
 [wrong "2.5 - 9.81 t^2" "2.5 + 4.905 t^2"])

;; ---------------------------------------------------------------------------
;; Numbers

(table (an-exercise number ('key 2.006) ('unit "s") ('within 1/100))
 [right "2.006" "2.01" "2" "2.006 s" "2 pi sqrt(1/9.81)" "2π/3.132"]
 [wrong "1.003" "12.6" "-2.006" "0.498" "20.06" "2006" "2.1"]
 [failed "2,006" "T" "2 l" "2 seconds"] [nonsense "two"])

(table (an-exercise number ('key 0) ('within 1/1000))
 [right "0" "0.0001" "1 - 1"]
 [wrong "1" "-1" "0.01"]
 [failed "x"])

;; ---------------------------------------------------------------------------
;; Lagrangians

(table (an-exercise Lagrangian ('coordinates 'theta) ('key (L-pendulum 'g 'm 'l)))
 [right "1/2 m l^2 theta'^2 + m g l cos theta" "L = 1/2 m l² θ̇² + m g l cos θ"
        "1/2 m (l thetadot)^2 - m g l (1 - cos(theta))" "l θ'^2/2 + g cos θ"
        "\\frac12 m l^2 \\dot\\theta^2 + m g l \\cos\\theta"
        "0.5 m l^2 theta_dot^2 + m g l cos(theta) + theta theta_dot"
        "1/2 m l^2 θ'^2 + m g l cos θ + t^2"]
 [wrong "1/2 m l^2 theta'^2 - m g l cos theta" "m l^2 theta'^2 + m g l cos theta"
        "1/2 m l^2 theta'^2" "m g l cos theta" "1/2 m l^2 theta'^2 + m g l sin theta"
        "1/2 m l^2 theta'^2 + m g l cos phi" "1/2 m l^2 theta'^2 + m g l cos theta + theta'^2 theta"
        "1/2 m x'^2 - m g x"]
 [trivial "theta theta'" "0" "theta'"]
 [failed "1/2 m l^2 theta'^2 + m g l cos" "T - "])

(table (an-exercise Lagrangian ('coordinates 'r 'phi)
                    ('key (L-central-polar 'm (literal-function 'V))))
 [right "1/2 m (r'^2 + r^2 phi'^2) - V(r)" "m/2 (\\dot{r}^2 + r^2 \\dot{\\varphi}^2) - V(r)"
        "m r'^2/2 + m r^2 φ'^2/2 - V(r)" "m (ṙ² + (r φ̇)²) - 2 V(r)"]
 ;; one of its two equations of motion is right
 [partly "1/2 m (r'^2 + r^2 phi'^2) + V(r)" "1/2 m (r'^2 - r^2 phi'^2) - V(r)"
         "1/2 m (r'^2 + r^2 phi'^2) - V" "1/2 m (r'^2 + r^2 phi'^2) - W(r)"
         "1/2 m r^2 phi'^2 - V(r)"]
 [wrong "1/2 m (r'^2 + r phi'^2) - V(r)" "1/2 m (r'^2 + phi'^2) - V(r)" "1/2 m r'^2 - V(r)"
        "1/2 m (r phi'^2) + 2 V(r)"]
 [failed "1/2 m (r'^2 + r^2 phi'^2 - V(r)" "1/2m(r'^2 + r^2 phi'^2) - V(r"])

;; ---------------------------------------------------------------------------
;; Equations of motion

(table (an-exercise equations ('coordinates 'x) ('of (L-harmonic 'm 'k)))
 [right "m x'' + k x" "m x'' + k x = 0" "m x'' = -k x" "x'' = -k/m * x" "m ẍ + k x" "-m x'' - k x"
        "m \\ddot{x} + k x" "m x''(t) + k x(t) = 0" "2 m x'' + 2 k x = 0" "x''/k + x/m = 0"
        "(1 + x^2) (m x'' + k x)" "m d^2x/dt^2 + k x = 0" "(m x'' + k x)^2 = 0" "m D²x(t) + k x(t)"
        "\\frac{d^2 x}{dt^2} + \\frac{k}{m} x = 0" "(2 + sin x) (m x'' + k x)"
        "xddot + k/m*x" "(m x'' + k x)/x'^2"]
 [partly "x' (m x'' + k x)" "(x - 1) (m x'' + k x)" "(x'^2 - 2) (m x'' + k x) = 0"
         "m x' x'' + k x x' = 0" "(m x'' + k x) (m x'' - k x) = 0" "(x - 1)^2 (m x'' + k x)"
         "(x + x') (m x'' + k x) = 0" "(x'' - 1) (m x'' + k x)"]
 [wrong "m x'' - k x" "m x'' + 2 k x" "m x'" "m x' + k x = 0" "m x''" "k x" "m x'' + k x^2"
        "m x'' + k y = 0" "m x'' + k x - m g" "x'^2 m/2 + k x^2/2" "[m x'' + k x, 0]"]
 [trivial "0" "0 = 0" "x - x"]
 [failed "m x'' +" "m x''' + k x = 0" "k/m x + x''" "x = A cos omega t"])

(table (an-exercise equations ('coordinates 'theta) ('of (L-pendulum 'g 'm 'l)))
 [right "θ'' + (g/l) sin θ = 0" "m l^2 theta'' + m g l sin(theta)"
        "l \\ddot\\theta = -g \\sin\\theta"
        "theta'' = -(g/l) sin theta" "\\ddot{\\theta} + \\frac{g}{l}\\sin\\theta = 0"
        "sin(theta) (l theta'' + g sin(theta))" "l thetaddot + g sin theta"]
 [partly "theta' (l theta'' + g sin theta)" "cos(theta) (l theta'' + g sin theta) = 0"
         "(theta - 1) (l theta'' + g sin(theta))"]
 [wrong "theta'' - (g/l) sin theta" "θ'' + (g/l) cos θ" "θ'' + g/l" "θ'' + (l/g) sin θ = 0"
        "theta' + (g/l) sin theta" "θ'' + (g/l) θ" "θ'' + g sin θ" "x'' + (g/l) x"]
 [failed "θ'' + g/l sin θ"])

(define (L-two (up t (up x y) (up vx vy)))
  (- (* 1/2 'm (+ (square vx) (square vy))) (* 1/2 'k (+ (square x) (* 4 (square y))))))
(table (an-exercise equations ('coordinates 'x 'y) ('of L-two))
 [right "[m x'' + k x, m y'' + 4 k y]" "m x'' + k x = 0, m y'' + 4 k y = 0"
        "(m y'' + 4 k y, m x'' + k x)" "m x'' = -k x; m y'' = -4 k y"
        "[m x'' + k x + m y'' + 4 k y, m x'' + k x - m y'' - 4 k y]"]
 [partly "[m x'' + k x, m y'' - 4 k y]" "[m x'' + k x, m y'' + k y]" "[m x'' + k x, 0]"
         "[x' (m x'' + k x), m y'' + 4 k y]" "[m x'' + k x, m x'' + k x]"]
 [wrong "[m x'' - k x, m y'' - 4 k y]" "m x'' + k x = 0" "[x, y]" "[m x' + k x, m y' + 4 k y]"
        "[m x'' + k y, m y'' + 4 k x]"]
 [failed "[m x'' + k x, m y'' + 4 k y"])

(table (an-exercise equations ('coordinates 'r 'phi)
                    ('of (L-central-polar 'm (lambda (r) (* 1/2 'k (square r))))))
 [right "[m r'' - m r phi'^2 + k r, m r^2 phi'' + 2 m r r' phi']"
        "r'' - r φ'^2 + (k/m) r = 0, r φ'' + 2 r' φ' = 0"
        "\\ddot{r} = r\\dot\\varphi^2 - \\frac{k}{m} r, r \\ddot\\varphi = -2\\dot r\\dot\\varphi"]
 [partly "[m r'' + k r, r phi'' + 2 r' phi']" "[m r'' - m r phi'^2 + k r, r phi'' + r' phi']"
         "[r'' - r phi'^2 + k r, r phi'' + 2 r' phi']"]
 [wrong "[m r'' + m r phi'^2 + k r, r phi'' - 2 r' phi']" "[r'' + k r, phi'']"])

(table (an-exercise equations ('coordinates 'x)
                    ('key (lambda (x)
                            (lambda (t) (+ (* 'm (((expt D 2) x) t)) (* 'c ((D x) t))
                                           (* 'k (x t)) (* -1 'F (cos (* 'Omega t))))))))
 [right "m x'' + c x' + k x = F cos(Omega t)" "m ẍ + c ẋ + k x - F cos(Ω t)"
        "x'' + (c/m) x' + (k/m) x - (F/m) cos(Ωt) = 0"
        "m \\ddot x + c \\dot x + k x = F \\cos(\\Omega t)"]
 [partly "x (m x'' + c x' + k x - F cos(Omega t))"]
 [wrong "m x'' - c x' + k x = F cos(Omega t)" "m x'' + k x = F cos(Omega t)"
        "m x'' + c x' + k x = F sin(Omega t)" "m x'' + c x' + k x = -F cos(Omega t)"
        "m x'' + c x' + k x" "m x'' + c x + k x = F cos(Omega t)"]
 [failed "m x'' + c x' + k x = F cos Omega t"])

;; ---------------------------------------------------------------------------
;; Motions

(define oscillator (L-harmonic 'm 'k))
(table (an-exercise solution ('coordinates 'x) ('of oscillator) ('constants 'A 'phi)
                    ('key (lambda (t) (* 'A (cos (+ (* (sqrt (/ 'k 'm)) t) 'phi))))))
 [right "A cos(sqrt(k/m) t + phi)" "x(t) = A cos(sqrt(k/m) t + phi)" "A sin(sqrt(k/m) t - phi)"
        "A cos(sqrt(k/m) t) + phi sin(sqrt(k/m) t)"
        "x = A \\cos(\\sqrt{\\frac{k}{m}} t + \\varphi)"]
 [partly "A cos(sqrt(k/m) t)" "3 cos(sqrt(k/m) t + phi)" "A cos(sqrt(k/m) t) + A sin(sqrt(k/m) t)"]
 [wrong "A cos(sqrt(m/k) t + phi)" "A cos(sqrt(k) t + phi)" "A cos(t + phi)" "A t + phi"
        "A exp(sqrt(k/m) t) + phi" "A cos(sqrt(k/m) t + phi) + 1"]
 [trivial "0"]
 [failed "A cos sqrt(k/m) t" "(A cos(t), 0"])

(define (L-fall (up t x v)) (- (* 1/2 'm v v) (* 'm 'g x)))
(table (an-exercise solution ('coordinates 'x) ('of L-fall) ('starts (up 0 'h 0))
                    ('key (lambda (t) (- 'h (* 1/2 'g t t)))))
 [right "h - 1/2 g t^2" "h - g t²/2" "x(t) = h - \\frac{g t^2}{2}"]
 [partly "-g t^2/2" "h + v t - g t^2/2"]
 [wrong "h + g t^2/2" "h - g t^2" "h - g t" "h" "t" "-(h - g t^2/2)"]
 [failed "h - 1/2g t^2"])

;; ---------------------------------------------------------------------------
;; Quantities

(table (an-exercise conserved ('coordinates 'x) ('of oscillator)
                    ('key (Lagrangian->energy oscillator)))
 [right "1/2 m x'^2 + 1/2 k x^2" "m ẋ² + k x²" "(m x'^2 + k x^2)^2" "E = m xdot^2/2 + k x^2/2"
        "x'^2 + (k/m) x^2" "\\frac{m \\dot{x}^2}{2} + \\frac{k x^2}{2}"]
 [wrong "1/2 m x'^2 - 1/2 k x^2" "m x'^2 + 1/2 k x^2" "x'" "m x'" "x" "1/2 m x'^2"
        "m x'^2 + k x" "1/2 m y'^2 + 1/2 k y^2"]
 [trivial "1" "m" "k/m"]
 [failed "1/2 m x'^2 + 1/2 k x^"] [nonsense "V"])

(define planar (L-central-rectangular 'm (lambda (r) (* 1/2 'k (square r)))))
(table (an-exercise conserved ('coordinates 'x 'y) ('of planar)
                    ('besides (Lagrangian->energy planar))
                    ('key (lambda ((up t (up x y) (up vx vy))) (* 'm (- (* x vy) (* y vx))))))
 [right "m (x y' - y x')" "x y' - y x'" "x ẏ - y ẋ"]
 [wrong "x y' + y x'" "x x' - y y'" "m x'" "x y"]
 [trivial "1/2 m (x'^2 + y'^2) + 1/2 k (x^2 + y^2)" "3" "(m (x'^2 + y'^2) + k (x^2 + y^2))^2"])

(define (H-osc (up t q p)) (+ (/ (square p) (* 2 'm)) (* 1/2 'k (square q))))
(table (an-exercise conserved ('coordinates 'q) ('of-Hamiltonian H-osc) ('key H-osc))
 [right "p^2/(2 m) + k q^2/2" "p_q^2/m + k q^2"]
 [wrong "p^2/(2 m) - k q^2/2" "p" "q p" "p^2/m + k q^2/2"]
 [trivial "m/k"])

;; ---------------------------------------------------------------------------
;; Functions and forces

(table (an-exercise function ('coordinates 'r 'phi)
                    ('key (lambda ((up t (up r phi) (up rdot phidot)))
                            (* 1/2 'm (+ (square rdot) (square (* r phidot)))))))
 [right "1/2 m (r'^2 + r^2 phi'^2)" "m/2 (ṙ² + r² φ̇²)" "m r_dot^2/2 + m (r phi_dot)^2/2"
        "\\frac{m}{2}\\left(\\dot r^2 + r^2\\dot\\varphi^2\\right)" "T = 1/2 m (r'^2 + r^2 φ'^2)"]
 [wrong "1/2 m (r'^2 - r^2 phi'^2)" "m (r'^2 + r^2 phi'^2)" "1/2 m r'^2" "1/2 m r^2 phi'^2"
        "1/2 m (r'^2 + r phi'^2)" "1/2 m v^2" "1/2 m (r' + r phi')^2"]
 [failed "1/2 m (r'^2 + r^2 phi'^2"])

(table (an-exercise function ('coordinates 'r 'phi)
                    ('key (lambda ((up t (up r phi) (up rdot phidot)))
                            (down (* 'm rdot) (* 'm (square r) phidot)))))
 [right "[m r', m r^2 phi']" "(m r', m r² φ')" "m r', m r^2 phi'" "down(m r', m r^2 phi')"]
 [partly "[m r', m r phi']" "[m r', -m r^2 phi']" "[r', m r^2 phi']"]
 [wrong "[-m r', -m r^2 phi']" "m r'" "[m r^2 phi', m r']" "[r, phi]" "[m r', m r^2 phi', 0]"])

(table (an-exercise constraint-force ('coordinates 'theta)
                    ('key (lambda ((up t theta thetadot))
                            (* 'm (+ (* 'g (cos theta)) (* 'l (square thetadot)))))))
 [right "m (g cos(theta) + l theta'^2)" "m g cos θ + m l θ'²"
        "\\lambda = m g\\cos\\theta + m l\\dot\\theta^2"]
 [wrong "m (g cos(theta) - l theta'^2)" "m g cos theta" "-m (g cos(theta) + l theta'^2)"
        "m l theta'^2"
        "m (g sin(theta) + l theta'^2)" "m g" "2 m (g cos θ + l θ'^2)" "m g cos θ + m l^2 θ'^2"])

;; ---------------------------------------------------------------------------
;; Functions on phase space

(table (an-exercise Hamiltonian ('coordinates 'q) ('key H-osc))
 [right "p^2/(2 m) + 1/2 k q^2" "p_q²/(2m) + k q²/2" "H = \\frac{p^2}{2m} + \\frac{1}{2} k q^2"
        "p^2/(2 m) + k q^2/2 + 5" "p^2/(2 m) + k q^2/2 + sin(t)"]
 [wrong "p^2/(2 m) - 1/2 k q^2" "p^2/m + k q^2/2" "1/2 m q'^2 + 1/2 k q^2" "p^2/(2 m)" "k q^2/2" "0"
        "-p^2/(2 m) - k q^2/2" "p^2/m + k q^2" "p^2/(2 m) + k q^2/2 + q"]
 [failed "p^2/2m + k q^2/2"])

(table (an-exercise Hamiltonian ('coordinates 'r 'phi)
                    ('key (lambda ((up t (up r phi) (down p_r p_phi)))
                            (+ (/ (+ (square p_r) (square (/ p_phi r))) (* 2 'm))
                               ((literal-function 'V) r)))))
 [right "p_r^2/(2 m) + p_phi^2/(2 m r^2) + V(r)" "(p_r² + p_φ²/r²)/(2 m) + V(r)"
        "\\frac{p_r^2}{2m} + \\frac{p_\\varphi^2}{2 m r^2} + V(r)"]
 [wrong "p_r^2/(2 m) + p_phi^2/(2 m r^2) - V(r)" "p_r^2/(2 m) + p_phi^2/(2 m) + V(r)"
        "p_r^2/(2 m) + V(r)" "p_r^2/(2 m) + p_phi^2/(m r^2) + V(r)"
        "1/2 m (r'^2 + r^2 phi'^2) + V(r)" "p_r^2/(2 m) - p_phi^2/(2 m r^2) + V(r)"
        "V(r)" "p_r^2/(2 m) + p_phi^2 r^2/(2 m) + V(r)"])

(table (an-exercise canonical ('coordinates 'q) ('key (lambda ((up t q p)) (up t p (- q)))))
 [right "(t, p, -q)" "[t, 2 q, p/2]" "(t, -p, q)" "(t, q, p + q^2)" "up(t, p, -q)" "(t, q + p, p)"]
 [wrong "(t, p, q)" "(t, 2 q, 2 p)" "(t, q, -p)" "(t, q^2, p)" "(p, -q)" "3" "q"]
 [trivial "(t, q, p)"]
 [failed "(t, p, -q"])

(table (an-exercise phase-function ('coordinates 'x 'y)
                    ('key (lambda ((up t (up x y) (down p_x p_y))) (+ (* x p_y) (* y p_x)))))
 [right "x p_y + y p_x" "y p_x + x p_y" "p_x y + p_y x" "{x p_y} + {y p_x}"]
 [wrong "x p_y - y p_x" "x p_y" "y p_x" "-x p_y - y p_x" "x p_x + y p_y" "2 (x p_y + y p_x)"
        "x p_y + y p_x + p_x p_y" "0" "x y' + y x'" "x p_y + y p_x + t"])

(table (an-exercise phase-function ('coordinates 'q) ('key (lambda ((up t q p)) (* 4 q p))))
 [right "4 q p" "4 p q" "2 q * 2 p" "4qp" "{q², p²} = 4 q p"]
 [wrong "-4 q p" "2 q p" "4 q" "4 p" "4 q p + q" "4 q^2 p^2" "4 q q'" "0"])

;; ---------------------------------------------------------------------------
;; By the teacher's own procedure

(table (an-exercise expects ('arguments 'x)
                    ('expects (lambda (answer) (verify-equal answer (square 'x)))))
 [right "x^2" "x²" "x x" "x**2"]
 [wrong "2 x" "x" "-x^2" "x^2 + 1" "x^3" "y^2"]
 [failed "x^"])

(test-case "there are 300 answers, at most 3 of 100 undecided"
  (define all (apply + (hash-values counts)))
  (check-true (>= all 300) (format "~a" all))
  (check-true (<= (hash-ref counts 'undecided 0) (* 3/100 all)) (format "~a" counts)))
