#lang racket/base
;; Where a system rests: the finds of `equilibria`, and the coordinates that are asked about.

(require "../error/complain.rkt" "../error/hint.rkt"
         "../generic/compare.rkt" "../generic/describe.rkt" "../generic/notation.rkt"
         "../generic/scalar.rkt" "../generic/up-down.rkt"
         "../generic/value-struct.rkt" "../generic/wrong-argument.rkt"
         "../value/shape.rkt" (only-in "../value/structure.rkt" s:length s:ref))

(provide equilibrium equilibrium?
         check-coordinates)

;; conditions : for the coordinates to be real, such as (<= e 1)
(value-struct equilibrium (coordinates conditions)
  #:datum (lambda (e) `(equilibrium ,(equilibrium-coordinates e) ,@(equilibrium-conditions e)))
  #:notation equilibrium-notation)

(provide-parts equilibrium? "an equilibrium, one of those that (equilibria L local) gives"
  equilibrium-coordinates equilibrium-conditions)

(define (equilibrium-notation e see)
  (apply statement
         (list 0 "equilibrium at" (see (equilibrium-coordinates e)))
         (for/list ([c (in-list (equilibrium-conditions e))]) (list 1 "if" (see c)))))

(define (check-coordinates who q)
  (unless (or (scalar? q) (and (tuple? q) (up? q)))
    (complain who "expected coordinates, a scalar or an up tuple of scalars\n  given: ~a~a"
              (if (equilibrium? q) q (describe-with-value q)) (hint q)))
  (when (and (tuple? q) (= (s:length q) 3)
             (eq? (s:ref q 0) 't) (same-shape? (s:ref q 1) (s:ref q 2)))
    (complain who "expected coordinates\n  given: ~a, a local tuple\n  its coordinates are ~a"
              (value->text q) (value->text (s:ref q 1))))
  (define all (scalars q))
  (when (null? all) (complain who "expected coordinates; given an up tuple of none"))
  (for ([x (in-list all)])
    (define number (comparand x))
    (when (and (number? number) (not (rational? number)))
      (complain who "coordinates are finite real numbers, or symbols; given ~a"
                (describe-with-value q)))))

(define (hint q)
  (if (equilibrium? q)
      "\n  its coordinates are (equilibrium-coordinates e)"
      (list-hint q)))
