#lang racket/base
;; Which values of controls are computed beforehand, where the frames of all their combinations
;; would be too many: every second one, every third one ... of the control that has the most, its
;; start, first and last among them.  A control that cannot be coarser is left at its start, the
;; last one first.

(require (only-in racket/list argmax remove-duplicates))

(provide sampled-positions)

;; counts : how many values each control has; starts : their positions at first; most : frames
;; -> for each control the positions that are taken, in order
(define (sampled-positions counts starts most)
  (let coarser ([strides (map (lambda (n) 1) counts)])
    (define taken (map positions counts starts strides))
    (define sizes (map length taken))
    (define all (for/list ([size (in-list sizes)] [k (in-naturals)]) (cons size k)))
    (define largest (argmax car all))
    (cond [(<= (apply * sizes) most) taken]
          [(> (car largest) least)
           (coarser (changed strides (cdr largest) (lambda (stride) (+ stride 1))))]
          [else
           (define last-moved (cdr (argmax cdr (filter (lambda (s) (> (car s) 1)) all))))
           (coarser (changed strides last-moved (lambda (stride) #f)))])))

;; A control with so many values is not made coarser.
(define least 3)

(define (changed xs k f)
  (for/list ([x (in-list xs)] [j (in-naturals)]) (if (= j k) (f x) x)))

;; stride : #f leaves the start alone
(define (positions count start stride)
  (if stride
      (remove-duplicates
       (sort (list* 0 (- count 1) (for/list ([p (in-range (modulo start stride) count stride)]) p))
             <))
      (list start)))
