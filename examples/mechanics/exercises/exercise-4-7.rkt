#lang mechanics
;; Exercise 4.7 (SICM 4.5.1): the construction of Poincaré and Birkhoff
;; Checked: the fixed points of the three major chains of islands of the standard map, K = 0.6
;; How: points that map radially, where their curve crosses its image; against find-fixed-point

(require mechanics/book)

(define T (standard-map 0.6))
(define turned (principal-value :pi))

;; Of the k-th iterate: the action whose image has the same angle, and how far that image is above.
;; It is sought about the action halfway through the first kick.
(define ((on-C_0 k middle) theta)
  (define halfway (- middle (* 0.3 (sin theta))))
  (radially-mapping-points (iterated-map T k) (- halfway 0.35) (+ halfway 0.35) theta 1e-12))
(define ((rise k C_0) theta)
  ((iterated-map T k) theta (C_0 theta) (lambda (theta2 J2) (turned (- J2 (C_0 theta)))) void))

;; An attempt: fixed points are where C₀ and its image cross: the rise changes its sign.
(define (crossings k middle)
  (define C_0 (on-C_0 k middle))
  (define f (rise k C_0))
  (define angles (for/list ([j 25]) (+ 0.1 (* j (/ :2pi 24)))))
  (for/list ([a angles] [b (cdr angles)] #:when (negative? (* (f a) (f b))))
    (define theta (bisect f a b 1e-10))
    (up theta (C_0 theta))))

;; The chains about the rotation numbers 0, 1/2 and 1/3.
(define chains
  (list (list 1 (crossings 1 0))
        (list 2 (crossings 2 :pi))
        (list 3 (crossings 3 (/ :2pi 3)))))
(define (points chain)
  (map (lambda (p) (find-fixed-point T p #:period (car chain))) (cadr chain)))
(define (kinds n) (map fixed-point-kind (points (assv n chains))))
(kinds 1)
(kinds 2)
(kinds 3)

;; A slip: that all of C₀ is fixed, as it is without kicks.
(define slip ((rise 1 (on-C_0 1 0)) 1.))
slip

(module+ test
  (require rackunit)
  (test-case "of each chain half are stable and half are not, in turn"
    (for ([n '(1 2 3)])
      (check-equal? (length (kinds n)) (* 2 n))
      (for ([a (kinds n)] [b (cdr (kinds n))]) (check-not-equal? a b))))
  (test-case "they are where Newton's method finds them"
    (for* ([chain chains] [p (cadr chain)])
      (define q (fixed-point-coordinates (find-fixed-point T p #:period (car chain))))
      (check-= (turned (- (ref p 0) (ref q 0))) 0 1e-7)
      (check-= (turned (- (ref p 1) (ref q 1))) 0 1e-7)))
  (test-case "the rest of the curve is moved"
    (check-true (> (abs slip) 0.1))))
