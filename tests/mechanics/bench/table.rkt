#lang racket/base
;; Laying out a table as text: the first column to the left, numbers to the
;; right.

(provide table->string milliseconds ratio)

;; rows : lists of strings, the first one the heading.
(define (table->string rows)
  (define widths
    (for/list ([i (in-range (length (car rows)))])
      (for/fold ([w 0]) ([row (in-list rows)])
        (max w (string-length (list-ref row i))))))
  (define lines
    (for/list ([row (in-list rows)])
      (for/fold ([line ""]) ([cell (in-list row)] [w (in-list widths)] [i (in-naturals)])
        (define space (make-string (- w (string-length cell)) #\space))
        (string-append line (if (eqv? i 0) "" "  ")
                       (if (eqv? i 0) (string-append cell space) (string-append space cell))))))
  (define rule
    (make-string (string-length (car lines)) #\-))
  (apply string-append
         (for/list ([line (in-list (list* (car lines) rule (cdr lines)))])
           (string-append line "\n"))))

;; Three digits are plenty for a noisy machine.
(define (milliseconds x)
  (cond [(not x) "–"]
        [(>= x 100) (number->string (inexact->exact (round x)))]
        [(>= x 10) (decimals x 1)]
        [else (decimals x 2)]))

(define (ratio x y)
  (if (and x y (> y 0)) (string-append (decimals (/ x y) 2) "×") "–"))

(define (decimals x places)
  (define scale (expt 10 places))
  (define n (inexact->exact (round (* x scale))))
  (define digits (number->string (remainder (abs n) scale)))
  (string-append (if (< n 0) "-" "")
                 (number->string (quotient (abs n) scale)) "."
                 (make-string (- places (string-length digits)) #\0) digits))
