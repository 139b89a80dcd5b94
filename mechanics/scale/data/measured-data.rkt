#lang racket/base
;; Measured data as a fit takes them: a time and some numbers for each row.

(require racket/flonum
         racket/list
         "number-table.rkt"
         "../../error/complain.rkt"
         "../../generic/describe.rkt" "../../generic/up-down.rkt"
         "../../generic/wrong-argument.rkt"
         "../../value/shape.rkt")

(provide measured-rows check-deviations (struct-out measured))

;; time : flonum; numbers : flvector
(struct measured (time numbers) #:authentic)

;; data : a table, whose first column is the time, or a list of rows, tuples or lists
;; start : the time before which there are none
(define (measured-rows who data start)
  (define names (and (number-table? data) (table-names data)))
  (define rows (if names (table-rows data) data))
  (unless (and (list? rows) (pair? rows))
    (complain-of-argument who "a table, or a list of rows (up t x ...), of measured data" data))
  (define all
    (for/list ([row (in-list rows)] [k (in-naturals)]) (checked-row who row k names start)))
  (define n (flvector-length (measured-numbers (car all))))
  (for ([m (in-list all)] [k (in-naturals)])
    (unless (= n (flvector-length (measured-numbers m)))
      (complain who "row ~a of the data has ~a numbers beside the time, the first one ~a" k
                (flvector-length (measured-numbers m)) n)))
  all)

(define (checked-row who row k names start)
  (define (fail x)
    (complain who "expected real numbers as data\n  row: ~a\n  given: ~a" k
              (describe-with-value x)))
  (define v (structure->flvector (if (list? row) (apply up row) row) fail))
  (for ([x (in-flvector v)] [j (in-naturals)])
    (unless (fl< (flabs x) +inf.0)
      (complain who "the data are not all finite numbers\n  row: ~a\n  column: ~a\n  given: ~a"
                k (if names (list-ref names j) j) x)))
  (unless (> (flvector-length v) 1)
    (complain who "expected a time and what was measured then\n  row: ~a\n  given: ~a" k
              (value->text row)))
  (when (fl< (flvector-ref v 0) start)
    (complain-showing who "data before the time of the start" "row" k
                      "time" (flvector-ref v 0) "start" start))
  (measured (flvector-ref v 0) (flvector-copy v 1)))

;; given : of all numbers, a list with one for each column, or #f -> a list of flonums, or #f
(define (check-deviations who given n)
  (define all (if (real? given) (make-list n given) given))
  (unless (or (not all)
              (and (list? all) (= n (length all))
                   (andmap (lambda (x) (and (real? x) (< 0 x +inf.0))) all)))
    (complain-of-argument
     who (format "a positive standard deviation, or a list of ~a, one for each column" n) given))
  (and all (map real->double-flonum all)))
