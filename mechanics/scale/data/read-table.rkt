#lang racket/base
;; Tables read from files, whole or row by row.

(require racket/flonum
         "CSV.rkt" "NPY.rkt" "NPZ.rkt" "number-table.rkt" "table-format.rkt"
         "../../error/complain.rkt"
         "../../generic/define-plain.rkt" "../../generic/function-check.rkt"
         "../../generic/describe.rkt" "../../generic/up-down.rkt"
         "../../numeric/flvector.rkt")

(provide read-table)

(define who 'read-table)

;; names : of all columns, of a file that has none; columns : those wanted, in this order
;; fold : row so-far -> so-far, a row being an up tuple
;; -> the table; or the result of fold on its rows, from `initial` on
(define-plain (read-table file #:names [names #f] #:columns [columns #f]
                          #:fold [fold #f] #:initial [initial (void)])
  (define format (table-format who file))
  (unless (file-exists? file)
    (complain who "there is no such file\n  file: ~a" file))
  (check-fold fold initial)
  (define (use names next)
    (if fold (folded fold initial next) (collected names next)))
  (call-reading format file (and names (check-names who names))
                (and columns (check-names who columns)) use))

(define (check-fold fold initial)
  (unless (or (not fold) (takes-arguments? fold 2))
    (complain who "#:fold is a procedure of a row and what was made of those before\n  given: ~a"
              (describe-with-value fold)))
  (unless (eq? (void? initial) (not fold))
    (complain who "#:fold and #:initial, what it is given with the first row, come together")))

;; The ports are closed at the end, however it comes about.
(define (call-reading format file names columns use)
  (define custodian (make-custodian))
  (define (open)
    (parameterize ([current-custodian custodian])
      (if (eq? format 'NPY)
          (open-NPY who file (lambda () (open-input-file file)) "x")
          (open-NPZ who file))))
  (if (eq? format 'CSV)
      (call-reading-CSV who file names columns use)
      (dynamic-wind
       void
       (lambda () (use-columns (open) file names columns use))
       (lambda () (custodian-shutdown-all custodian)))))

;; Each column is read, since they may share a port.
(define (use-columns o file given columns use)
  (define all (or given (opened-names o)))
  (unless (= (length all) (length (opened-names o)))
    (complain who "#:names tells ~a names, and there are ~a columns\n  file: ~a"
              (length all) (length (opened-names o)) file))
  (define wanted (or columns all))
  (define places (for/list ([name (in-list wanted)]) (place-of who all name)))
  (define left (opened-rows o))
  (define (next)
    (and (> left 0)
         (let ([row (read-row o)])
           (set! left (- left 1))
           (for/list ([k (in-list places)]) (list-ref row k)))))
  (use wanted next))

;; ---------------------------------------------------------------------------
;; Uses of the rows

(define (folded fold initial next)
  (let loop ([so-far initial])
    (define row (next))
    (if row (loop (fold (apply up row) so-far)) so-far)))

;; A column is as long as twice the rows so far.
(define (collected names next)
  (define (grown v) (let ([w (make-flvector (* 2 (flvector-length v)))]) (flvector-copy! w v) w))
  (let loop ([n 0] [columns (for/list ([_ (in-list names)]) (make-flvector 64))])
    (define row (next))
    (cond [(not row)
           (number-table names (for/list ([c (in-list columns)]) (flvector-copy c 0 n)))]
          [(= n (flvector-length (car columns))) (add-row! n row (map grown columns) loop)]
          [else (add-row! n row columns loop)])))

(define (add-row! n row columns continue)
  (for ([x (in-list row)] [c (in-list columns)]) (flvector-set! c n x))
  (continue (+ n 1) columns))
