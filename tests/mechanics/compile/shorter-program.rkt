#lang racket/base
;; Programs made shorter: how short, beside lists written by hand, and that values stay.

(require racket/flonum
         racket/list
         (except-in mechanics trace)
         mechanics/compile/closures
         mechanics/compile/program
         mechanics/compile/shorter-program
         mechanics/compile/trace
         "../bench/motion-systems.rkt"
         "../support/checks.rkt" "../support/random.rkt")

(define (traced f state)
  (define-values (p _) (trace 'test f state))
  p)

(define (values-of p input)
  (define output (make-flvector (vector-length (program-outputs p))))
  (((program->closure-maker p)) input output)
  output)

(define (check-close p q input tolerance)
  (with-check-info (['input input] ['program p] ['other q])
    (for ([x (in-flvector (values-of p input))] [y (in-flvector (values-of q input))])
      (check-within y x (* tolerance (+ 1.0 (abs x)))))))

;; ---------------------------------------------------------------------------
;; Lists by hand: steps (name (operation operand ...)), operands by name

(define (by-hand inputs steps outputs)
  (define places
    (for/hasheq ([name (in-list (append inputs (map car steps)))] [k (in-naturals)])
      (values name (place k))))
  (define (of x) (hash-ref places x x))
  (program (length inputs)
           (for/vector ([s (in-list steps)]) (cons (caadr s) (map of (cdadr s))))
           (for/vector ([o (in-list outputs)]) (of o))))

;; The shorter program of f has at most so many instructions and the values of that by hand.
(define (check-length name f state by-hand-list by-hand-length most)
  (test-case name
    (define p (shorter-program (traced f state)))
    (check-equal? (program-length by-hand-list) by-hand-length)
    (check <= (program-length p) most)
    (with-seeds 20
      (define input (for/flvector ([_ (in-range (program-inputs p))]) (random-flonum)))
      (check-close by-hand-list p input 1e-11))))

(define g 9.8)
(define frequency (last driven-parameters))

(check-length "the driven pendulum" (apply driven-pendulum driven-parameters) (up 0.0 1.0 0.0)
  (by-hand '(t angle v)
           `((a (multiply ,frequency t))
             (b (cos a))
             (c (multiply ,(* 0.1 frequency frequency) b))
             (d (subtract c ,g))
             (s (sin angle))
             (e (multiply d s)))
           '(1 v e))
  6 7)

(check-length "Hénon and Heiles's potential" Henon-Heiles (Henon-Heiles-start 1/12 0.1 0.0)
  (by-hand '(t x y px py)
           '((a (multiply x y))
             (b (multiply -2.0 a))
             (c (subtract b x))
             (d (multiply x x))
             (e (multiply y y))
             (f (subtract e d))
             (h (subtract f y)))
           '(1 px py c h))
  7 7)

;; Forces along cyclic differences, with one root for each pair
(define (three-bodies-by-hand-list)
  (define (name . parts) (string->symbol (apply string-append (map ~a parts))))
  (define (~a x) (if (symbol? x) (symbol->string x) (number->string x)))
  (define pairs '((0 1) (1 2) (2 0)))
  (define masses '(1.0 1e-3 3e-4))
  (define (of-pair i j)
    (define (d c) (name 'd i c))
    (append
     (for/list ([c '(x y z)]) `(,(d c) (subtract ,(name 'q j c) ,(name 'q i c))))
     (for/list ([c '(x y z)]) `(,(name 's i c) (multiply ,(d c) ,(d c))))
     `((,(name 'a i) (add ,(name 's i 'x) ,(name 's i 'y)))
       (,(name 'b i) (add ,(name 'a i) ,(name 's i 'z)))
       (,(name 'r i) (sqrt ,(name 'b i)))
       (,(name 'p i) (multiply ,(name 'b i) ,(name 'r i)))
       (,(name 'f i) (divide ,(* (list-ref masses i) (list-ref masses j)) ,(name 'p i))))
     (for/list ([c '(x y z)]) `(,(name 'F i c) (multiply ,(name 'f i) ,(d c))))))
  (define (of-body i)
    (define before (modulo (- i 1) 3))
    (append*
     (for/list ([c '(x y z)])
       (define sum `(,(name 'S i c) (subtract ,(name 'F i c) ,(name 'F before c))))
       (if (= i 0)
           (list sum)
           (list sum `(,(name 'A i c) (multiply ,(/ (list-ref masses i)) ,(name 'S i c))))))))
  (define (components letter) (for*/list ([i '(0 1 2)] [c '(x y z)]) (name letter i c)))
  (by-hand (cons 't (append (components 'q) (components 'v)))
           (append (append-map (lambda (p) (apply of-pair p)) pairs) (append-map of-body '(0 1 2)))
           (cons 1 (append (components 'v)
                           (for*/list ([i '(0 1 2)] [c '(x y z)]) (name (if (= i 0) 'S 'A) i c))))))

(check-length "three bodies in space" three-bodies three-bodies-start
  (three-bodies-by-hand-list) 57 60)

;; A = 1, C = 1/2, gMR = 1
(define ((L-top A C gMR) (up t (up theta phi psi) (up thetadot phidot psidot)))
  (- (+ (* 1/2 A (+ (square thetadot) (square (* phidot (sin theta)))))
        (* 1/2 C (square (+ (* phidot (cos theta)) psidot))))
     (* gMR (cos theta))))

(check-length "a top" (Lagrangian->state-derivative (L-top 1.0 0.5 1.0))
  (up 0.0 (up 1.0 0.0 0.0) (up 0.1 0.1 0.1))
  (by-hand '(t theta phi psi thetadot phidot psidot)
           '((s (sin theta))
             (c (cos theta))
             (a (multiply phidot c))
             (w (add a psidot))
             (h (multiply 0.5 w))
             (b (subtract a h))
             (e (multiply phidot b))
             (f (add 1.0 e))
             (thetadotdot (multiply s f))
             (i (subtract h a))
             (j (subtract i a))
             (k (multiply j thetadot))
             (phidotdot (divide k s))
             (l (multiply phidot thetadot))
             (m (multiply l s))
             (n (multiply phidotdot c))
             (psidotdot (subtract m n)))
           '(1 thetadot phidot psidot thetadotdot phidotdot psidotdot))
  17 26)

;; Euler's equations, which no rewriting of the Lagrangian's accelerations finds.
(check-length "a rigid body in Euler angles" (rigid-body) rigid-body-start
  (let ([A 1.0] [B (sqrt 2.0)] [C 2.0])
    (by-hand '(t theta phi psi vt vf vs)
             `((st (sin theta)) (ct (cos theta)) (ss (sin psi)) (cs (cos psi))
               (a (multiply vf st)) (a1 (multiply a ss)) (a2 (multiply vt cs)) (wa (add a1 a2))
               (b1 (multiply a cs)) (b2 (multiply vt ss)) (wb (subtract b1 b2))
               (c1 (multiply vf ct)) (wc (add c1 vs))
               (ra0 (multiply wb wc)) (ra (multiply ,(/ (- B C) A) ra0))
               (rb0 (multiply wc wa)) (rb (multiply ,(/ (- C A) B) rb0))
               (rc0 (multiply wa wb)) (rc (multiply ,(/ (- A B) C) rc0))
               (p1 (multiply vs wb)) (p (subtract ra p1))
               (q1 (multiply vs wa)) (q (add rb q1))
               (d1 (multiply p cs)) (d2 (multiply q ss)) (e (subtract d1 d2))
               (f1 (multiply p ss)) (f2 (multiply q cs)) (f (add f1 f2))
               (h1 (multiply vt c1)) (h2 (subtract f h1)) (h (divide h2 st))
               (i1 (multiply vt a)) (i2 (add rc i1)) (i3 (multiply h ct)) (i (subtract i2 i3)))
             '(1 vt vf vs e h i)))
  36 98)

;; Of two links, m = l = 1
(check-length "a double pendulum" (released-chain 2) (released-chain-start 2)
  (by-hand '(t x y v w)
           `((d (subtract x y))
             (s (sin d))
             (c (cos d))
             (sx (sin x))
             (sy (sin y))
             (vv (multiply v v))
             (ww (multiply w w))
             (a (multiply ,(* -2 g) sx))
             (b (multiply s ww))
             (right1 (subtract a b))
             (e (multiply ,(- g) sy))
             (f (multiply s vv))
             (right2 (add e f))
             (h (multiply c right2))
             (i (subtract right1 h))
             (cc (multiply c c))
             (m (subtract 2.0 cc))
             (aa (divide i m))
             (j (multiply c aa))
             (bb (subtract right2 j)))
           '(1 v w aa bb))
  20 27)

(define mu 0.01)

(define (restricted-problem s)
  (define-values (x y) (values (ref s 1 0) (ref s 1 1)))
  (define-values (vx vy) (values (ref s 2 0) (ref s 2 1)))
  (define r1 (sqrt (+ (square (+ x mu)) (square y))))
  (define r2 (sqrt (+ (square (- x (- 1 mu))) (square y))))
  (up 1
      (ref s 2)
      (up (- (+ (* 2 vy) x)
             (+ (/ (* (- 1 mu) (+ x mu)) (cube r1)) (/ (* mu (- x (- 1 mu))) (cube r2))))
          (- y (+ (* 2 vx) (/ (* (- 1 mu) y) (cube r1)) (/ (* mu y) (cube r2)))))))

(check-length "the restricted problem of three bodies" restricted-problem
  (up 0.0 (up 0.5 0.0) (up 0.0 1.0))
  (by-hand '(t x y vx vy)
           `((a (add x ,mu))
             (b (add x ,(- mu 1.0)))
             (yy (multiply y y))
             (aa (multiply a a)) (r1 (add aa yy)) (s1 (sqrt r1)) (c1 (multiply r1 s1))
             (bb (multiply b b)) (r2 (add bb yy)) (s2 (sqrt r2)) (c2 (multiply r2 s2))
             (p1 (divide ,(- 1.0 mu) c1)) (p2 (divide ,mu c2))
             (d (multiply 2.0 vy)) (e (add d x))
             (f1 (multiply p1 a)) (f2 (multiply p2 b)) (f (subtract e f1)) (h (subtract f f2))
             (p (add p1 p2)) (i (subtract 1.0 p)) (j (multiply i y))
             (k (multiply 2.0 vx)) (l (subtract j k)))
           '(1 vx vy h l))
  24 28)

;; ---------------------------------------------------------------------------
;; Rules

(define (shorter inputs steps outputs) (shorter-program (by-hand inputs steps outputs)))
(define (operations p)
  (for/list ([i (in-vector (program-instructions p))]) (instruction-operation i)))

(test-case "differences that are opposite are one, through squares and quotients"
  (check-equal? (operations (shorter '(x y) '((d (subtract x y)) (e (subtract y x))
                                              (f (multiply d d)) (g (multiply e e)) (h (add f g)))
                                     '(h)))
                '(subtract multiply multiply)))

(test-case "a common factor is multiplied once"
  (check-equal? (operations (shorter '(x y z) '((a (multiply x y)) (b (multiply x z))
                                                (c (add a b)))
                                     '(c)))
                '(add multiply)))

;; Of b c d, a b c and a b c e first b c is a product, which is in all three.
(test-case "what most products have in common is multiplied first"
  (check-equal? (length (operations
                         (shorter '(a b c d e)
                                  '((ab (multiply a b)) (abc (multiply ab c))
                                    (abce (multiply abc e))
                                    (bd (multiply b d)) (bcd (multiply bd c)))
                                  '(abc abce bcd))))
                4))

(test-case "quotients of one divisor are added first"
  (check-equal? (operations (shorter '(x y z) '((a (divide x z)) (b (divide y z)) (c (add a b)))
                                     '(c)))
                '(add divide)))

(test-case "squares of sine and cosine with one factor are that factor"
  (check-equal? (shorter '(x y) '((s (sin x)) (c (cos x))
                                  (a (multiply s s)) (b (multiply c c))
                                  (d (multiply y a)) (e (multiply b y)) (f (add d e)))
                         '(f))
                (program 2 (vector) (vector (place 1)))))

(test-case "1 less the square of a cosine is that of the sine, if that is known"
  (check-equal? (operations (shorter '(x) '((s (sin x)) (c (cos x)) (a (multiply c c))
                                            (b (subtract 1.0 a)))
                                     '(s b)))
                '(sin multiply))
  (check-equal? (operations (shorter '(x) '((c (cos x)) (a (multiply c c)) (b (subtract 1.0 a)))
                                     '(b)))
                '(cos multiply subtract)))

(test-case "a sum that is used elsewhere is multiplied out where it cancels"
  (check-equal? (operations (shorter '(x y) '((s (sin x)) (c (cos x)) (a (multiply s s))
                                              (b (multiply c c)) (d (add 1.0 a)) (e (multiply d y))
                                              (f (subtract b d)))
                                     '(e f)))
                '(sin multiply add multiply multiply)))

(test-case "numbers are not divided by others with rounding"
  (define p (by-hand '(x y z) '((a (multiply 3.0 x)) (b (add a y)) (c (multiply b z))) '(c)))
  (check-eq? (shorter-program p) p)
  (define thirds (by-hand '(x y z) '((a (multiply 3.0 x)) (b (multiply 5.0 y)) (c (add a b))
                                     (d (multiply c z)) (e (add c d)))
                          '(e)))
  (check-false (for*/or ([i (in-vector (program-instructions (shorter-program thirds)))]
                         [x (in-list (instruction-operands i))])
                 (and (flonum? x) (not (= x (floor x)))))))

(test-case "what sine and cosine weigh differently keeps its digits where one of them is small"
  (define p (by-hand '(x) '((s (sin x)) (c (cos x)) (a (multiply s s)) (b (multiply c c))
                            (d (multiply 0.0625 a)) (e (multiply 4.0 b)) (f (add d e)))
                     '(f)))
  (define q (shorter-program p))
  (check < (program-length q) (program-length p))
  (define x (flvector (/ 3.141592653589793 2)))
  (check-equal? (flvector-ref (values-of q x) 0) 0.0625))

(test-case "a program that does not get shorter stays as it is"
  (define p (by-hand '(x y) '((a (multiply x y)) (b (add a x)) (c (sin b))) '(c 1 y)))
  (check-eq? (shorter-program p) p))

(test-case "a symmetric system stays symmetric"
  (define p
    (by-hand '(x y z) '((a (multiply 2.0 x)) (b (multiply y 2.0)) (c (multiply x b))
                        (d (multiply y a)) (s (solve x c z d y 1.0))
                        (u (component s 0)) (v (component s 1)))
             '(u v)))
  (define q (shorter-program p))
  (check < (program-length q) (program-length p))
  (check-true (for/or ([i (in-vector (program-instructions q))])
                (and (eq? 'solve (instruction-operation i)) (symmetric-system? i))))
  (check-close p q (flvector 0.3 1.7 -0.4) 1e-14))

(test-case "0 divided by next to nothing is 0, and numbers out of the ordinary stay where they are"
  (define quotients
    (by-hand '(x y z r) '((a (divide x r)) (b (divide y r)) (c (divide z r)) (d (multiply x a))
                          (e (multiply x b)) (f (add d e)))
             '(a b c f)))
  (check-equal? (values-of (shorter-program quotients) (flvector 0.0 0.0 1.0 1e-310))
                (flvector 0.0 0.0 +inf.0 0.0))
  (define scaled
    (by-hand '(x y) '((a (multiply 1e200 x)) (b (multiply 1e200 y)) (c (multiply a b))
                      (d (multiply 0.0 x)) (e (add c d)) (f (multiply x y)) (h (multiply x f))
                      (i (add f h)))
             '(e i)))
  (define q (shorter-program scaled))
  (check-equal? (values-of q (flvector 1e-200 1e-200)) (values-of scaled (flvector 1e-200 1e-200)))
  (check-equal? (flvector-ref (values-of q (flvector +nan.0 1.0)) 0) +nan.0))

;; ---------------------------------------------------------------------------
;; Random programs

(define (random-program inputs length operations)
  (define (operand k)
    (if (zero? (random 6)) (random-choice 1.0 2.0 0.5 -1.0 3.0) (place (random k))))
  (define (input) (place (random inputs)))
  (program inputs
           (for/vector ([k (in-range inputs (+ inputs length))])
             (define name (apply random-choice operations))
             (case name
               [(sin cos) (list name (input))]
               [(negate sqrt) (list name (place (random k)))]
               [(divide) (list name (place (random k)) (input))]
               [else (list name (operand k) (operand k))]))
           (for/vector ([_ (in-range 3)]) (place (- (+ inputs length) 1 (random 3))))))

;; How great terms may be that cancel in a value
(define (sizes p input)
  (define sums
    (program (program-inputs p)
             (for/vector ([i (in-vector (program-instructions p))])
               (define operands
                 (for/list ([x (in-list (instruction-operands i))]) (if (flonum? x) (abs x) x)))
               (case (instruction-operation i)
                 [(subtract) (cons 'add operands)]
                 [(negate) (list 'multiply 1.0 (car operands))]
                 [(sin cos) (list 'add 1.0 0.0)]
                 [else (cons (instruction-operation i) operands)]))
             (program-outputs p)))
  (values-of sums (flvector-map abs input)))
(define (flvector-map f v) (for/flvector #:length (flvector-length v) ([x (in-flvector v)]) (f x)))

(test-case "values of random programs change by rounding"
  (define shorter-ones
    (for/sum ([seed (in-range 300)])
      (with-seed seed
        (define p
          (random-program 4 (random-integer 3 60)
                          '(add subtract multiply multiply add subtract divide negate sin cos)))
        (define q (shorter-program p))
        (for ([_ (in-range 5)])
          (define input (for/flvector #:length 4 ([_ (in-range 4)]) (random-flonum)))
          (with-check-info (['program p] ['input input])
            (for ([x (in-flvector (values-of p input))] [y (in-flvector (values-of q input))]
                  [size (in-flvector (sizes p input))]
                  #:when (< size 1e200))
              (check-within y x (* 1e-12 size)))))
        (if (eq? p q) 0 1))))
  (check > shorter-ones 150))

(test-case "what is no number, or infinite, stays so in programs without differences"
  (with-seeds 200
    (define p (random-program 4 (random-integer 3 25) '(add multiply divide sqrt)))
    (define positive
      (program 4
               (for/vector ([i (in-vector (program-instructions p))])
                 (for/list ([x (in-list i)]) (if (flonum? x) (abs x) x)))
               (program-outputs p)))
    (define q (shorter-program positive))
    (for ([odd (in-list '(+nan.0 +inf.0 1e-310 0.0 1.0))])
      (define input (flvector 1.5 odd 0.7 2.5))
      (with-check-info (['program positive] ['input input])
        (for ([x (in-flvector (values-of positive input))] [y (in-flvector (values-of q input))])
          (if (< 1e-290 (abs x) 1e290)
              (check-within y x (* 1e-12 (abs x)))
              (check-true (or (eqv? x y) (and (< x 1e-280) (< y 1e-280)))
                          (format "~a ~a" x y))))))))
