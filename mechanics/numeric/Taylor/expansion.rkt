#lang racket/base
;; Taylor coefficients of a motion: y' = f(y) solved as a power series, order by order.
;;
;; The coefficients of f up to order k follow from those of y by recurrences (recurrence-list.rkt),
;; and y_{k+1} = f_k / (k + 1).  They are those of t/h, for a unit h of time near the length of
;; a step, so that none overflows whatever the system's own units: y_{k+1} = h f_k / (k + 1).
;; It is divided by k + 1: a factor 1/(k + 1) would be rounded in the same direction at every
;; step, and a long run drift.
;;
;; Recurrences are closures at first (kernels.rkt), and machine code (motion-code.rkt) once enough
;; expansions have paid for it, where the processor is known; both give the same bits.

(require racket/fixnum racket/flonum
         racket/list
         racket/unsafe/ops
         "kernels.rkt" "motion-code.rkt" "recurrence-list.rkt" "recurrence-code.rkt"
         "recurrence-shape.rkt"
         (only-in "../machine/executable.rkt" machine?)
         "../record-fields.rkt" "../unboxed-loop.rkt")

(provide (struct-out expander) (struct-out work) work-of-order
         make-recurrences recurrences-coded? recurrences->expansion
         expansion-order expansion-states expansion-slopes expansion-lasts
         expansion-machine
         tape-run-advance tape-run-value tape-run-rates tape-run-tape tape-run-sizes
         expand! follow! coefficient-row)

;; A maker of expansions.  make : order -> expansion; work : the cost of one of them;
;; branches? : may they go on where f takes another branch, as that of √x² = x does where x < 0?
(struct expander (make work branches?)
  #:authentic
  #:property prop:procedure 0)

;; How many nodes there are, functions among them, rows that do not end, and convolutions for each
;; order; is there machine code for them on processors that have any?
(struct work (nodes functions rows convolutions coded?) #:authentic)

;; Nanoseconds or so, of an expansion of order n and the step it is made for, as measured: by
;; kernels, of which machine code takes 0.4.  They are the same on all processors, so that these
;; take the same steps.
(define (work-of-order w n)
  (* (if (work-coded? w) 0.4 1.0)
     (+ 300 (* 12 (work-nodes w))
        (* n (+ 4 (* 1.8 (work-rows w))))
        (* n n 0.45 (work-convolutions w)))))

;; count  : of rows, of which the first are those of the inputs
;; states, slopes : lists of rows, y and f(y)
;; starts : recurrences of order 0; ending, endless : of the others, those of rows that end, each
;; behind its last order, and those of rows that do not
;; follow? : are the inputs known, or a solution of y' = f(y)?
;; numbers : those that code takes from the tape, a list; codes : tape-codes, or #f where there are
;; none
(struct recurrences (count states slopes starts ending endless follow? numbers codes) #:authentic)

;; Machine code of all recurrences that differ in numbers only.  list : these, without numbers
;; runs : so many times kernels were run, by all expansions; threads may lose some
;; of-order : order -> list of procedures
(struct tape-codes (list [runs #:mutable] [of-order #:mutable]) #:authentic)

;; kept : box of a hash, shared by recurrences of one program; threads may lose an entry
(define (make-recurrences kept count states slopes starts ending endless follow?)
  (define coded? (andmap coded-recurrence? (append starts (map cdr ending) endless)))
  (define-values (abstract numbers)
    (if coded? (without-numbers (list starts ending endless)) (values '() '())))
  (define key (list* count follow? states slopes abstract))
  (recurrences count states slopes starts ending endless follow? numbers
               (and coded? (kept-codes kept key abstract))))

;; Code finds numbers behind the last row: so it is that of so many rows.
(define (kept-codes kept key abstract)
  (define all (unbox kept))
  (define (make-and-keep)
    (define new (tape-codes abstract 0 (hasheqv)))
    (set-box! kept (hash-set (if (< (hash-count all) most-kept) all (hash)) key new))
    new)
  (hash-ref all key make-and-keep))

(define most-kept 50)

;; Is there machine code for them, if for any?
(define (recurrences-coded? rs) (and (recurrences-codes rs) #t))

;; list    : recurrences; rows : vector of all rows, flvectors
;; order   : the last one; states, slopes : vectors of flvectors
;; lasts   : fxvector, where the rows of the states end
;; moving  : vector, state and slope in turn, of those that do not end
;; starts  : vector of kernels, for order 0; ending : list of those below; kernels : vector of those
;; whose rows do not end
;; machine : machine code, #f where there is none, 'later until it was earned
(struct expansion (list rows order states slopes lasts moving starts ending kernels
                   [machine #:mutable])
  #:authentic)

;; expand, advance, value, rates : procedures (motion-code.rkt), of which those that follow known
;; rows have the first alone; given : vector of the flvectors of states and slopes; tape; sizes
(struct tape-run (expand advance value rates given tape sizes) #:authentic)

;; A kernel of rows that are 0 beyond an order.
(struct ending (last kernel) #:authentic)

;; inputs : flvector of the values of all inputs, of which those that are no states stay
(define (recurrences->expansion rs order inputs)
  (define rows (build-vector (recurrences-count rs) (lambda (_) (make-flvector (+ order 1)))))
  (for ([x (in-flvector inputs)] [row (in-vector rows)]) (put! row 0 x))
  (define (flvectors rs) (for/list ([r (in-list rs)]) (vector-ref rows (row-index r))))
  (define-fields recurrences rs states slopes starts endless)
  (define kernels (make-hasheq))
  (define (kernel r) (hash-ref! kernels r (lambda () (recurrence->kernel r rows))))
  (expansion rs rows order (list->vector (flvectors states)) (list->vector (flvectors slopes))
             (for/fxvector ([s (in-list states)]) (max 1 (min order (last-index s))))
             (list->vector
              (append* (for/list ([s (in-list states)] [slope (in-list slopes)] #:unless (ends? s))
                         (flvectors (list s slope)))))
             (list->vector (map kernel starts))
             (for/list ([e (in-list (recurrences-ending rs))]) (ending (car e) (kernel (cdr e))))
             (list->vector (map kernel endless))
             'later))

(define (coefficient-row e i) (vector-ref (expansion-states e) i))

;; Coefficients of the motion from the state y on, in the unit h.
(define (expand! e y h)
  (define states (expansion-states e))
  (each (i 0 (vector-length states)) (put! (unsafe-vector-ref states i) 0 (at y i)))
  (define m (machine-of e))
  (if m (run-machine! m h) (expand-by-kernels! e h)))

(define (expand-by-kernels! e h)
  (define-fields expansion e states slopes moving order kernels ending)
  (run-all! (expansion-starts e) 0)
  (let loop ([k 1])
    (if (unsafe-fx<= k latest-end) (next-of-all! states slopes h k) (next-of! moving h k))
    (when (unsafe-fx< k order)
      (when (unsafe-fx<= k latest-end) (run-ending! ending k))
      (run-all! kernels k)
      (loop (unsafe-fx+ k 1)))))

;; Rows that end are 0 from the order after this one on.
(define latest-end 5)

(define-syntax-rule (next! state slope h k)
  (put! state k (unsafe-fl/ (unsafe-fl* h (at slope (unsafe-fx- k 1))) (unsafe-fx->fl k))))

(define (next-of-all! states slopes h k)
  (for ([state (in-vector states)] [slope (in-vector slopes)]) (next! state slope h k)))

(define (next-of! moving h k)
  (define n (vector-length moving))
  (let loop ([i 0])
    (when (unsafe-fx< i n)
      (next! (unsafe-vector-ref moving i) (unsafe-vector-ref moving (unsafe-fx+ i 1)) h k)
      (loop (unsafe-fx+ i 2)))))

;; Coefficients that depend on rows known already, up to the order.
(define (follow! e)
  (define m (machine-of e))
  (if m (run-machine! m 1.0) (follow-by-kernels! e)))

(define (follow-by-kernels! e)
  (run-all! (expansion-starts e) 0)
  (for ([k (in-range 1 (+ 1 (expansion-order e)))])
    (run-ending! (expansion-ending e) k)
    (run-all! (expansion-kernels e) k)))

(define (run-all! kernels k)
  (each (i 0 (vector-length kernels)) ((unsafe-vector-ref kernels i) k)))

(define (run-ending! kernels k)
  (unless (null? kernels)
    (when (unsafe-fx<= k (ending-last (car kernels))) ((ending-kernel (car kernels)) k))
    (run-ending! (cdr kernels) k)))

;; ---------------------------------------------------------------------------
;; Machine code

;; About so many expansions take as much less time by machine code as it takes to write.
(define runs-that-pay 500)

(define (run-machine! m h)
  ((tape-run-expand m) h (tape-run-given m) (tape-run-tape m) (tape-run-sizes m)))

(define (machine-of e)
  (define m (expansion-machine e))
  (if (eq? m 'later) (earned-machine! e) m))

(define (earned-machine! e)
  (define codes (recurrences-codes (expansion-list e)))
  (and codes
       (let ([runs (+ 1 (tape-codes-runs codes))])
         (set-tape-codes-runs! codes runs)
         (and (> runs runs-that-pay)
              (let ([code (code-of-order (expansion-list e) codes (expansion-order e))])
                (set-expansion-machine! e (and code (make-machine e code)))
                (expansion-machine e))))))

(define (code-of-order rs codes order)
  (define known (tape-codes-of-order codes))
  (define (make-and-keep)
    (define code (make-code rs (tape-codes-list codes) order))
    (when code (set-tape-codes-of-order! codes (hash-set known order code)))
    code)
  (hash-ref known order make-and-keep))

;; -> list of procedures, or #f where the processor is not known, there is no memory for them, or
;; fewer coefficients than steps need
(define (make-code rs abstract order)
  (define-fields recurrences rs count states slopes follow?)
  (define-values (starts ending endless) (apply values abstract))
  (and (machine?)
       (>= order 3)
       (andmap start-found? starts)
       ((if follow? follow-code motion-code)
        count states slopes starts ending endless order latest-end)))

;; The tape begins with the constants among the inputs, and ends with numbers.
(define (make-machine e code)
  (define-fields expansion e rows order states slopes)
  (define numbers (recurrences-numbers (expansion-list e)))
  (define end (* (vector-length rows) (+ order 1)))
  (define tape (make-flvector (+ end (length numbers))))
  (for ([row (in-vector rows)] [k (in-naturals)]) (put! tape (* k (+ order 1)) (at row 0)))
  (for ([x (in-list numbers)] [k (in-naturals end)]) (put! tape k x))
  (define-values (expand advance value rates)
    (if (recurrences-follow? (expansion-list e))
        (values (car code) #f #f #f)
        (apply values code)))
  (tape-run expand advance value rates
           (list->vector (append (vector->list states) (vector->list slopes)))
           tape (make-flvector 4)))
