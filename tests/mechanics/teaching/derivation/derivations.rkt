#lang racket/base
;; Derivations of Legendre transforms, coordinate transformations, forces, multipliers and
;; conserved quantities: every line is proved, and a wrong claim is not.

(require mechanics
         (only-in mechanics/teaching/derivation/step-by-step derivation derivation-lines make-step
                  step-label step-value step-verdict)
         "../../support/checks.rkt" "../../support/messages.rkt" "../../support/session.rkt"
         (only-in racket/port with-output-to-string))

(define V (literal-function 'V))
(define (L-central local)
  (define-values (q v) (values (coordinate local) (velocity local)))
  (- (* 1/2 'm (+ (square (ref v 0)) (square (* (ref q 0) (ref v 1))))) (V (ref q 0))))
(define (L-plane local)
  (- (* 1/2 'm (square (velocity local))) (V (square (coordinate local)))))
(define (L-falling local)
  (- (* 1/2 'm (square (velocity local))) (* 'm 'g (ref (coordinate local) 1))))

(define (H-moving s)
  (+ (/ (square (momentum s)) (* 2 'm))
     ((literal-function 'V (-> (X Real Real) Real)) (- (ref (coordinate s) 0) (* 'c (time s)))
                                                    (ref (coordinate s) 1))))

(define polar (up 't (up 'r 'phi) (up 'rdot 'phidot)))
(define plane (up 't (up 'x 'y) (up 'xdot 'ydot)))

(define ((turned s) local)
  (define q (coordinate local))
  (up (- (* (cos s) (ref q 0)) (* (sin s) (ref q 1)))
      (+ (* (sin s) (ref q 0)) (* (cos s) (ref q 1)))))
(define ((shifted s) local) (+ (coordinate local) (up s 0)))

(define (on-circle t q) (up (* 'l (sin q)) (* -1 'l (cos q))))
(define (weight t r v) (up 0 (* -1 'm 'g)))
(define circle (holonomic (lambda (t q) (- (square q) (square 'l)))))

(define Legendre (derive-Legendre-transform L-central (up 't (up 'r 'phi) (down 'p_r 'p_phi))))

(define all
  (list Legendre
        (derive-F->C p->r polar)
        (derive-generalized-force on-circle weight (up 't 'theta 'thetadot))
        (derive-multipliers L-falling circle plane)
        (derive-Noether-integral L-plane turned plane)
        (derive-Hamilton-equations H-moving (up 't (up 'x 'y) (down 'p_x 'p_y)))))

(define (value-of d label)
  (for/first ([s (in-list (derivation-lines d))] #:when (equal? (step-label s) label))
    (step-value s)))

(test-case "every line has a verdict, and is proved"
  (for* ([d (in-list all)] [s (in-list (derivation-lines d))])
    (check-true (proved? (step-verdict s)) (format "~s" (step-label s)))))

(test-case "the results are those of the book"
  (check-equal? (value-of Legendre '((partial 2) H))
                (simplify (up (/ 'p_r 'm) (/ 'p_phi (* 'm (square 'r))))))
  (check-equal? (value-of (cadr all) '(+ ((partial 0) F) (* ((partial 1) F) v)))
                (simplify (velocity ((F->C p->r) polar))))
  (check-equal? (value-of (cadr all) '((partial 1) F))
                (down (up (cos 'phi) (sin 'phi))
                      (up (* -1 'r (sin 'phi)) (* 'r (cos 'phi)))))
  (check-equal? (value-of (caddr all) '(* F ((partial 1) r)))
                (simplify (* -1 'g 'l 'm (sin 'theta))))
  (check-equal? (value-of (list-ref all 5) '((partial 2) H))
                (simplify (up (/ 'p_x 'm) (/ 'p_y 'm))))
  (check-equal? (value-of (list-ref all 4) '(* ((partial 2) L) ((D F) 0)))
                (simplify (* 'm (- (* 'x 'ydot) (* 'y 'xdot))))))

(test-case "a force that grows is in the Hamiltonian's rate"
  (define (L-pushed s) (+ (* 1/2 'm (square (velocity s))) (* 'f (time s) (coordinate s))))
  (define d (derive-Legendre-transform L-pushed (up 't 'x 'p)))
  (check-equal? (value-of d '((partial 0) H)) (* -1 'f 'x))
  (check-equal? (value-of d '((partial 1) H)) (* -1 'f 't)))

;; A ring of radius R whose centre moves upwards at c, and a wire that turns at Ω
(define (risen t q) (up (* 'R (cos q)) (+ (* 'c t) (* 'R (sin q)))))
(define (on-turning-wire local)
  (define angle (* 'Omega (time local)))
  (* (coordinate local) (up (cos angle) (sin angle))))

(test-case "coordinates that move: what their own motion adds to velocities does no work"
  (define force (derive-generalized-force risen (lambda (t r v) (up 'X 'Y)) (up 't 'q 'v)))
  (define wire (derive-F->C on-turning-wire (up 't 'r 'rdot)))
  (for* ([d (list force wire)] [s (derivation-lines d)])
    (check-true (proved? (step-verdict s)) (format "~s" (step-label s))))
  (check-identity (value-of force '(* F ((partial 1) r)))
                  (- (* 'R 'Y (cos 'q)) (* 'R 'X (sin 'q))))
  (check-identity (value-of wire '((partial 0) F))
                  (* 'r 'Omega (up (- (sin (* 'Omega 't))) (cos (* 'Omega 't)))))
  (check-identity (square (value-of wire '(+ ((partial 0) F) (* ((partial 1) F) v))))
                  (+ (square 'rdot) (square (* 'r 'Omega)))))

(test-case "what is no symmetry is refuted, on the line that claims it and on that of the integral"
  (define d (derive-Noether-integral L-plane shifted plane))
  (define verdicts (map step-verdict (derivation-lines d)))
  (check-true (refuted? (car verdicts)))
  (check-true (refuted? (cadddr verdicts)))
  (check-regexp-match #rx"refuted: it leaves" (->infix d)))

(define (shown . arguments)
  (with-output-to-string (lambda () (apply show-derivation arguments))))

(test-case "a derivation is shown in every format"
  (check-equal? (shown (derivation (list (make-step 'p (* 'm 'v)))))
                "p\n  (* m v)\n  proved\n")
  (define d (derivation (list (make-step '((partial 0) H) (* 'm (square 'v))))))
  (define (as format) (with-output-to-string (lambda () (show-derivation d #:as format))))
  (check-equal? (as 'infix) "∂₀H = m v²; proved\n")
  (check-equal? (as 'text) "∂₀H = m v²\n  proved\n")
  (check-equal? (as 'TeX)
                (string-append "\\begin{array}{l}\\hspace{0em}"
                               "\\displaystyle \\partial_{0} H=m\\,v^{2}"
                               "\\\\\\hspace{2em}\\text{proved}\\end{array}\n"))
  (check-regexp-match #rx"^<math .*</math>\n$" (as 'MathML))
  (define assumed
    (assuming ('(> x 0)) (make-step 'p (* 'm 'x) (verify-equal (sqrt (square 'x)) 'x))))
  (check-equal? (with-output-to-string
                 (lambda () (show-derivation (derivation (list assumed)) #:as 'text)))
                "p = m x\n  proved\n  assuming x > 0\n"))

(test-case "the steps to Lagrange's equations, typeset, have a verdict each"
  (define x (literal-function 'x))
  (define (L local) (- (* 1/2 'm (square (velocity local))) (* 1/2 'k (square (coordinate local)))))
  (define text
    (with-output-to-string (lambda () (show-derivation (Lagrange-equations L) x #:as 'text))))
  (check-regexp-match #rx"\\(∂₂L ∘ Γ\\(q\\)\\)\\(t\\) = m ẋ\\(t\\)\n  proved\n" text)
  (check-equal? (length (regexp-match* #rx"\n  proved" text)) 6))

(says
 [(derive-Hamilton-equations 3 (up 't 'q 'p))
  "derive-Hamilton-equations: a Hamiltonian is a function of the state (up t q p); "
  "given the number 3"]
 [(derive-Hamilton-equations H-moving 't)
  "derive-Hamilton-equations: expected a state of symbols, (up 't 'q 'v)\n  given: the symbol t"]
 [(derive-Legendre-transform L-falling 't)
  "derive-Legendre-transform: expected a state of symbols, (up 't 'q 'v)\n  given: the symbol t"]
 [(derive-multipliers L-falling 3 plane)
  "derive-multipliers: expected a constraint, (holonomic G) or (nonholonomic A), "
  "or a list of them\n  given: the number 3"]
 [(derive-F->C p->r 't)
  "derive-F->C: expected a state of symbols, (up 't 'q 'v)\n  given: the symbol t"]
 [(derive-F->C p->r (up 't (up 'r 'phi) (up 'rdot 'phidot) (up 'a 'b)))
  "derive-F->C: expected a state of symbols, (up 't 'q 'v)\n"
  "  given: (up t (up r phi) (up rdot phidot) (up a b)), an up tuple of 4"]
 [(derive-F->C p->r (down 't 'q 'v))
  "derive-F->C: expected a state of symbols, (up 't 'q 'v)\n"
  "  given: (down t q v), a down tuple of 3"]
 [(show-derivation (Lagrange-equations L-plane))
  "show-derivation: needs the path: (show-derivation (Lagrange-equations L) q)"]
 [(show-derivation Legendre #:as 'PDF)
  "show-derivation: there is no such style\n"
  "  styles: 'automatic, 'typeset, 'text, 'infix, 'TeX, 'MathML, 'expression\n  given: 'PDF"]
 [(print-expression 'x #:as 'PDF)
  "print-expression: there is no such style\n"
  "  styles: 'automatic, 'typeset, 'text, 'infix, 'TeX, 'MathML, 'expression\n  given: 'PDF"])
