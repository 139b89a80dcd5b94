#lang racket/base
;; The steps from a path to the residual: their labels, their values, and what is
;; said when there is nothing to derive.

(require mechanics "../../support/checks.rkt")

(define x (literal-function 'x))
(define (L (up t q v)) (- (* 1/2 'm (square v)) (* 1/2 'k (square q))))
(define (L-acceleration (up t q v a)) (* 1/2 'm (square a)))

(define-check (check-step steps label value)
  (define found (assoc label steps))
  (unless (and found (equal? (expression (cdr found)) value))
    (with-check-info (['label label] ['found (and found (expression (cdr found)))])
      (fail-check))))

(test-case "every step of a first-order Lagrangian has its label and simplified value"
  (define steps (derivation-steps (Lagrange-equations L) x))
  (check-equal? (length steps) 6)
  (check-step steps '(Gamma q) '(up t (x t) ((D x) t)))
  (check-step steps '(compose ((partial 1) L) (Gamma q)) '(* -1 k (x t)))
  (check-step steps '(compose ((partial 2) L) (Gamma q)) '(* m ((D x) t)))
  (check-step steps '(D (compose ((partial 2) L) (Gamma q))) '(* m (((expt D 2) x) t)))
  (check-step steps '((Lagrange-equations L) q)
              '(+ (* k (x t)) (* m (((expt D 2) x) t)))))

(test-case "a Lagrangian of higher order wants longer local tuples, and the labels say so"
  (define steps (derivation-steps (Lagrange-equations L-acceleration #:order 2) x))
  (check-step steps '(Gamma q 4) '(up t (x t) ((D x) t) (((expt D 2) x) t)))
  (check-step steps '((expt D 2) (compose ((partial 3) L) (Gamma q 4)))
              '(* m (((expt D 4) x) t))))

(test-case "a force is a step of its own"
  (define (drag local) (* -1 'b (velocity local)))
  (define steps (derivation-steps (Lagrange-equations L #:force drag) x))
  (check-step steps '(compose force (Gamma q)) '(* -1 b ((D x) t))))

(test-case "the steps may be taken at another time"
  (check-step (derivation-steps (Lagrange-equations L) x 0) '(Gamma q) '(up 0 (x 0) ((D x) 0))))

(define (shown show)
  (define port (open-output-string))
  (parameterize ([current-output-port port])
    (show))
  (get-output-string port))

(test-case "the steps are shown one below the other, then what they assumed, once"
  (define (L-distance (up t (up x y) v)) (* -1 (sqrt (square x))))
  (define text
    (shown (lambda ()
             (show-derivation (Lagrange-equations L-distance) (up x (literal-function 'y))))))
  (check-regexp-match #rx"^\\(\\(Gamma q\\) t\\)\n  \\(up t \\(up \\(x t\\) \\(y t\\)\\)" text)
  (check-regexp-match
   #rx"\n\\(\\(\\(Lagrange-equations L\\) q\\) t\\)\n  \\(down 1 0\\)\n; assuming"
   text)
  (check-equal? (length (regexp-match* #rx"assuming \\(>= \\(x t\\) 0\\)\n" text)) 1))

(test-case "mistakes are reported in the name of what was called"
  (for ([derive (in-list (list derivation-steps show-derivation))]
        [name (in-list '("derivation-steps" "show-derivation"))])
    (check-exn
     (pregexp (string-append "^" name ": expected .Lagrange-equations L."))
     (lambda () (derive L x)))
    (check-exn (pregexp (string-append "^" name ": a path is a function of time"))
               (lambda () (derive (Lagrange-equations L) 'x)))))

;; ---------------------------------------------------------------------------
;; From Newton's equations

(define (pendulum t theta) (up (* 'l (sin theta)) (* -1 'l (cos theta))))
(define (weight t r v) (up 0 (* -1 'm 'g)))
(define newton (d-Alembert-equations 'm pendulum weight))

(test-case "what Newton's equations are made of is shown before what is left of them"
  (define steps (derivation-steps newton x))
  (check-step steps 'positions '(up (* l (sin (x t))) (* -1 l (cos (x t)))))
  (check-step steps '(D positions) '(up (* l (cos (x t)) ((D x) t)) (* l (sin (x t)) ((D x) t))))
  (check-step steps 'slopes '(up (* l (cos (x t))) (* l (sin (x t)))))
  (check-step steps 'forces '(up 0 (* -1 g m)))
  (check-step steps '(compose (generalized-force r F) (Gamma q)) '(* -1 g l m (sin (x t))))
  (check-step steps '(compose (kinetic-energy masses r) (Gamma q))
              '(* 1/2 (expt l 2) m (expt ((D x) t) 2)))
  (check-step steps '((d-Alembert-equations masses r F) q)
              '(+ (* g l m (sin (x t))) (* (expt l 2) m (((expt D 2) x) t)))))

(test-case "a mistake about the path of particles is reported in that name, too"
  (check-exn #rx"^derivation-steps: a path is a function of time"
             (lambda () (derivation-steps newton 'x)))
  (check-exn #rx"^show-derivation: a path is a function of time"
             (lambda () (show-derivation newton 'x)))
  (check-exn #rx"^derivation-steps: the forces must be like the positions\n"
             (lambda ()
               (derivation-steps (d-Alembert-equations 'm pendulum (lambda (t r v) 'F)) x))))

(define (verdicts-of masses r F q)
  (for/list ([s (derivation-steps (d-Alembert-equations masses r F) q)] #:when (verdict? (cdr s)))
    (cdr s)))

(test-case "each identity on the way to Lagrange's equations is proved, for any positions and force"
  (define (verdicts . system) (map verdict-status (apply verdicts-of system)))
  (define space '(UP Real Real Real))
  (define (position name) (literal-function name (-> (X Real (UP Real Real)) space)))
  (define (force shape) (literal-function 'F (-> (X Real shape shape) shape)))
  (define q (up x (literal-function 'y)))
  (define all-proved '(proved proved proved proved proved))
  (check-equal? (verdicts 'm pendulum weight x) all-proved)
  (check-equal? (verdicts 'm (position 'r) (force space) q) all-proved)
  (check-equal? (verdicts '(m M) (lambda (t q) (up ((position 'r) t q) ((position 's) t q)))
                          (force (UP* space 2)) q)
                all-proved))

(test-case "where the roundings of a system's decimals stand in the way, the verdict tells them"
  (define (wire t q) (up (* 0.1 (sin (* 1.7 q))) (* 0.1 (cos (* 1.7 q)))))
  (for ([v (list-tail (verdicts-of 2.5 wire (lambda (t r v) (* -0.3 r)) x) 3)])
    (check-regexp-match #rx"0.0425" (format "~a" v))))

(test-case "they are printed with their verdicts"
  (define text
    (let ([port (open-output-string)])
      (parameterize ([current-output-port port]) (show-derivation newton x))
      (get-output-string port)))
  (check-regexp-match #rx"\\(slopes t\\)\n  \\(up " text)
  (check-regexp-match #rx"\\(= \\(D slopes\\) \\(\\(partial 1\\) velocities\\)\\)\n  proved: "
                      text))
