#lang racket/base
;; Formulas as people type them: what is read, what has two readings, what has none; all that our
;; printers write is read back; texts that mean no good end at once.

(require mechanics/algebra/notation/handwritten-formula
         mechanics/algebra/notation/infix
         (only-in mechanics/algebra/notation/one-line-name line-name->symbol)
         mechanics/generic/value-tree
         mechanics/show/typesetting/TeX
         (only-in mechanics read-expression verify-equal proved?)
         (only-in racket/string string-append*)
         "../../support/checks.rkt")

(define quantities '(t x y theta phi xdot thetadot m g l omega a_1 k_2 p_x r c alpha :pi))

(define words
  (vocabulary line-name->symbol
              (lambda (s) (cond [(memq s quantities) s] [(eq? s 'xdotdot) 'xddot] [else #f]))
              (lambda (s) (and (memq s '(V U up down)) #t))
              (lambda (s dots)
                (case s
                  [(x) (and (<= dots 2) (if (= dots 1) 'xdot 'xddot))]
                  [(theta) (and (= dots 1) 'thetadot)]
                  [else #f]))
              (lambda (d) (and (memq d '(x theta xdot xddot thetadot)) #t))))

;; -> the sides of each relation, why there are none, or the two readings
(define (reading text)
  (let/ec return
    (read-handwritten text words return (lambda (a b) (return (list 'either a b))))))

(define-syntax-rule (reads [text datum] ...)
  (begin (test-case text (check-equal? (reading text) '((datum)))) ...))

(reads
 ["½ m ẋ² − m g x" (+ (* 1/2 m (expt xdot 2)) (* -1 m g x))]
 ["1/2 m x'^2 - mgx" (+ (* 1/2 m (expt xdot 2)) (* -1 m g x))]
 ["r - +x" (+ r (* -1 x))]
 ["\\frac{1}{2} m \\dot{x}^2" (* 1/2 m (expt xdot 2))]
 ["\\frac12 m\\dot x^{2}" (* 1/2 m (expt xdot 2))]
 ["m*x'**2/2" (/ (* m (expt xdot 2)) 2)]
 ["m (g + x'') r" (* m (+ g xddot) r)] ["mx''" (* m xddot)] ["mẍ" (* m xddot)]
 ["d^2x/dt^2" xddot] ["\\frac{d\\theta}{dt}" thetadot] ["D²x(t)" xddot] ["x″(t)" xddot]
 ["sin theta" (sin theta)] ["sin 2θ" (sin (* 2 theta))] ["\\sin^2\\theta" (expt (sin theta) 2)]
 ["x sin t cos t" (* x (sin t) (cos t))] ["sin -t" (sin (* -1 t))] ["ln(x)" (log x)]
 ["sinh 1 sin t" (* (sinh 1) (sin t))] ["log10 x" (log x 10)]
 ["√2 x" (* (sqrt 2) x)] ["\\sqrt{g/l}" (sqrt (/ g l))] ["|x - y|" (abs (+ x (* -1 y)))]
 ["e^{-t}" (exp (* -1 t))] ["e^(-t)/c" (/ (exp (* -1 t)) c)] ["x^{a_1}y" (* (expt x a_1) y)]
 ["V(r)" (V r)] ["V(r + 1)" (V (+ r 1))] ["V'(r)" ((D V) r)] ["V²(r)" (expt (V r) 2)]
 ["m(r + 1)" (* m (+ r 1))] ["W(r)" (W r)] ["p_x^2/(2m)" (/ (expt p_x 2) (* 2 m))]
 ["(g/l) x" (* (/ g l) x)] ["m/2 (x + y)" (* (/ m 2) (+ x y))] ["k_{2} a₁" (* k_2 a_1)]
 ["x'' (t) + x (t)" (+ xddot x)]
 ["x(y + m)^2" (* x (expt (+ y m) 2))] ["r^2/2" (/ (expt r 2) 2)] ["r^3/3" (/ (expt r 3) 3)]
 ["3·10^8 m" (* 3 (expt 10 8) m)] ["2e3" 2000.0] ["\\varphi \\cdot \\pi" (* phi :pi)]
 ["a_1**c**x" (expt a_1 (expt c x))] ["a_1**c/m" (/ (expt a_1 c) m)] ["W(2)" (W 2)]
 ["m*1/2 x" (* (/ (* m 1) 2) x)] ["\\hbar t" (* hbar t)] ["D²W(t)" (((expt D 2) W) t)]
 ["[x, (y, t)]" (up x (up y t))] ["ω t" (* omega t)] ["omegat" (* omega t)])

(test-case "relations, and lists without parentheses"
  (check-equal? (reading "x = y, t") '((x y) (t)))
  (check-equal? (reading "x == 1; [x = y, t]") '((x 1) ((up (= x y) t)))))

(define-syntax-rule (unclear [text a b] ...)
  (begin (test-case text (check-equal? (reading text) '(either a b))) ...))

(unclear
 ["1/2x" (* 1/2 x) (/ 1 (* 2 x))]
 ["g/l x" (* (/ g l) x) (/ g (* l x))]
 ["x^2/2m" (* (/ (expt x 2) 2) m) (/ (expt x 2) (* 2 m))]
 ["sin x/2" (/ (sin x) 2) (sin (/ x 2))]
 ["sin omega t" (* (sin omega) t) (sin (* omega t))]
 ["sin x^2" (expt (sin x) 2) (sin (expt x 2))]
 ["sqrt 2 x" (* (sqrt 2) x) (sqrt (* 2 x))]
 ["x^(c)^y" (expt (expt x c) y) (expt x (expt c y))]
 ["W(r)(x)" (* (W r) x) ((W r) x)]
 ["W(-1)" (* W -1) (W -1)]
 ["√g/l" (/ (sqrt g) l) (sqrt (/ g l))]
 ["e^-t/c" (/ (exp (* -1 t)) c) (exp (/ (* -1 t) c))]
 ["e^-2 t" (* (exp -2) t) (exp (* -2 t))]
 ["r^3/2" (/ (expt r 3) 2) (expt r 3/2)]
 ["x^-1/2" (/ (expt x -1) 2) (expt x -1/2)]
 ["x^1/2" (/ (expt x 1) 2) (expt x 1/2)]
 ["x^2y" (* (expt x 2) y) (expt x (* 2 y))]
 ["x^y^2" (expt (expt x y) 2) (expt x (expt y 2))]
 ["f(x + 1)" (* f (+ x 1)) (f (+ x 1))]
 ["x(t - 1)" (* x (+ t -1)) (x (+ t -1))]
 ["x'(0)" (* xdot 0) (xdot 0)])

(test-case "a word that can be cut in two ways is not clear"
  (define names '(ab c a bc))
  (define words
    (vocabulary line-name->symbol (lambda (s) (and (memq s names) s))
                (lambda _ #f) (lambda _ #f) (lambda _ #f)))
  (check-equal? (let/ec return
                  (read-handwritten "abc" words void (lambda (a b) (return (list a b)))))
                '((* a bc) (* ab c))))

(define-syntax-rule (refused [text why] ...)
  (begin (test-case text (check-equal? (reading text) why)) ...))

(refused
 ["1,5 x" (string-append "1,5 has two readings: the number 1.5, which is written with a point, and "
                         "the list 1, 5, which has a space behind the comma")]
 ["sin^-1 x" "sin^-1 has two readings: the inverse, asin, and one over it, 1/sin"]
 ["x 2" "2 behind a factor: a sign is missing between them"]
 ["x^{r, c}" ", cannot stand there"] ["x^(r, c)" ", cannot stand there"]
 ["x'''" "x has more than two primes"]
 ["sintheta" "in sintheta a space is missing behind sin"]
 ["d/dt(m x')" "d/dt of a formula is not read: carry the derivative out"]
 ["\\frac{d}{dt} (m x')" "d/dt of a formula is not read: carry the derivative out"]
 ["sin" "sin has no argument"]
 ["x +" "it ends where something has to follow"] ["" "it ends where something has to follow"]
 ["(x" "a parenthesis is not closed"]
 ["x)" ") cannot stand there"]
 ["x ± y" "± y is no sign of a formula"] ["\\foo x" "\\foo x is no sign of a formula"])

;; ---------------------------------------------------------------------------
;; Printed lines

(define (one-of xs) (list-ref xs (random (length xs))))

(define (random-datum n)
  (define (part) (random-datum (- n 1)))
  (if (or (= n 0) (< (random) 0.15))
      (one-of (append '(1 2 3 7 10 -1 -2 1/2 3/4 -2/3) quantities))
      (case (random 9)
        [(0 1) (list '+ (part) (part) (part))]
        [(2 3) (list '* (part) (part) (part))]
        [(4) (list '/ (part) (part))]
        [(5) (list 'expt (part) (one-of '(2 3 -1 -2 1/2 c)))]
        [(6) (list '- (part) (part))]
        [(7) (list (one-of '(sin cos tan exp sqrt log abs sinh)) (part))]
        [else (list (one-of '(V U)) (part))])))

(define (value-of d) (with-handlers ([exn:fail? (lambda (e) #f)]) (read-expression d)))

;; Is each text read as what is printed the same?  -> how many of n texts have two readings
(define (round-trip n seed print)
  (random-seed seed)
  (for/sum ([_ (in-range n)])
    (define x (value-of (random-datum (+ 1 (random 4)))))
    (define text (if x (print x) "x"))
    (define r (reading text))
    (cond [(and (pair? r) (eq? 'either (car r))) 1]
          [else
           (define y (value-of (caar r)))
           (check-true (or (equal? (print y) text) (proved? (verify-equal x y)))
                       (format "seed ~a: ~a" seed text))
           0])))

(test-case "10,000 formulas are read back as they were printed"
  (check-equal? (round-trip 5000 2 (lambda (x) (tree->TeX (value->tree x #t)))) 0)
  ;; √g/l, of the printer's (√g)/l
  (check-true (< (round-trip 5000 1 (lambda (x) (tree->line (value->tree x #f)))) 25)))

;; ---------------------------------------------------------------------------
;; Texts that mean no good

(define (repeated text n) (string-append* (for/list ([_ (in-range n)]) text)))

(test-case "what is nested too deeply is refused"
  (for ([open '("(" "{" "[" "|" "sin(" "V(" "\\sqrt{" "\\frac{")])
    (check-equal? (reading (repeated open 400)) "its parts are nested too deeply" open)))

(test-case "a long text ends, whatever is repeated in it"
  (for ([piece '("x" "mgl" "ab" "1" "x^" "x'" "d x/dt" "\\dot" "\\frac{d " "_" "sin" "½" "~" "-"
                     "e^" "& " "x(t" "|x" "\\" "\u307")])
    (define r (reading (repeated piece 800)))
    (check-true (or (pair? r) (string? r)) piece)))

(test-case "parentheses behind coordinates are read once, however deep"
  (define (nested n) (if (= n 0) "y" (string-append "x(" (nested (- n 1)) ")")))
  (check-equal? (reading (nested 2)) '(((* x x y))))
  (check-equal? (length (caar (reading (nested 50)))) 52))
