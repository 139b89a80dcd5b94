#lang racket/base
;; The beginning of an S-expression, within `print-limit` atoms.
;;
;; Pairs may be shared, and a tree drawn from them be exponentially larger than they are; so it
;; is cut before it is drawn, as `write-datum` cuts it, and says how much was left out.

(require "tree.rkt"
         "../expression/write.rkt")

(provide cut-datum)

;; -> the datum, or one in which an `omitted` stands for what is beyond the limit
(define (cut-datum d)
  (define size (make-sizer))
  (define limit (print-limit))
  (if (or (not limit) (<= (size d) limit)) d (cut d limit size)))

(define (cut d limit size)
  (define left limit)
  (define (item x)
    (cond [(pair? x) (cons (item (car x)) (items (cdr x)))]
          [else (set! left (- left 1))
                x]))
  (define (items xs)
    (cond [(not (pair? xs)) xs]
          [(<= left 0) (list (omitted (omission (size xs))))]
          [else (define first (item (car xs)))
                (cons first (items (cdr xs)))]))
  (item d))
