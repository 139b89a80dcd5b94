#lang racket/base
;; Mass, centre of mass and inertia tensor of a body given by its density, by quadrature.
;;
;; Ten integrals over the region, of ρ times 1, the coordinates, and their products.  The
;; region is x between two numbers, y between two functions of x, z between two of x and y.

(require "inertia.rkt"
         "../compile/definite-integral.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/compare.rkt" "../generic/define-plain.rkt"
         "../generic/describe.rkt" "../generic/function-check.rkt" "../generic/value-struct.rkt"
         "../value/structure.rkt"
         "../value/matrix/matrix.rkt")

(provide density->body body? body-mass body-center body-inertia)

;; center : up tuple; inertia : matrix, about the centre of mass
(value-struct body (mass center inertia)
  #:datum (lambda (b)
            `(body ,(body-mass b) ,(value->datum (body-center b)) ,(value->datum (body-inertia b))))
  #:equal-by body->list)

(define (body->list b) (list (body-mass b) (body-center b) (body-inertia b)))

;; density : (x y z) -> number, or a number.  xs : (list low high), ys and zs the same or
;; functions of the coordinates before them that give it.
(define-plain (density->body density xs ys zs #:tolerance [tolerance 1e-8])
  (check-density density)
  (define (moment weigh) (integral density weigh xs ys zs tolerance))
  (define mass (moment (lambda (x y z) 1)))
  (unless (> mass 0)
    (complain 'density->body "the mass is not positive: ~a\n  are limits in the wrong order?" mass))
  (define center
    (g:/ (up (moment (lambda (x y z) x)) (moment (lambda (x y z) y)) (moment (lambda (x y z) z)))
         mass))
  (body mass center (g:- (second-moments moment) (point-inertia 'density->body mass center))))

(define (check-density density)
  (unless (real? density)
    (check-takes 'density->body density 3 "a density is a number or a function of x, y and z")))

;; Σ m (x·x 1 − x xᵀ) from the integrals of products of two coordinates
(define (second-moments moment)
  (define (product pick other) (moment (lambda xyz (* (pick xyz) (other xyz)))))
  (define-values (x y z) (values car cadr caddr))
  (define-values (xx yy zz) (values (product x x) (product y y) (product z z)))
  (define-values (xy yz zx) (values (- (product x y)) (- (product y z)) (- (product z x))))
  (matrix-by-rows (list (+ yy zz) xy zx)
                  (list xy (+ zz xx) yz)
                  (list zx yz (+ xx yy))))

;; ---------------------------------------------------------------------------
;; Integrals over a region

(define (integral density weigh xs ys zs tolerance)
  (define (rho x y z) (if (procedure? density) (density x y z) density))
  (define (over limits coordinates f)
    (define-values (low high) (limits-at limits coordinates))
    (if (g:= low high) 0 (definite-integral f low high tolerance)))
  (over xs '()
        (lambda (x)
          (over ys (list x)
                (lambda (y)
                  (over zs (list x y)
                        (lambda (z) (g:* (rho x y z) (weigh x y z)))))))))

(define (limits-at limits coordinates)
  (define both (if (procedure? limits) (apply limits coordinates) limits))
  (unless (and (list? both) (= (length both) 2))
    (complain 'density->body
              "limits are a list of two, or a function of the coordinates before; given ~a"
              (describe-with-value both)))
  (values (car both) (cadr both)))
