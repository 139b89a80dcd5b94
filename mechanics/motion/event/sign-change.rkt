#lang racket/base
;; Where a function of one number that changes its sign is zero.
;;
;; By the Illinois method (Dowell and Jarratt 1971), false position in which the weight of an
;; end that stays too long is halved.  A pole changes the sign as well, and is no zero.  Where the
;; function stays 0, as a force that acts on contact alone, it is the first place that counts.

(require racket/flonum)

(provide crosses? zero-between last-value)

;; Where g, which has a value at a and none at b, ceases to have one.
(define (last-value g a b)
  (let loop ([a a] [b b])
    (define middle (fl* 0.5 (fl+ a b)))
    (cond [(fl<= (fl- b a) 1e-12) b]
          [(let ([gm (g middle)]) (fl= gm gm)) (loop middle b)]
          [else (loop a middle)])))

;; From a sign to the other or to zero; from zero to a sign is no crossing.
(define (crosses? ga gb direction)
  (or (and (< ga 0) (>= gb 0) (not (eq? direction 'falling)))
      (and (> ga 0) (<= gb 0) (not (eq? direction 'rising)))))

;; -> a place, or #f if there is a pole instead
(define (zero-between g from at-from to at-to)
  (define least (flmin (flabs at-from) (flabs at-to)))
  (define (unless-pole x gx)
    (and (fl<= (flabs gx) least)
         (if (fl= gx 0.0) (first-zero g from at-from x) x)))
  (let loop ([a from] [ga at-from] [b to] [gb at-to] [count 0])
    (define c (fl- b (fl/ (fl* gb (fl- b a)) (fl- gb ga))))
    (cond [(or (fl= gb 0.0) (fl= c b) (= count 100) (fl<= (flabs (fl- b a)) 1e-15))
           (unless-pole b gb)]
          [else
           (define gc (g c))
           (if (if (fl< gb 0.0) (fl> gc 0.0) (fl< gc 0.0))
               (loop b gb c gc (+ count 1))
               (loop a (fl* 0.5 ga) c gc (+ count 1)))])))

;; g is 0 at b, and perhaps before.
(define (first-zero g a ga b)
  (define (before? x) (if (fl< ga 0.0) (fl< (g x) 0.0) (fl> (g x) 0.0)))
  (if (before? (fl- b (fl* 1e-9 (fl- b a))))
      b
      (let loop ([a a] [b b])
        (define middle (fl* 0.5 (fl+ a b)))
        (cond [(fl<= (fl- b a) 1e-15) b]
              [(before? middle) (loop middle b)]
              [else (loop a middle)]))))
