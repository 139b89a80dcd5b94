#lang racket/base
;; Formulas for the v at which given expressions g(v), a gradient, have the values w.
;;
;; Velocities that no mixed second derivative joins are found apart.  Of those that belong
;; together, as in √(1 − v²/c²) or v²/2 in any coordinates, the gradient may be
;;
;;   g(v) = b + λ(v) M v,
;;
;; with M the second derivatives and b the gradient at v = 0, as it always is of one alone.  The
;; direction of v is then that of d = M⁻¹ (w − b), and v = x d, with one equation for the number
;; x, (g(x d) − b − M d) d = 0.
;;
;; An equation in one unknown is solved if it is a polynomial that can be
;; (algebra/solve/), or one in the unknown and a square root R: e(R) = 0 implies
;; e(R) e(−R) = 0, in which R has gone.  Solutions added so are left out, since each is put
;; into the equation.
;;
;; All that is done without taking a sign for granted: a formula holds whatever those of the
;; parameters are.

(require "../algebra/expression/expression.rkt" "../algebra/expression/nodes.rkt"
         "../algebra/expression/operation.rkt" "../algebra/expression/substitute.rkt"
         "../algebra/expression/symbols.rkt"
         "../algebra/solve/solve-equations.rkt"
         "../error/failure.rkt" "../error/refusal.rkt"
         "../generic/arithmetic.rkt" "../generic/sums-and-products.rkt" "../generic/up-down.rkt"
         "../value/assumptions.rkt" "../value/rewrite.rkt" "../value/shape.rkt"
         "../value/simplify.rkt"
         "../value/matrix/linear-algebra.rkt" "../value/matrix/matrix.rkt"
         "../value/matrix/row-products.rkt")

(provide solve-gradient without-root)

;; gradient : a structure of expressions in vs; slopes : its derivatives by vs
;; -> a list of expressions in ws for vs, or #f
;; They hold for all parameters that obey the declared assumptions.
(define (solve-gradient gradient slopes vs ws)
  (parameterize ([automatic-assumptions #f])
    (solve-strictly gradient slopes vs ws)))

(define (solve-strictly gradient slopes vs ws)
  (define g (map simplify (scalars gradient)))
  (define n (length g))
  (define H (rows-of (map simplify (scalars slopes)) n))
  (define found (make-vector n #f))
  (define (joined? i j) (not (eqv? 0 (matrix-ref H i j))))
  (for ([block (in-list (joined-groups n joined?))])
    (define (those xs) (for/list ([i (in-list block)]) (list-ref xs i)))
    (define solution
      (solve-block (those g)
                   (for/list ([i (in-list block)])
                     (for/list ([j (in-list block)]) (matrix-ref H i j)))
                   (those vs) (those ws)))
    (when solution
      (for ([i (in-list block)] [v (in-list solution)]) (vector-set! found i v))))
  (define all (vector->list found))
  (and (andmap values all) all))

(define (rows-of xs n) (m:generate n n (lambda (i j) (list-ref xs (+ j (* i n))))))

;; ---------------------------------------------------------------------------
;; Velocities that belong together

;; g, H, vs, ws : lists -> list or #f
(define (solve-block g H vs ws)
  (or (solve-along-ray g H vs ws)
      (and (null? (cdr vs))
           (let ([v (solve-for (g:- (car g) (car ws)) (car vs) (lambda (solution) #t))])
             (and v (list v))))))

(define (solve-along-ray g H vs ws)
  (define zeros (map (lambda (v) (cons v 0)) vs))
  (define (at-rest e) (put e zeros))
  (define b (map at-rest g))
  (define M (for/list ([row (in-list H)]) (map at-rest row)))
  (define directions (and (ray? g b M vs) (solved-directions M (map g:- ws b))))
  (and directions
       (let* ([ds (map (lambda (v) (string->uninterned-symbol "d")) vs)]
              [x (multiple g b M vs ds)]
              [entries (map cons ds directions)])
         (and x
              (for/list ([d (in-list ds)])
                (substitute-expression (g:* x d) entries))))))

;; The x of v = x d, an expression in the symbols ds; or #f.  Without momentum there shall be no
;; velocity.
(define (multiple g b M vs ds)
  (define x (string->uninterned-symbol "x"))
  (define moved (for/list ([v (in-list vs)] [d (in-list ds)]) (cons v (g:* x d))))
  (define equation
    (g:for/sum ([g (in-list g)] [b (in-list b)] [Md (in-list (rows-times-list M ds))]
                [d (in-list ds)])
      (g:* (g:- (put g moved) b Md) d)))
  (define none (map (lambda (d) (cons d 0)) (cdr ds)))
  (define (from-rest? solution)
    (zero? (put (put (g:* solution (car ds)) none) (list (cons (car ds) 0)))))
  (solve-for (simplify equation) x from-rest?))

;; Is g − b along M v, for all v?
(define (ray? g b M vs)
  (define push (map g:- g b))
  (define images (rows-times-list M vs))
  (for*/and ([(p i) (in-indexed push)] [(q j) (in-indexed push)] #:when (< i j))
    (zero? (g:- (g:* p (list-ref images j)) (g:* q (list-ref images i))))))

;; M⁻¹ w, or #f
(define (solved-directions M w)
  (with-handlers ([exn:fail:mechanics:singular? (lambda (e) #f)])
    (scalars (solve-linear-left (apply matrix-by-rows M) (apply up w)))))

;; ---------------------------------------------------------------------------
;; One unknown

;; The x where e vanishes, of several the first that is wanted; #f if there is no formula.
(define (solve-for e x wanted?)
  (define R (string->uninterned-symbol "R"))
  (define polynomial (without-root e x R))
  (define candidates
    (or (and polynomial (not (eqv? polynomial 0))
             (solve-equations (list polynomial) (list x) (assumptions-in-force)))
        '()))
  (define roots
    (for*/list ([c (in-list candidates)]
                [entry (in-value (assq x (car c)))]
                #:when (and entry (zero? (put e (list entry)))))
      (cdr entry)))
  (and (pair? roots)
       (or (findf wanted? roots) (car roots))))

;; e(R) e(−R), with a root in e that depends on x as R; e, if there is none; #f for several.
(define (without-root e x R)
  (define roots (roots-with x e))
  (cond [(null? roots) (numerator (simplify e))]
        [(pair? (cdr roots)) #f]
        [else
         (define root (car roots))
         (define (with y) (numerator (simplify (substitute-expression e (list (cons root y))))))
         (simplify (put (g:* (with R) (with (g:negate R))) (list (cons R root))))]))

(define (roots-with x e)
  (parts-in e (lambda (n) (and (headed? n op:sqrt) (occurs? x n) n))))

;; ---------------------------------------------------------------------------

;; The value of e with the entries put in; +nan.0 where it divides by zero.
(define (put e entries)
  (if-raised divided-by-zero? +nan.0 (simplify (substitute-expression e entries))))
(define (zero? e) (eqv? 0 (simplify e)))
