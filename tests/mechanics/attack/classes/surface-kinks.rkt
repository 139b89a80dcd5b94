#lang racket/base
;; Questions about what jumps or turns on a surface, made of roots of sums of squares that
;; vanish together there, or of a factor that touches zero; and about smooth neighbours.

(require "../statement.rkt")

(provide surface-kinks)

(define (surface-kinks)
  (define-values (e variable) (values (pick questions) (pick '(x x x (+ x v) (- x t) (sin x)))))
  (e variable))

;; ---------------------------------------------------------------------------
;; Steps.  u is an expression that is 0 where x = v = t = 0, w another variable.

(define (root u w)
  (define r
    (pick `((+ (square ,u) (expt ,u 4)) (+ (square ,u) (square (* ,u ,w))) (- 1 (cos ,u))
            (- (cosh ,u) 1) (square ,u) (* (square ,u) (+ 1 (square ,w))) (square (sin ,u))
            (* (exp ,w) (square ,u)) (+ (square (sin ,u)) (square (- 1 (cos ,u))))
            (+ (square (- (cos ,u) (cos 0))) (square (- (sin ,u) (* ,w (sin ,u)))))
            (+ (square (* h ,u)) (* k (expt ,u 4))) (square (- (exp ,u) 1))
            ;; smooth, or with zeros in fewer dimensions
            (+ (square ,u) (square ,w)) (+ (square ,u) (square h)) (expt ,u 4)
            (+ 1 (square ,u)) (+ (square ,u) (* ,u ,w) (square ,w)))))
  (pick `((sqrt ,r) (sqrt ,r) (expt ,r 1/2) (expt ,r 3/2) (abs ,u) (* k (sqrt ,r)))))

(define (jump u w)
  (define r (root u w))
  (pick `((sgn ,r) (sgn (+ ,u ,r)) (sgn (* ,u ,r)) (sgn ,u) (abs (sgn ,r)) (sgn (+ h ,r))
          (* ,r (sgn ,r)) ,r)))

;; (|u| made of roots . smooth factor of the sort)
(define (modulus u)
  (pick `((/ (sqrt (+ (square ,u) (expt ,u 4))) (sqrt (+ 1 (square ,u)))) (sqrt (square ,u))
          (/ (sqrt (+ (square ,u) (square (* h ,u)))) (sqrt (+ 1 (square h)))) (abs ,u)
          (/ (sqrt (+ (expt ,u 6) (square ,u))) (sqrt (+ 1 (expt ,u 4))))
          (/ (sqrt (* (exp ,u) (square ,u))) (exp (/ ,u 2)))
          (sqrt (+ (* 1/2 (square ,u)) (* 1/2 (square ,u)))) (expt (expt ,u 4) 1/4)
          (/ (expt (+ (square ,u) (expt ,u 4)) 3/2) (* (square ,u) (expt (+ 1 (square ,u)) 3/2))))))

;; ---------------------------------------------------------------------------
;; Questions.  The second part of each names what must be smooth, and where.

(define (of-local e) `(lambda ((up t x v)) ,(quoted-symbols e '(t x v))))
(define local '(up 't 'x 'v))
(define free '(* 1/2 (square v)))
(define parameters '((h . 3/2) (k . 2)))

;; On the surface, but for v; there is no place where u is not 0 if x = t = 0.
(define (at e [v 7/4] [variables '(x v)])
  (list e (append `((t . 0) (x . 0) (v . ,v) (p . 7/4)) parameters) variables))
(define (of-places . entries) (cons 'smooth entries))
(define (place-of u) (if (equal? u '(+ x v)) 0 7/4))

(define questions
  (list
   (lambda (u)                          ; energy with a kink in the potential
     (define L `(- ,free ,(root (still u) (pick '(h 1)))))
     (inquiry `(let ([L ,(of-local L)]) (verify-conserved L (Lagrangian->energy L) ,local))
              (of-places (at L))))
   (lambda (u)                          ; a step in L
     (define L `(- ,free ,(jump (still u) (pick '(h v)))))
     (inquiry `(verify-conserved ,(of-local L) ,(of-local (pick '(v (* 1/2 (square v))))) ,local)
              (of-places (at L))))
   (lambda (u)                          ; a step in what is conserved
     (define s (jump u (pick '(h t v))))
     (define Q (pick `((* v ,s) (+ v ,s) ,s)))
     (inquiry `(verify-conserved ,(of-local free) ,(of-local Q) ,local)
              (of-places (at Q (place-of u)))))
   (lambda (u)
     (define L `(- ,free ,(jump (still u) (pick '(h v)))))
     (inquiry `(verify-solution ,(of-local L) (lambda (t) (* 7/4 t))) (of-places (at L))))
   (lambda (u)                          ; paths that turn
     (define m (modulus 't))
     (define q (pick `((+ t ,m) ,m (- (* h t) (* k ,m)) (+ t ,(jump 't 'h)))))
     (inquiry `(verify-solution ,(of-local free) (lambda (t) ,(quoted-symbols q '(t))))
              (of-places (at q 0 '(t)))))
   (lambda (u)                          ; 2|sin t/2|, 2|sinh t/2|
     (define-values (q V)
       (if (chance 2)
           (values '(sqrt (- 2 (* 2 (cos t)))) '(* 1/8 (square x)))
           (values '(sqrt (* 2 (- (cosh t) 1))) '(* -1/8 (square x)))))
     (inquiry `(verify-solution ,(of-local `(- ,free ,V)) (lambda (t) ,q))
              (of-places (at q 0 '(t)))))
   (lambda (u)
     (define L `(+ ,free ,(jump u (pick '(h v t)))))
     (inquiry `(verify-ignorable ,(of-local L) 'x ,local) (of-places (at L (place-of u)))))
   (lambda (u)                          ; of two coordinates, of which only the difference counts
     (define s (pick '((sqrt (+ (square (- (cos x) (cos y))) (square (- (sin x) (sin y)))))
                       (sqrt (- 2 (* 2 (cos (- x y))))) (sqrt (+ (square (- x y)) (square h)))
                       (abs (- x y)) (sqrt (+ (square (- x y)) (expt (- x y) 4))))))
     (define L `(+ (* 1/2 (+ (square v) (square w))) ,(pick `(,s (sgn ,s) (sgn (- x y ,s))))))
     (inquiry `(verify-conserved (lambda ((up t (up x y) (up v w)))
                                   ,(quoted-symbols L '(t x y v w)))
                                 (lambda ((up t q (up v w))) (+ v w))
                                 (up 't (up 'x 'y) (up 'v 'w)))
              `(smooth (,L ((x . 0) (y . 0) (v . 1) (w . 2) (h . 3/2)) (x y)))))
   (lambda (u)
     (define s (jump (still u) (pick '(h t))))
     (define F (pick `(,s (* v ,s) (+ v ,s))))
     (inquiry `(verify-total-time-derivative ,(of-local F) ,local) (of-places (at F))))
   (lambda (u)
     (define s (jump (still u) (pick '(h t))))
     (define-values (x p) (if (chance 2) (values 'x `(+ p ,s)) (values `(* x ,s) `(/ p ,s))))
     (inquiry `(verify-canonical-map
                (lambda ((up t x p)) ,(quoted-symbols `(up t ,x ,p) '(t x p)))
                (up 't 'x 'p))
              (of-places (at x) (at p 7/4 '(x)))))
   (lambda (u)
     (define H `(+ (* 1/2 (square p)) ,(jump (still u) 'h)))
     (inquiry `(verify-Hamiltonian-solution
                (lambda ((up t x p)) ,(quoted-symbols H '(t x p)))
                (lambda (t) (* 7/4 t)) (lambda (t) 7/4))
              (of-places (at H 0 '(x)))))
   (lambda (u)
     (define S `(- (* k ,(pick (list (modulus 'x) `(+ x ,(jump 'x 'h))))) (* 1/2 (square k) t)))
     (inquiry `(verify-Hamilton-Jacobi (lambda ((up t x p)) (* 1/2 (square p)))
                                       (lambda (t x) ,(quoted-symbols S '(t x)))
                                       't 'x)
              (of-places (at S 0 '(x)))))
   (lambda (u)                          ; the double of a Lagrangian, and a step
     (define-values (s L) (values (jump (still u) (pick '(h 1)))
                                  (pick `(,free (- ,free ,(root 'x 'h))))))
     (inquiry `(verify-equivalent-Lagrangians ,(of-local L) ,(of-local `(+ ,s (* 2 ,L))) ,local)
              (of-places (at s))))))

;; Of a position alone
(define (still u) (if (memq 'v (if (pair? u) u '())) 'x (substituted u 't 0)))
