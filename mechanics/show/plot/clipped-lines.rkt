#lang racket/base
;; The parts of a line of straight pieces that are within a rectangle.  A point that is not finite
;; interrupts the line.

(require racket/flonum
         "../../numeric/finite-number.rkt")

(provide clipped-lines)

;; points : list of pairs of flonums -> list of such lists, each of two points or more
(define (clipped-lines points x-min x-max y-min y-max)
  (define within (segment-within x-min x-max y-min y-max))
  (define (with part parts) (if (null? part) parts (cons (reverse part) parts)))
  (for/fold ([before #f] [part '()] [parts '()] #:result (reverse (with part parts)))
            ([p (in-list points)])
    (define here (and (finite? (car p)) (finite? (cdr p)) p))
    (define-values (start end) (if (and before here) (within before here) (values #f #f)))
    (cond [(not start) (values here '() (with part parts))]
          [(and (eq? start before) (pair? part)) (values here (cons end part) parts)]
          [else (values here (list end start) (with part parts))])))

;; -> a procedure: two points -> the ends of the part between them that is within, the points
;; themselves where they are; #f and #f if there is none
;; On the piece p + t (q - p), t from 0 to 1, each side of the rectangle bounds t.
(define ((segment-within x-min x-max y-min y-max) p q)
  (define-values (x y) (values (car p) (cdr p)))
  (define-values (dx dy) (values (fl- (car q) x) (fl- (cdr q) y)))
  (define-values (x-from x-to) (times-between x dx x-min x-max))
  (define-values (y-from y-to) (times-between y dy y-min y-max))
  (define-values (from to) (values (flmax 0.0 (flmax x-from y-from)) (flmin 1.0 (flmin x-to y-to))))
  (define (at t) (cons (fl+ x (fl* t dx)) (fl+ y (fl* t dy))))
  (if (fl<= from to)
      (values (if (fl= from 0.0) p (at from)) (if (fl= to 1.0) q (at to)))
      (values #f #f)))

;; When is x + t dx between low and high?
(define (times-between x dx low high)
  (cond [(fl= dx 0.0) (if (fl<= low x high) (values 0.0 1.0) (values 1.0 0.0))]
        [else (define-values (a b) (values (fl/ (fl- low x) dx) (fl/ (fl- high x) dx)))
              (values (flmin a b) (flmax a b))]))
