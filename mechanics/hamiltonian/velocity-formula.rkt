#lang racket/base
;; Formulas for the v at which given expressions g(v), a gradient, have the values w.
;;
;; Velocities that no mixed second derivative joins are found apart.  Of those that belong
;; together, as in √(1 − v²/c²) or −v²/2 in any coordinates, the gradient may be
;;
;;   g(v) = b + λ(v) M v,
;;
;; with M the second derivatives and b the gradient at v = 0.  The direction of v is then that
;; of d = M⁻¹ (w − b), and v = x d, with one equation for the number x, (g(x d) − w) d = 0.
;;
;; An equation in one unknown is solved if it is a polynomial that can be
;; (algebra/rewriting/solve.rkt), or one in the unknown and a square root R: e(R) = 0 implies
;; e(R) e(−R) = 0, in which R has gone.  What this adds is left out, since each solution is put
;; into the equation.

(require "../algebra/expression/expression.rkt" "../algebra/expression/operation.rkt"
         "../algebra/expression/substitute.rkt"
         "../algebra/rewriting/solve.rkt"
         "../error/failure.rkt"
         "../generic/arithmetic.rkt" "../generic/up-down.rkt"
         "../value/assumptions.rkt" "../value/rewrite.rkt" "../value/shape.rkt"
         "../value/simplify.rkt"
         "../value/linear/linear-algebra.rkt" "../value/linear/matrix.rkt")

(provide solve-gradient)

;; gradient : a structure of expressions in vs; slopes : its derivatives by vs
;; -> a list of expressions in ws for vs, or #f
(define (solve-gradient gradient slopes vs ws)
  (define g (list->vector (map simplify (scalars gradient))))
  (define n (vector-length g))
  (define H (rows-of (map simplify (scalars slopes)) n))
  (define found (make-vector n #f))
  (for ([block (in-list (blocks H))])
    (define (those xs) (for/list ([i (in-list block)]) (list-ref xs i)))
    (define solution
      (solve-block (for/list ([i (in-list block)]) (vector-ref g i))
                   (for/list ([i (in-list block)])
                     (for/list ([j (in-list block)]) (matrix-ref H i j)))
                   (those vs) (those ws)))
    (when solution
      (for ([i (in-list block)] [v (in-list solution)]) (vector-set! found i v))))
  (and (for/and ([v (in-vector found)]) v) (vector->list found)))

(define (rows-of xs n) (m:generate n n (lambda (i j) (list-ref xs (+ j (* i n))))))

;; The indices 0, 1 ... in groups that no entry of H joins.
(define (blocks H)
  (define n (m:num-rows H))
  (define (joined? i j) (not (eqv? 0 (matrix-ref H i j))))
  (for/fold ([groups '()] #:result (reverse groups)) ([i (in-range n)])
    (define-values (near far)
      (for/fold ([near (list i)] [far '()]) ([group (in-list groups)])
        (if (ormap (lambda (j) (joined? i j)) group)
            (values (append near group) far)
            (values near (cons group far)))))
    (cons (sort near <) (reverse far))))

;; ---------------------------------------------------------------------------
;; Velocities that belong together

;; g, H, vs, ws : lists -> list or #f
(define (solve-block g H vs ws)
  (if (null? (cdr vs))
      (let ([v (solve-for (g:- (car g) (car ws)) (car vs) (through-rest g vs ws))])
        (and v (list v)))
      (solve-along-ray g H vs ws)))

;; Is it the solution that has v = 0 at the gradient that belongs to it?
(define ((through-rest g vs ws) solution)
  (define at-rest (put (car g) (list (cons (car vs) 0))))
  (zero? (substitute-expression solution (list (cons (car ws) at-rest)))))

(define (solve-along-ray g H vs ws)
  (define zeros (map (lambda (v) (cons v 0)) vs))
  (define (at-rest e) (put e zeros))
  (define b (map at-rest g))
  (define M (for/list ([row (in-list H)]) (map at-rest row)))
  (define d (and (ray? g b M vs) (directions M (map g:- ws b))))
  (define x (string->uninterned-symbol "x"))
  (define (along e)
    (put e (for/list ([v (in-list vs)] [d (in-list d)]) (cons v (g:* x d)))))
  (define (equation)
    (for/fold ([sum 0]) ([g (in-list g)] [w (in-list ws)] [d (in-list d)])
      (g:+ sum (g:* (g:- (along g) w) d))))
  (define solution (and d (solve-for (simplify (equation)) x (lambda (solution) #t))))
  (and solution (map (lambda (d) (g:* solution d)) d)))

;; Is g − b along M v, for all v?
(define (ray? g b M vs)
  (define push (map g:- g b))
  (define rest
    (for/list ([row (in-list M)])
      (for/fold ([sum 0]) ([m (in-list row)] [v (in-list vs)]) (g:+ sum (g:* m v)))))
  (for*/and ([(p i) (in-indexed-list push)] [(q j) (in-indexed-list push)] #:when (< i j))
    (zero? (g:- (g:* p (list-ref rest j)) (g:* q (list-ref rest i))))))

(define (in-indexed-list xs) (in-parallel xs (in-naturals)))

;; M⁻¹ w, or #f
(define (directions M w)
  (with-handlers ([exn:fail:mechanics:singular? (lambda (e) #f)])
    (scalars (solve-linear-left (apply matrix-by-rows M) (up-of (list->vector w))))))

;; ---------------------------------------------------------------------------
;; One unknown

;; The x where e vanishes, the first that is wanted if there are several; #f if there is no
;; formula.
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
  (define found '())
  (node-fold e
             (lambda (leaf) (eq? leaf x))
             (lambda (n moves)
               (define here? (ormap values moves))
               (when (and here? (eq? (node-head n) op:sqrt) (not (member n found)))
                 (set! found (cons n found)))
               here?))
  found)

;; ---------------------------------------------------------------------------

(define (put e entries) (simplify (substitute-expression e entries)))
(define (zero? e) (eqv? 0 (simplify e)))
