#lang racket/base
;; Values written as a table: rows of flonums with the names of their columns.
;;
;; A trajectory has a row for each of its times, a branch one for each of its points.  Anything
;; else is a sequence, taken item after item: states, points of a section, occurrences, numbers,
;; lists of numbers; and failures of an ensemble, whose rows are not-a-number throughout, so that
;; row k stays that of start k.

(require racket/flonum
         "number-table.rkt"
         "../ensemble/evolve-ensemble.rkt"
         "../export/state-variables.rkt"
         "../../dynamics/continuation/branch.rkt"
         "../../error/complain.rkt" "../../error/message-words.rkt"
         "../../generic/describe.rkt" "../../generic/up-down.rkt"
         "../../generic/wrong-argument.rkt"
         "../../motion/event/event.rkt" "../../motion/trajectory.rkt"
         "../../value/shape.rkt" (only-in "../../value/structure.rkt" structure->list))

(provide rows-of)

(define who 'write-table)

;; names : given ones, or #f; times : of a trajectory, a list, or #f for the ends of its steps
;; -> symbols, and a procedure that returns the next row, an flvector, or #f
(define (rows-of data names times)
  (when (and times (not (trajectory? data)))
    (complain who "#:times are those at which a trajectory is written\n  given: ~a"
              (describe-with-value data)))
  (cond [(trajectory? data) (trajectory-rows data names times)]
        [(branch? data) (item-rows (branch-rows data) (or names (branch-names data)))]
        [(number-table? data) (item-rows (table-rows data) (or names (table-names data)))]
        [else (item-rows data names)]))

;; ---------------------------------------------------------------------------
;; Trajectories

;; A state without the time gets it as a first column.
(define (trajectory-rows tr names times)
  (define all (or times (step-times tr)))
  (unless (list? all) (complain-of-argument who "a list of times" all))
  (define clock? (states-tell-time? tr))
  (define (state-at t) (if clock? (tr t) (up t (tr t))))
  (define example (tr (trajectory-start tr)))
  (item-rows (sequence-map state-at all)
             (or names
                 (if clock? (names-of example) (cons 't (suggested-names #f example #f))))))

(define (sequence-map f xs) (make-do-sequence (lambda () (stepping f xs))))
(define (stepping f xs) (values (lambda (l) (f (car l))) cdr xs pair? #f #f))

(define (states-tell-time? tr)
  (for/and ([t (in-list (list (trajectory-start tr) (trajectory-end tr)))])
    (tells-time? (tr t) t)))

(define (tells-time? state t)
  (define first (car (scalars state)))
  (and (real? first) (= first t)))

;; ---------------------------------------------------------------------------
;; Branches: parameter, state, period of orbits, and 1 where it is stable

(define (branch-rows b)
  (define-values (states periods) (values (branch-states b) (branch-periods b)))
  (for/list ([p (in-list (branch-parameters b))] [state (in-list states)]
             [T (in-list (or periods states))]
             [stable? (in-list (branch-stabilities b))])
    (apply up p (append (scalars state) (if periods (list T) '())
                        (list (if stable? 1 0))))))

(define (branch-names b)
  (append '(parameter)
          (names-of (car (branch-states b)) (branch-system b (car (branch-parameters b))))
          (if (branch-periods b) '(period) '()) '(stable)))

;; ---------------------------------------------------------------------------
;; Sequences

(define (item-rows items given-names)
  (when (or (not (sequence? items)) (tuple? items) (number? items) (string? items))
    (complain-of-argument who "a trajectory, a table or a sequence of states" items))
  (define-values (more? next-item) (sequence-generate items))
  (define failures 0)                   ; before the first item that is none
  (define first
    (let skip ()
      (define item (and (more?) (next-item)))
      (cond [(ensemble-failure? item) (set! failures (+ failures 1)) (skip)]
            [else item])))
  (define names
    (cond [given-names (check-names who given-names)]
          [first (names-of first)]
          [else (complain who "there are no rows, and no #:names tell the columns")]))
  (define index -1)
  (define (row item)
    (set! index (+ index 1))
    (item->row item index names))
  (values names
          (lambda ()
            (cond [(> failures 0) (set! failures (- failures 1)) (row #f)]
                  [first (begin0 (row first) (set! first #f))]
                  [(more?) (let ([item (next-item)]) (row (if (ensemble-failure? item) #f item)))]
                  [else #f]))))

;; item : #f for a failure
(define (item->row item index names)
  (define n (length names))
  (define (fail x)
    (complain who "expected real numbers\n  row: ~a\n  given: ~a" index (describe-with-value x)))
  (define row
    (if item (structure->flvector (content item) fail) (make-flvector n +nan.0)))
  (unless (= n (flvector-length row))
    (complain who "row ~a has ~a, for ~a\n  row: ~a\n  columns: ~a" index
              (counted (flvector-length row) "number") (counted n "column")
              (value->text item) (value->text names)))
  row)

;; -> a structure or a scalar
(define (content item)
  (cond [(occurrence? item) (occurrence-content item)]
        [(list? item) (apply up item)]
        [else item]))

;; The state, with the time before it unless it tells it itself.
(define (occurrence-content o)
  (define-values (t state) (values (occurrence-time o) (occurrence-state o)))
  (if (tells-time? state t) state (up t state)))

;; As programs in other languages name them: t, q and v for a state (up t q v).
(define (names-of item [derivative #f])
  (define example (content item))
  (define local? (and (tuple? example) (local-state? (structure->list example))))
  (suggested-names derivative example (and local? (not (list? item)))))
