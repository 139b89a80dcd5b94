#lang racket/base
;; Levels of functions as lines, each in one piece; and parts of lines within a rectangle.

(require (only-in racket/list last)
         (only-in racket/math pi)
         "../../../../mechanics/show/plot/clipped-lines.rkt"
         "../../../../mechanics/show/plot/level-lines.rkt"
         (only-in "../../../../mechanics/show/plot/picture-layer.rkt" field)
         "../../support/checks.rkt")

(define square '(-1.0 1.0 -1.0 1.0))

;; The lines of f at a level, from n × n values
(define (lines f level [n 41])
  (define (place k) (- (/ (* 2.0 k) (- n 1)) 1.0))
  (level-lines
   (field (for/vector ([j n]) (for/vector ([i n]) (real->double-flonum (f (place i) (place j)))))
          n level)
   square))

(define (closed? line) (equal? (car line) (last line)))
(define (radius p) (sqrt (+ (* (car p) (car p)) (* (cdr p) (cdr p)))))
(define (length-of line)
  (for/sum ([p (in-list line)] [q (in-list (cdr line))])
    (radius (cons (- (car p) (car q)) (- (cdr p) (cdr q))))))

(define (r x y) (radius (cons x y)))

(test-case "a circle is one closed line"
  (define found (lines r 0.5))
  (check-equal? (length found) 1)
  (check-true (closed? (car found)))
  (for ([p (in-list (car found))]) (check-= (radius p) 0.5 1e-3))
  (check-= (length-of (car found)) pi 0.01))

(test-case "a line that ends at the edges goes from one to the other"
  (define found (lines (lambda (x y) (- y (* 0.5 x))) 0.1))
  (check-equal? (length found) 1)
  (check-equal? (sort (map car (list (car (car found)) (last (car found)))) <) '(-1.0 1.0))
  (check-= (length-of (car found)) (sqrt 5) 1e-9))

(test-case "branches of a hyperbola are two lines, and so are circles within one another"
  (check-equal? (map closed? (lines (lambda (x y) (* x y)) 0.1)) '(#f #f))
  (check-equal? (map closed? (lines (lambda (x y) (abs (- (r x y) 0.5))) 0.2)) '(#t #t)))

;; The four corners of one square are in turn above and below: its mean decides.
(test-case "at a saddle lines do not cross"
  (define (saddle above) (lambda (x y) (+ (* x y) above)))
  (for ([above '(-0.1 0.1)])
    (define found (lines (saddle above) 0.0 2))
    (check-equal? (length found) 2)
    (for ([line (in-list found)])
      (for ([p (in-list line)]) (check-true (or (= 1 (abs (car p))) (= 1 (abs (cdr p))))))
      (check-true (> (* above (car (car line)) (- (cdr (last line)))) -1)))))

(test-case "where the function has no value there is no line"
  (define found (lines (lambda (x y) (if (> x 0.5) +nan.0 y)) 0.01))
  (check-equal? (length found) 1)
  (check-= (length-of (car found)) 1.5 1e-9)
  (check-equal? (lines (lambda (x y) +inf.0) 0.0) '())
  (check-equal? (lines (lambda (x y) 1) 0.0) '()))

(test-case "each line is followed once, however many there are"
  (define (waves x y) (* (sin (* 9 x)) (sin (* 9 y))))
  (define found (lines waves 0.5 101))
  (define points (apply append (map (lambda (line) (if (closed? line) (cdr line) line)) found)))
  (check-equal? (length points) (hash-count (for/hash ([p (in-list points)]) (values p #t)))))

;; ---------------------------------------------------------------------------

(define (within . points) (clipped-lines points 0.0 10.0 0.0 10.0))

(test-case "a line within stays, and one that leaves is cut at the edge"
  (define inside '((1.0 . 1.0) (2.0 . 5.0) (9.0 . 9.0)))
  (check-equal? (apply within inside) (list inside))
  (check-equal? (within '(5.0 . 5.0) '(15.0 . 5.0)) '(((5.0 . 5.0) (10.0 . 5.0))))
  (check-equal? (within '(-5.0 . 5.0) '(15.0 . 5.0)) '(((0.0 . 5.0) (10.0 . 5.0))))
  (check-equal? (within '(5.0 . 5.0) '(15.0 . 5.0) '(15.0 . 8.0) '(5.0 . 8.0))
                '(((5.0 . 5.0) (10.0 . 5.0)) ((10.0 . 8.0) (5.0 . 8.0)))))

(test-case "nothing remains of lines outside, even if they pass a corner"
  (check-equal? (within '(-5.0 . 5.0) '(-1.0 . 8.0)) '())
  (check-equal? (within '(-6.0 . 5.0) '(5.0 . 16.0)) '())
  (check-equal? (within) '())
  (check-equal? (within '(5.0 . 5.0)) '()))

(test-case "a point that is not finite interrupts the line"
  (check-equal? (within '(1.0 . 1.0) '(2.0 . 1.0) '(+nan.0 . 1.0) '(3.0 . 1.0) '(4.0 . 1.0))
                '(((1.0 . 1.0) (2.0 . 1.0)) ((3.0 . 1.0) (4.0 . 1.0))))
  (check-equal? (within '(1.0 . 1.0) '(1.0 . +inf.0)) '()))
