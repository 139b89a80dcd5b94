#lang racket/base
;; Starts and parameters as they are given, taken one after the other, checked, and put into
;; batches.

(require racket/flonum
         "batch.rkt" "task.rkt"
         "../error/complain.rkt"
         "../generic/describe.rkt" "../generic/up-down.rkt"
         "../motion/check.rkt"
         "../numeric/progress.rkt"
         "../value/shape.rkt")

(provide start-rows first-row batches)

(define who 'evolve-ensemble)

(define (start-rows starts parameters)
  (unless (and (sequence? starts) (not (tuple? starts)))
    (complain who "expected the starts as a list or another sequence of states\n  given: ~a"
              (describe-with-value starts)))
  (unless (or (not parameters) (and (sequence? parameters) (not (tuple? parameters))))
    (complain who
              "expected the parameters as a sequence of lists, one for each start\n  given: ~a"
              (describe-with-value parameters)))
  (define-values (more-starts? next-start) (sequence-generate starts))
  (define-values (more-parameters? next-parameters)
    (if parameters (sequence-generate parameters) (values void (lambda () '()))))
  (define (next k)
    (define more? (more-starts?))
    (when (and parameters (not (eq? more? (more-parameters?))))
      (complain who "there are more ~a than ~a\n  from: ~a"
                (if more? "starts" "rows of parameters") (if more? "rows of parameters" "starts")
                k))
    (and more? (cons (next-start) (next-parameters))))
  (rows next #f))

;; next : k -> (cons state parameters) or #f; ahead : one that was looked at, or #f
(struct rows (next [ahead #:mutable]) #:authentic)

(define (first-row r)
  (define row ((rows-next r) 0))
  (unless row (complain who "there are no starts"))
  (set-rows-ahead! r row)
  (check-parameter-list 0 (cdr row))
  (state-vector who (car row))
  (values (car row) (cdr row)))

(define (take-row! r k)
  (define ahead (rows-ahead r))
  (cond [ahead (set-rows-ahead! r #f) ahead]
        [else ((rows-next r) k)]))

;; -> (-> batch or #f)
(define (batches r example parameters size note!)
  (define k 0)
  (define n (shape-length example))
  (define m (shape-length (apply up parameters)))
  (define (next-pair)
    (define row (take-row! r k))
    (and row
         (begin0 (cons (start-vector k (car row) n) (parameter-vector k (cdr row) m))
                 (set! k (+ k 1)))))
  (lambda ()
    (define index k)
    (define pairs
      (let loop ([left size])
        (define p (and (> left 0) (next-pair)))
        (if p (cons p (loop (- left 1))) '())))
    (note-progress note! (format "~a: ~a motions begun" who k))
    (and (pair? pairs) (batch index (map car pairs) (map cdr pairs)))))

(define (start-vector k state n)
  (define (fail x) (raise-bad-start k state))
  (define y (structure->flvector state fail))
  (unless (= n (flvector-length y))
    (complain who "start ~a has ~a numbers, the first one ~a\n  start: ~a"
              k (flvector-length y) n (value->text state)))
  (for ([x (in-flvector y)]) (unless (< -inf.0 x +inf.0) (fail x)))
  (flvector->vector y))

(define (raise-bad-start k state)
  (complain who "start ~a is not made of finite real numbers\n  start: ~a" k (value->text state)))

(define (check-parameter-list k ps)
  (unless (and (list? ps) (for*/and ([p (in-list ps)] [x (in-list (scalars p))]) (real? x)))
    (complain who
              (string-append "the parameters of a start are a list of numbers and tuples of"
                             " them\n  of start ~a: ~a")
              k (value->text ps))))

(define (parameter-vector k ps m)
  (check-parameter-list k ps)
  (define v (structure->flvector (apply up ps) values))
  (unless (= m (flvector-length v))
    (complain who "start ~a has ~a parameters, the first one ~a\n  parameters: ~a"
              k (flvector-length v) m (value->text ps)))
  (flvector->vector v))
