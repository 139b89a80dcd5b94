#lang racket/base
;; Relations that cannot all hold are refused, those that hold somewhere never.

(require mechanics/algebra/assumption/assumption-set
         mechanics/algebra/expression/read
         mechanics/algebra/expression/substitute
         mechanics/algebra/simplify/declare-relations
         mechanics/algebra/assumption/reference-point
         "../../support/checks.rkt")

(define (because relations)
  (with-handlers ([exn:algebra:contradiction? exn:algebra:contradiction-because])
    (declare-relations no-assumptions relations)
    #f))

;; Each row cannot hold.
(define impossible
  '(((> x 0) (< x 0))
    ((> x 0) (< (* x (+ x 1)) 0))
    ((> (cos x) 2))
    ((> x 0) (> y 0) (< (+ x y) 0))
    ((> m 0) (> k 0) (< (/ k m) 0))
    ((> x 2) (< x 1))
    ((> x y) (> y z) (> z x))
    ((> (abs x) 2) (< (square x) 1))
    ((< 0 x) (< x 1) (> (square x) 1))
    ((< 0 x) (< x 1) (> (* x (- x 1)) 0))
    ((> r 0) (> R r) (< R 0))
    ((< (+ (square x) (square y)) 0))
    ((> x 0) (< (exp x) 1))
    ((> x 1) (< (log x) 0))
    ((< 0 e) (< e 1) (< (- 1 (square e)) 0))
    ((> a b) (> b 0) (< (square a) (square b)))
    ((< -1 x) (< x 1) (> (square x) 4))
    ((> (+ (square x) 1) 0) (< (+ (square x) 1) 0))
    ((> x 0) (< (sqrt x) 0))
    ((> (* x y) 0) (> x 0) (< y 0))
    ((> (* a b) 0) (> (* b c) 0) (> (* c d) 0) (> (* d e) 0) (< (* a e) 0))
    ((< 0 v) (< v c) (> (square (/ v c)) 1))
    ((> x 3) (> y 4) (< (+ x y) 7))
    ((> x 3) (> y 4) (< (* x y) 12))
    ((< 1 x) (< x 2) (< (- (square x) x) 0))
    ((< 0 theta) (< theta 1) (< (sin theta) 0))
    ((< 1 x) (< x 3) (< 1 y) (< y 3) (> (* x y) 10))
    ((> (* 2 (square x)) (+ 1 (* 2 (square x)))))
    ((> x 1) (< (- (* x x x) x) 0))
    ((> (+ (square (sin x)) (square (cos x))) 1))
    ((> (cosh x) 1) (< (cosh x) 1))
    ((< (- (square x) (* 2 x)) -2))
    ((> x 0) (< (+ x (/ 1 x)) 1))
    ((> (V 0) 2) (< (square (V 0)) 3))
    ((< 0 x) (< x 1) (> (+ (sin x) (square x)) 2))
    ((> x 1) (< (+ (log x) (/ 1000 x)) 6))
    ((> x :pi) (< x 3))
    ((> x :pi) (< x 31415926/10000000))))

(test-case "contradictions are found"
  (for ([row impossible]) (check-not-false (because row) (format "~s" row))))

(test-case "only those that contradict each other are named"
  (check-equal? (because '((> z 2) (> x 1) (< (log x) 0))) '((> x 1) (< (log x) 0)))
  (check-equal? (because '((> x 3) (> y 4) (< x 9) (< (* x y) 12)))
                '((> x 3) (> y 4) (< (* x y) 12))))

(test-case "what can hold at one point, or in a narrow place, is not refused"
  (for ([row `(((>= x 1) (<= x 1))
               ((>= (square x) 0) (<= (square x) 0))
               ((> x 0) (< (exp x) 1001/1000))
               ((< (abs (- (sin x) (* 1/3 x))) 1/1000) (> x 1))
               ((<= (+ (square x) (square y)) 1) (>= (* x y) 1/2))
               ((> (log x) 20))
               ((> x :pi) (< x 31415927/10000000))
               ((< x (* 2 :pi)) (> x 62831853/10000000))
               ((> x ,(expt 10 400)) (< (log x) 1000))
               ((> (- (log x) (* 1/3 x)) 0))
               ((< (+ (square x) (* -2 x)) -999999/1000000))
               ;; more boxes than are looked at
               ((<= (+ ,@(for/list ([s '(a b c d e f g h)] [n '(2 3 5 7 11 13 17 19)])
                           `(square (- ,s (sqrt ,n)))))
                    0)))])
    (check-false (because row) (format "~s" row))))

;; Relations that hold at random points, made by looking which way they are there.
(define (random-expression depth)
  (define (below) (random-expression (- depth 1)))
  (case (if (eqv? depth 0) (random 3) (random 12))
    [(0 3) 'x]
    [(1 4) 'y]
    [(2) (- (random 9) 4)]
    [(5 6) (list '+ (below) (below))]
    [(7 8) (list '* (below) (below))]
    [(9) (list 'square (below))]
    [(10) (list (list-ref '(sin cos exp abs atan) (random 5)) (below))]
    [(11) (list '/ (below) (below))]))

(define (exact-relation r) (list (car r) (cadr r) (inexact->exact (caddr r))))

(define (value-at d point)
  (with-handlers ([exn:fail:contract:divide-by-zero? (lambda (x) #f)])
    (real-value (substitute-expression (datum->expression d) point) void)))

(test-case "relations that hold at a random point are never refused"
  (random-seed 7)
  (for ([_ (in-range 400)])
    (define point `((x . ,(/ (- (random 200) 100) (+ 1 (random 30))))
                    (y . ,(/ (- (random 200) 100) (+ 1 (random 30))))))
    (define relations
      (for*/list ([_ (in-range (+ 1 (random 3)))]
                  [d (in-value (random-expression 3))]
                  [value (in-value (value-at d point))]
                  #:when (and value (< 1e-6 (abs value) 1e6)))
        (list (if (> value 0) '> '<) d (* value (if (zero? (random 2)) 0 9/10)))))
    (check-false (because (map exact-relation relations)) (format "~s" relations))))
