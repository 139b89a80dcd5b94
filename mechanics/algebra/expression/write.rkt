#lang racket/base
;; Writing S-expressions within bounds.
;;
;; What an expression prints as is an S-expression whose pairs may be shared;
;; its text can be exponentially longer than it.  So the writer stops after
;; `print-limit` atoms and says how many it left out, counting them on the
;; shared pairs.  Symbols are written without quotes or bars they do not need.

(require "../../error/complain.rkt")

(provide print-limit write-datum datum->text datum->brief-text make-sizer omission)

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

(define (write-datum d port)
  (define size (make-sizer))
  (define budget (or (print-limit) +inf.0))
  (define (atom! x)
    (set! budget (- budget 1))
    (write x port))
  (define (item! x)
    (if (pair? x) (list! x) (atom! x)))
  (define (list! xs)
    (write-string "(" port)
    (let loop ([xs xs] [first? #t])
      (cond [(null? xs) (void)]
            [(not (pair? xs))
             (write-string " . " port)
             (atom! xs)]
            [(and (<= budget 0) (not first?))
             (write-string " " port)
             (write-string (omission (size xs)) port)]
            [else
             (unless first? (write-string " " port))
             (item! (car xs))
             (loop (cdr xs) #f)]))
    (write-string ")" port))
  (item! d))

;; What stands for n atoms left out.
(define (omission n)
  (if (< n 1000000000)
      (format "...~a more" n)
      (format "...10^~a more" (quotient (* 30103 (integer-length n)) 100000))))

;; -> (datum -> how many atoms it has, written out), costing each pair once.
(define (make-sizer)
  (define sizes (make-hasheq))
  (define (size d)
    (cond [(pair? d)
           (hash-ref! sizes d (lambda () (+ (size (car d)) (size (cdr d)))))]
          [(null? d) 0]
          [else 1]))
  size)
