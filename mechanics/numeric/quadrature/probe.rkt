#lang racket/base
;; Points at which a quadrature that would end looks for what it has not seen.
;;
;; A peak between the nodes of a panel leaves no trace in their values.  Points spread over
;; the interval, no two of them further apart than about 1/240 of it, find one that is a
;; thousandth of it wide; others close in on both ends, and on 0 if it lies between, in steps
;; of a factor 4, for the mass of e^(−x) over 0 … 10⁶ is there.  Where a value differs
;; from the polynomial of its panel by more than that may be wrong, the panel is *suspect*.
;;
;; What the polynomial may be wrong by follows from the estimate of panel.rkt, whose error to
;; the power 2/3 is the distance of two rules: about tolerance^(2/3) of the mean of |f|,
;; as long as the panel is not so narrow that it does not matter.

(require racket/flonum racket/list
         "panel.rkt"
         "../../error/failure.rkt")

(provide take-probes suspects)

(struct probe (x y) #:authentic)

;; -> a list in increasing order of x; f is evaluated at some 300 points, of which those are
;; left out where it has no finite value, as ∞ · 0 far out
(define (take-probes f low high)
  (define-values (a b) (values (min low high) (max low high)))
  (for*/list ([x (in-list (sort (remove-duplicates (points a b)) fl<))]
              #:when (fl< a x b)
              [y (in-value (with-handlers ([exn:fail:mechanics:singular? (lambda (e) #f)]) (f x)))]
              #:when y)
    (probe x y)))

(define spread 240)
(define golden 0.6180339887498949)

(define (points a b)
  (define width (fl- b a))
  (append (for/list ([k (in-range spread)])
            (define jitter (fl- (fl* golden (->fl k)) (flfloor (fl* golden (->fl k)))))
            (fl+ a (fl* width (fl/ (fl+ (->fl k) (fl+ 0.45 (fl* 0.1 jitter))) (->fl spread)))))
          (closing-in a width)
          (closing-in b (fl- 0.0 width))
          (if (fl< a 0.0 b) (append (closing-in 0.0 b) (closing-in 0.0 a)) '())))

(define (closing-in end width)
  (for/list ([k (in-range 8 54 2)]) (fl+ end (fl* width (expt 0.5 k)))))

;; The panels whose polynomials are wrong at a probe; size ≈ ∫ |f| over the whole width.
(define (suspects panels probes tolerance size width)
  (define most (fl* 0.1 (fl/ (fl* (flexpt tolerance (fl/ 2.0 3.0)) size) width)))
  (define matters (fl* 0.1 (fl* tolerance size)))
  (define (wrong? p q)
    (define off (flabs (fl- (probe-y q) (panel-polynomial p (probe-x q)))))
    (and (fl> off most) (fl> (fl* off (panel-width p)) matters)))
  (let loop ([panels (sort panels fl< #:key panel-least)] [probes probes] [found '()])
    (cond [(or (null? panels) (null? probes)) found]
          [else
           (define p (car panels))
           (define q (car probes))
           (cond [(fl> (probe-x q) (flmax (panel-low p) (panel-high p)))
                  (loop (cdr panels) probes found)]
                 [(fl< (probe-x q) (panel-least p)) (loop panels (cdr probes) found)]
                 [(wrong? p q) (loop (cdr panels) probes (cons p found))]
                 [else (loop panels (cdr probes) found)])])))

(define (panel-least p) (flmin (panel-low p) (panel-high p)))
