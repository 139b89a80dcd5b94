#lang racket/base
;; A line is read back as the expression it was written from: it has the
;; same value everywhere, and is written alike again.
;;
;; `racket tests/mechanics/algebra/notation/read-infix.rkt 10000` is a long run.

(require mechanics/algebra/expression/expression
         mechanics/algebra/expression/read
         mechanics/algebra/notation/formula
         mechanics/algebra/notation/infix
         mechanics/algebra/notation/read-infix
         "../../support/checks.rkt" "../../support/read-back.rkt")

(define (line e) (tree->line (datum->tree (expression->datum e) (current-way #f #t))))

;; -> how many values could be compared
(define (check-random count seed)
  (random-seed seed)
  (for/sum ([k (in-range count)])
    (check-one (random-formula) k)))

(define (check-one e k)
  (define text (line e))
  (with-check-info (['expression e] ['text text])
    (define datum (infix->datum text))
    (check-equal? (tree->line (datum->tree datum (current-way #f #t))) text)
    (define v (value-of e k))
    (define w (value-of (datum->expression datum) k))
    (cond [(and v w)
           (check-true (close? v w) (format "~a and ~a" v w))
           1]
          [else 0])))

(define (check-many count seed)
  (define compared (check-random count seed))
  (check-true (> compared (* 0.6 count)) (format "~a of ~a had values" compared count))
  compared)

(test-case "random expressions are read back"
  (void (check-many 400 20250101)))

(test-case "a reader that is wrong about a sign, an exponent or a bar would be noticed"
  (define (differ a b)
    (check-false (close? (value-of (datum->expression a) 1) (value-of (datum->expression b) 1))))
  (differ '(- a b) '(+ a b))
  (differ '(expt a 2) '(expt a 3))
  (differ '(/ a (* b c)) '(* (/ a b) c)))

;; ---------------------------------------------------------------------------
;; To the letter

(define-syntax-rule (reads [text datum] ...)
  (begin (test-case text (check-equal? (infix->datum text) 'datum)) ...))

(reads
 ["½ m ẋ² − m g x" (+ (* 1/2 m (expt xdot 2)) (* -1 m g x))]
 ["m D²x(t)" (* m (((expt D 2) x) t))]
 ["∂₀∂_(1,0)²F(x, y)" (((* (partial 0) (expt (partial 1 0) 2)) F) x y)]
 ["a b/(c d)" (/ (* a b) (* c d))]
 ["sin θ cos² φ" (* (sin theta) (expt (cos phi) 2))]
 ["sin(θ)²" (expt (sin theta) 2)]
 ["x (t)" (* x t)]
 ["x(t)" (x t)]
 ["√2 √(x + 1)" (* (sqrt 2) (sqrt (+ x 1)))]
 ["1.5×10⁻¹⁰ + 2.5" (+ 1.5e-10 2.5)]
 ["e^(−γ t)" (expt e (* -1 gamma t))]
 ["[1, a; 0, up(x, down())]" (matrix-by-rows (list 1 a) (list 0 (up x (down))))]
 ["a − (b − c)" (+ a (* -1 (+ b (* -1 c))))]
 ["m > 0" (> m 0)]
 ["a + b 𝐢 − 𝐤" (quaternion a b 0 -1)]
 ["x ↦ 1 − (a + b) x² + x³/c" (power-series 1 0 (* -1 (+ a b)) (/ 1 c))]
 ["x ↦ 1 − x" (power-series 1 -1)]
 ["(3/7)i" 0+3/7i]
 ["a - b" (+ a (* -1 b))]
 ["x^2 + v^x" (+ x^2 v^x)])

;; As people type it
(reads
 ["1/2*m*v**2 - m*g*h" (+ (* 1/2 m (expt v 2)) (* -1 m g h))]
 ["a/b*c" (* (/ a b) c)]
 ["a*b/c*d" (* (/ (* a b) c) d)]
 ["a/b*c d" (* (/ a b) c d)]
 ["x ^ -1" (expt x -1)]
 ["2*pi*sqrt(l/g)" (* 2 :pi (sqrt (/ l g)))]
 ["a**b**c" (expt a (expt b c))]
 ["2*-x + a - -b" (+ (* 2 (* -1 x)) a b)]
 ["2(a+b) - .5e-3*x" (+ (* 2 (+ a b)) (* -5e-4 x))]
 ["(x + y)^2" (expt (+ x y) 2)]
 ["sin**2 (x)" (* (expt sin 2) x)]
 ["sin**2(x) + sin(x)^2" (+ (expt (sin x) 2) (expt (sin x) 2))])

(module+ main
  (require racket/cmdline)
  (command-line
   #:args ([count "10000"])
   (printf "~a values compared\n" (check-many (string->number count) (random 1000000)))))

(test-case "what is said of a sign is written as a relation to 0"
  (for ([d (in-list '((positive m) (negative x) (nonnegative (+ x 1)) (nonpositive x)))]
        [text (in-list '("m > 0" "x < 0" "x + 1 ≥ 0" "x ≤ 0"))])
    (check-equal? (tree->line (plain-datum->tree d)) text)))
