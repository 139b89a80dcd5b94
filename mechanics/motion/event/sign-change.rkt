#lang racket/base
;; Where a function of one number that changes its sign is zero.
;;
;; By the Illinois method (Dowell and Jarratt 1971), false position in which the weight of an
;; end that stays too long is halved.  A pole changes the sign as well, and is no zero.  Where the
;; function stays 0, as a force that acts on contact alone, it is the first place that counts.
;;
;; Places are fractions of a step, flonums; or times in numbers of any precision, exact.

(provide crosses? zero-between last-value)

;; Where g, which has a value at a and none at b, ceases to have one.
(define (last-value g a b)
  (define (value? x) (let ([y (g x)]) (= y y)))
  (boundary value? a b 1e-12 values))

;; From a sign to the other or to zero; from zero to a sign is no crossing.
(define (crosses? ga gb direction)
  (or (and (< ga 0) (>= gb 0) (not (eq? direction 'falling)))
      (and (> ga 0) (<= gb 0) (not (eq? direction 'rising)))))

;; near : the resolution of places; close? : between two, of which c is to follow b, is it reached?
;; rounded : place -> place, as they are computed with
;; -> a place, or #f if there is a pole instead
(define (zero-between g from at-from to at-to
                      #:near [near 1e-15]
                      #:close? [close? (lambda (a b c) (or (= c b) (<= (abs (- b a)) near)))]
                      #:rounded [rounded values])
  (define least (min (abs at-from) (abs at-to)))
  (define (unless-pole x gx)
    (and (<= (abs gx) least)
         (if (zero? gx) (first-zero g from at-from x near rounded) x)))
  (let loop ([a from] [ga at-from] [b to] [gb at-to] [count 0])
    (define c (rounded (- b (/ (* gb (- b a)) (- gb ga)))))
    (cond [(or (zero? gb) (= count 100) (close? a b c)) (unless-pole b gb)]
          [else
           (define gc (g c))
           (if (if (< gb 0) (> gc 0) (< gc 0))
               (loop b gb c gc (+ count 1))
               (loop a (/ ga 2) c gc (+ count 1)))])))

;; g is 0 at b, and perhaps before.
(define (first-zero g a ga b near rounded)
  (define (before? x) (if (< ga 0) (< (g x) 0) (> (g x) 0)))
  (if (before? (rounded (- b (* 1/1000000000 (- b a)))))
      b
      (boundary before? a b near rounded)))

;; Where before?, which is true at a and false at b, ceases to be.
(define (boundary before? a b near rounded)
  (let loop ([a a] [b b])
    (define middle (rounded (/ (+ a b) 2)))
    (cond [(<= (abs (- b a)) near) b]
          [(before? middle) (loop middle b)]
          [else (loop a middle)])))
