#lang racket/base
;; Particles whose positions are a function r(t, q) of the time and the coordinates.
;;
;; A position is an up tuple of scalars, or a scalar on a line; an angle about a fixed
;; axis serves as well, with a torque for its force and a moment of inertia for its
;; mass.  The positions of several particles are an up tuple of positions.
;;
;; This file checks the user's positions, local tuples and displacements.

(require "../calculus/derivative.rkt"
         "../error/complain.rkt" "../error/hint.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/function-check.rkt"
         "../generic/function.rkt" "../generic/scalar.rkt"
         "../generic/sums-and-products.rkt" "../generic/up-down.rkt"
         "../generic/wrong-argument.rkt"
         "../lagrangian/local-tuple.rkt"
         (only-in "../value/structure.rkt" ref s:length structure->list))

(provide takes? check-positions check-local check-displacement
         positions-at motion-at motion-along scaled-sum)

;; ---------------------------------------------------------------------------
;; Positions and how they move

(define (positions-at who r t q)
  (define positions (r t q))
  (check-positions-value who r positions)
  positions)

;; The positions at (t, q), and how fast they change when t and q do as (dt, dq) says.
(define (motion-at who r t q dt dq)
  (define (positions s) (positions-at who r (ref s 0) (ref s 1)))
  (value-and-derivative-along positions (up t q) (up dt dq)))

;; The positions and velocities at a local tuple
(define (motion-along who r local)
  (define-values (t q v) (state-parts local))
  (motion-at who r t q 1 v))

;; Σ a_i b_i over two tuples that are alike, at all depths.  0 stands for a tuple of zeros.
(define (scaled-sum a b)
  (cond [(or (eqv? a 0) (eqv? b 0)) 0]
        [(tuple? b)
         (g:for/sum ([x (in-list (structure->list a))] [y (in-list (structure->list b))])
           (scaled-sum x y))]
        [else (g:* a b)]))

;; ---------------------------------------------------------------------------
;; The function r

;; Is f a function of n arguments, or a tuple of such functions?
(define (takes? f n)
  (if (tuple? f)
      (for/and ([part (in-list (structure->list f))]) (takes? part n))
      (takes-arguments? f n)))

(define (check-positions who r)
  (unless (takes? r 2)
    (complain who "positions are a function of the time and the coordinates, ~a; given ~a~a"
              "(r t q)" (describe-with-value r)
              (cond [(or (tuple? r) (not (procedure? r))) ""]
                    [(accepts? r 1)
                     (string-append "\n  it takes one argument: the time comes first, "
                                    "(lambda (t q) ...), and parameters before that")]
                    [else (format "\n  it takes ~a" (arity->text r))]))))

;; Ups of scalars, in a space of one dimension number only.
(define (check-positions-value who r positions)
  (check-ups who r positions positions)
  (define particles (particles-in-space positions))
  (for ([p (in-list particles)])
    (define first-one (car particles))
    (unless (= (particle-dimension p) (particle-dimension first-one))
      (complain who
                (string-append "the particles are in spaces of different dimension"
                               "\n  particle ~a: ~a coordinates\n  particle ~a: ~a coordinates"
                               "\n  positions: ~a")
                (particle-index first-one) (particle-dimension first-one)
                (particle-index p) (particle-dimension p)
                (value->text positions)))))

(define (check-ups who r part whole)
  (cond [(down? part)
         (complain who "positions are up tuples; ~a has the value ~a~a"
                   (value->text r) (value->text whole)
                   (if (eq? part whole) "" (format ", of which a part is ~a" (value->text part))))]
        [(tuple? part)
         (for ([p (in-list (structure->list part))]) (check-ups who r p whole))]
        [(not (scalar? part))
         (complain who "positions are tuples of scalars; ~a has the value ~a~a"
                   (value->text r) (value->text whole)
                   (if (procedure? part)
                       (format "\n  of which a part is ~a" (describe-with-value part))
                       (list-hint part)))]))

;; dimension : how many coordinates its position has
(struct particle (index dimension) #:authentic)

;; The particles whose position has several coordinates
(define (particles-in-space positions)
  (if (tuple? positions)
      (for/list ([p (in-list (structure->list positions))] [k (in-naturals)] #:when (tuple? p))
        (particle k (s:length p)))
      '()))

;; ---------------------------------------------------------------------------
;; Local tuples and displacements

(define (check-local who local)
  (unless (and (local-tuple? local) (>= (s:length local) 3))
    (complain-of-argument who "a local tuple (up t q v)" local (list-hint local "(up t q v)")))
  (check-alike who "velocities" (velocity local) (coordinate local)))

(define (check-displacement who displacement q)
  (check-alike who "displacement" displacement q))

(define (check-alike who what given q)
  (unless (same-shape? given q)
    (complain who "the ~a must be like the coordinates~a\n  coordinates: ~a\n  ~a: ~a" what
              (if (and (down? given) (up? q)) ", an up tuple" "")
              (value->text q) what (value->text given))))
