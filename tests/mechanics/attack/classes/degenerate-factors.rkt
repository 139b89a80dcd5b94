#lang racket/base
;; Lagrangians of which a part has a factor that vanishes for some values of the parameters, or
;; that are singular in the velocities: are they equivalent to those without, is a quantity
;; conserved?

(require "../statement.rkt")

(provide degenerate-factors)

(define (degenerate-factors)
  (define plane? (chance 2))
  (define-values (qs vs) (if plane? (values '(x y) '(u v)) (values '(x) '(v))))
  (define-values (L other conserved?) (if plane? (in-plane) (on-line)))
  (define state (append '(t) qs vs))
  (define (of-state e)
    `(lambda (,(if plane? '(up t (up x y) (up u v)) '(up t x v)))
       ,(quoted-symbols e state)))
  (define swap? (and (not conserved?) (chance 3)))
  (define-values (one two) (if swap? (values other L) (values L other)))
  (inquiry `(,(if conserved? 'verify-conserved 'verify-equivalent-Lagrangians)
             ,(of-state one) ,(of-state two)
             ,(if plane? '(up 't (up 'x 'y) (up 'u 'v)) '(up 't 'x 'v)))
           (list (if conserved? 'conserved 'equivalent) one two qs vs)))

(define (factor)
  (pick '(c (- a b) (square c) (- (square a) (square b)) (- c) (- 1 c) (* (- c 1) (- c 2)) (sin c)
          (exp c) (+ 1 (square c)) (abs c) (sqrt (square (- a b))) (* a b) (+ a b) (/ a b)
          (- (* 2 c) (* 2 c c)) (+ c (abs c)) (log c) (- (exp c) 1) (+ (square a) (square b)))))

;; What changes no equation, mostly.
(define (gauge)
  (pick '(0 0 0 (* a v) (* c x v) (+ (* x (exp t)) (* v (exp t))) 1 (* b t) (* c v t))))

;; A Lagrangian of one coordinate, and what it conserves.
(define lines
  '(((* 1/2 (square v)) v (* x v) (- x (* v t)) (square v))
    ((- (* 1/2 (square v)) (* 1/2 (square x))) (+ (square v) (square x))
                                               (+ (* v (cos t)) (* x (sin t))))
    ((- (* 1/2 (square v)) x) (+ (* 1/2 (square v)) x) (+ v t))
    ((- (* 1/2 (square v)) (cos x)) (+ (* 1/2 (square v)) (cos x)))
    ((* (exp t) (square v)) (* (exp t) v))
    ((* 1/2 (square x) (square v)) (* x v))
    ((* x v) v)
    ((expt v 4) v)
    ((sqrt (+ 1 (square v))) v)
    ((* x (square v)) (* x (square v)))))

(define (on-line)
  (define entry (pick lines))
  (define-values (L k) (values (car entry) (factor)))
  (define Q (pick (cdr entry)))
  (case (random 6)
    [(0 1) (values L `(+ (* ,k ,L) ,(gauge)) #f)]
    [(2) (values `(* ,k ,L) (pick (list Q `(* ,(factor) ,Q))) #t)]
    [(3) (values `(* ,k ,L) `(+ (* ,(factor) ,L) ,(gauge)) #f)]
    [(4) (values (car (pick lines)) `(* ,(factor) ,L) #f)]
    [else (values `(+ (* ,k ,L) ,(gauge)) (pick (list Q `(* ,k ,Q))) #t)]))

;; Kinetic energies of the plane with a factor on a part, potentials, quantities.
(define (in-plane)
  (define k (factor))
  (define T
    (pick `((+ (* 1/2 (square u)) (* 1/2 ,k (square v))) (* 1/2 (+ (square u) (square v)))
            (* ,k u v) (* u v) (* 1/2 (square (+ u v))) (* 1/2 ,k (+ (square u) (square v)))
            (- (* x v) (* y u)) (+ (* 1/2 (square u)) (* ,k u v))
            (+ (* 1/2 (square u)) (* y v)))))
  (define V
    (pick `(0 0 (* ,k x) (* 1/2 (+ (square x) (square y))) (* x y) (cos (- x y))
            (* ,k (square y)))))
  (define L `(- ,T ,V))
  (define separate `(- (* 1/2 (square u)) (* 1/2 (square x))))
  (define other `(- (* 1/2 (square v)) ,(pick '(0 y (* 1/2 (square y))))))
  (case (random 5)
    [(0) (values L `(+ (* ,(factor) ,L) ,(pick '(0 (* c u) (+ (* x v) (* y u)) (* a t v)))) #f)]
    [(1) (values `(+ ,separate ,other) `(+ ,separate (* ,k ,other)) #f)]
    [(2) (values L (pick `((+ ,T ,V) u v (* ,k v) (- (* x v) (* y u)) (- u v) (+ u v)
                           (* ,(factor) (- (* x v) (* y u)))))
                 #t)]
    [(3) (values `(+ ,separate (* ,k ,other))
                 (pick `((+ (square u) (square x)) v (* ,k v) (* 1/2 (square v)) (- y (* v t))))
                 #t)]
    [else (values '(* 1/2 (+ (square u) (square v)))
                  `(+ (* ,k u v) (* ,(factor) 1/2 (+ (square u) (square v)))) #f)]))
