#lang racket/base
;; Writing S-expressions within bounds.
;;
;; An expression prints as an S-expression whose pairs may be shared;
;; its text can be exponentially longer than it.  So the datum is cut after
;; `print-limit` atoms, and its text says how many were left out, counted on the
;; shared pairs.  Symbols are written without quotes or bars they do not need.

(require "../../error/complain.rkt")

(provide print-limit cut-datum omission? write-datum datum->text datum->brief-text make-sizer)

;; The greatest number of atoms written for one value; #f for no bound.
(define print-limit
  (make-parameter 2000
                  (lambda (n)
                    (unless (or (not n) (exact-positive-integer? n))
                      (complain-of-datum 'print-limit "a number of terms, 1, 2, 3 ..., or #f" n))
                    n)))

(define (datum->text d)
  (define port (open-output-string))
  (write-datum d port)
  (get-output-string port))

;; The beginning of the text, to recognise an expression by.
(define (datum->brief-text d)
  (parameterize ([print-limit 24]) (datum->text d)))

;; The beginning of a datum, within `print-limit` atoms, where an `omission` stands for the
;; rest; the datum itself where there is no bound.
(define (cut-datum d)
  (define size (make-sizer))
  (define left (print-limit))
  (define (item x)
    (cond [(pair? x) (cons (item (car x)) (items (cdr x)))]
          [else (set! left (- left 1))
                x]))
  (define (items xs)
    (cond [(null? xs) '()]
          [(not (pair? xs)) (item xs)]
          [(<= left 0) (list (omission (size xs)))]
          [else (item xs)]))
  (if left (item d) d))

;; A sign in place of `count` atoms left out.
(struct omission (count)
  #:property prop:custom-write
  (lambda (o port mode)
    (define n (omission-count o))
    (write-string (if (< n 1000000000)
                      (format "...~a more" n)
                      (format "...10^~a more" (quotient (* 30103 (integer-length n)) 100000)))
                  port)))

(define (write-datum d port)
  (define (write-items xs lead)
    (cond [(pair? xs)
           (write-string lead port)
           (write-item (car xs))
           (write-items (cdr xs) " ")]
          [(not (null? xs))
           (write-string " . " port)
           (write xs port)]))
  (define (write-item x)
    (cond [(pair? x)
           (write-items x "(")
           (write-string ")" port)]
          [else (write x port)]))
  (write-item (cut-datum d)))

;; -> (datum -> how many atoms it has, written out), costing each pair once.
(define (make-sizer)
  (define sizes (make-hasheq))
  (define (size d)
    (cond [(pair? d)
           (hash-ref! sizes d (lambda () (+ (size (car d)) (size (cdr d)))))]
          [(null? d) 0]
          [else 1]))
  size)
