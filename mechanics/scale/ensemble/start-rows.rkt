#lang racket/base
;; Takes the given starts and parameters one after the other, checks them, and puts them into
;; batches.

(require racket/flonum
         "task.rkt"
         "../../error/complain.rkt" "../../error/hint.rkt"
         "../../generic/describe.rkt" "../../generic/up-down.rkt"
         "../../motion/system/check.rkt"
         "../../numeric/finite-number.rkt" "../../numeric/flvector.rkt" "../../error/progress.rkt"
         "../../value/shape.rkt" (only-in "../../value/structure.rkt" structure->list))

(provide start-rows first-row batches)

(define who 'evolve-ensemble)

;; -> (k -> (cons state parameters) or #f), the rows one after the other
(define (start-rows starts parameters)
  (check-rows starts "expected the starts as a list or another sequence of states")
  (when parameters
    (check-rows parameters
                "expected the parameters as a sequence of lists, one for each start"))
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
  next)

;; Numbers, texts and hashes are sequences as well, but not of states.
(define (check-rows x expected)
  (when (or (not (sequence? x)) (tuple? x) (number? x) (string? x) (bytes? x) (hash? x))
    (complain who "~a\n  given: ~a" expected (describe-with-value x))))

;; -> the first state and its parameters, and the rows from that one on
(define (first-row next)
  (define row (next 0))
  (unless row (complain who "there are no starts"))
  (check-parameter-list 0 (cdr row))
  (check-finite (car row))
  (state-vector who (car row))
  (define ahead row)
  (define (next-from-first k) (if ahead (begin0 ahead (set! ahead #f)) (next k)))
  (values (car row) (as-flonums (cdr row)) next-from-first))

;; A number that is not finite is told with the index of its start, 0.
(define (check-finite state)
  (when (tuple? state)
    (define numbers (filter number? (scalars state)))
    (unless (andmap finite? numbers) (raise-bad-start 0 state))))

;; The parameters as workers receive them.
(define (as-flonums ps)
  (define all (apply up ps))
  (structure->list (flvector->structure all (structure->flvector all values))))

;; -> a procedure that returns the next batch, or #f
(define (batches next example parameters size note!)
  (define k 0)
  (define shape (apply up parameters))
  (define (next-pair)
    (define row (next k))
    (and row
         (begin0 (cons (start-vector k (car row) example) (parameter-vector k (cdr row) shape))
                 (set! k (+ k 1)))))
  (lambda ()
    (define index k)
    (define pairs
      (let loop ([left size])
        (define p (and (> left 0) (next-pair)))
        (if p (cons p (loop (- left 1))) '())))
    (note-progress note! (format "~a: ~a motions begun" who k))
    (and (pair? pairs) (batch index (map car pairs) (map cdr pairs)))))

(define (start-vector k state example)
  (define (fail x) (raise-bad-start k state))
  (define y (structure->flvector state fail))
  (define n (shape-length example))
  (unless (= n (flvector-length y))
    (complain who "start ~a has ~a numbers, the first one ~a\n  start: ~a"
              k (flvector-length y) n (value->text state)))
  (unless (same-shape? state example)
    (complain who "start ~a is of another shape than the first one\n  start: ~a\n  first: ~a"
              k (value->text state) (value->text example)))
  (unless (flvector-finite? y) (fail state))
  (flvector->vector y))

(define (raise-bad-start k state)
  (complain who "start ~a is not made of finite real numbers\n  start: ~a~a"
            k (value->text state) (list-hint state "(up t q v)")))

(define (check-parameter-list k ps)
  (unless (and (list? ps) (for*/and ([p (in-list ps)] [x (in-list (scalars p))]) (finite? x)))
    (complain who
              (string-append "the parameters of a start are a list of finite numbers and tuples"
                             " of them\n  of start ~a: ~a")
              k (value->text ps))))

;; shape : of the parameters of the first start, as a tuple
(define (parameter-vector k ps shape)
  (check-parameter-list k ps)
  (define all (apply up ps))
  (unless (same-shape? all shape)
    (complain who "start ~a has parameters of another shape than the first one\n  ~a: ~a\n  ~a: ~a"
              k "parameters" (value->text ps) "of the first" (value->text (structure->list shape))))
  (flvector->vector (structure->flvector all values)))
