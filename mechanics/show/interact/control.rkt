#lang racket/base
;; Controls: the names whose values a reader of an interaction changes.
;;
;; A control has finitely many values, in a vector: the numbers of a range, choices,
;; false and true.  A slider, a menu and a page computed beforehand need their positions alone.
;; Only a text may be anything.
;;
;; Numbers of a range are exact where its ends, step and start are; others are the flonums nearest
;; to the decimals that one would write: 0.3 is the third step of 0.1, not 0.30000000000000004.

(require racket/math
         "../../error/complain.rkt" "../../error/message-words.rkt"
         "../../generic/describe.rkt" "../../generic/wrong-argument.rkt"
         "../../numeric/finite-number.rkt")

(provide number-control value-control control?
         control-name control-kind control-values control-start control-from control-to control-step
         control-position control-text value->label
         value-from-outside)

;; kind : 'number, 'choice, 'boolean or 'text; start : the value at first
;; values : vector of all values in their order, #f of a text; step : of a number, or #f
(struct control (name kind values start step) #:authentic)

(define who 'interact)

(define (control-from c) (vector-ref (control-values c) 0))
(define (control-to c)
  (define values (control-values c))
  (vector-ref values (- (vector-length values) 1)))

;; -> the number of a value among those of its control, from 0
(define (control-position c value)
  (for/first ([v (in-vector (control-values c))] [k (in-naturals)] #:when (equal? v value)) k))

;; ---------------------------------------------------------------------------
;; Ranges of numbers

;; step, start : numbers, or #f where none is given
(define (number-control name from to step start)
  (check-end name "begins" from)
  (check-end name "ends" to)
  (check-range name from to)
  (when step (check-step name from to step))
  (when start (check-start name from to start))
  (define chosen (or step (usual-step from to (or start from))))
  (define all (steps name from to chosen (not step)))
  (define exact-ones? (andmap exact? (list from to chosen (or start from))))
  (define (as-number x) (if exact-ones? x (exact->inexact x)))
  (define numbers (map as-number (with-start all (decimal (or start from)))))
  (control name 'number (list->vector numbers) (as-number (decimal (or start from)))
           (as-number (decimal chosen))))

;; All numbers from `from` in steps up to `to`, which is one of them in any case if to-the-end?
(define (steps name from to step to-the-end?)
  (define-values (a b s) (values (decimal from) (decimal to) (decimal step)))
  (define n (floor (/ (- b a) s)))
  (unless (< n most-values)
    (complain who "~a would have ~a values in steps of ~a; a slider has at most ~a\n  ~a"
              name (+ n 1) step most-values "choose a larger #:step"))
  (define all (for/list ([k (in-range (+ n 1))]) (+ a (* k s))))
  (if (and to-the-end? (< (+ a (* n s)) b)) (append all (list b)) all))

(define most-values 10000)

(define (with-start xs start)
  (if (member start xs) xs (sort (cons start xs) <)))

;; The exact number that the flonum is written as.
(define (decimal x)
  (if (exact? x) x (string->number (number->string x) 10 'read 'decimal-as-exact)))

;; A step of 1 among whole numbers, if there are some; else 1, 2 or 5 times a power of ten that
;; makes at most a hundred steps.
(define (usual-step from to start)
  (define range (- (decimal to) (decimal from)))
  (define whole? (andmap exact-integer? (list from to start)))
  (cond [(and whole? (<= least-whole range most-whole)) 1]
        [else (round-step (/ range 100))]))

(define-values (least-whole most-whole) (values 5 200))

;; The least of the round numbers that are not less than x, an exact number
(define (round-step x)
  (define power (expt 10 (order-of-magnitude x)))
  (for/first ([factor (in-list '(1 2 5 10))] #:when (<= x (* factor power))) (* factor power)))

(define (check-end name verb x)
  (unless (and (real? x) (finite? x))
    (complain-of-argument who (format "a number at which the range of ~a ~a, as in [~a 1 10]"
                                      name verb name)
                          x)))

(define (check-range name from to)
  (cond [(= from to) (complain who "the range of ~a is empty: from ~a to ~a" name from to)]
        [(> from to)
         (complain who "the range of ~a goes down, from ~a to ~a\n  ~a: [~a ~a ~a]"
                   name from to "the lesser number stands first" name to from)]))

(define (check-step name from to step)
  (unless (and (real? step) (finite? step) (> step 0))
    (complain-of-argument who (format "a positive number as step of ~a" name) step))
  (when (> step (- to from))
    (complain who "the step of ~a, ~a, is larger than its range from ~a to ~a" name step from to)))

(define (check-start name from to start)
  (unless (and (real? start) (finite? start))
    (complain-of-argument who (format "a number at which ~a starts" name) start))
  (unless (<= from start to)
    (complain who "~a starts at ~a, outside of its range from ~a to ~a" name start from to)))

;; ---------------------------------------------------------------------------
;; Choices, booleans, texts

;; x : a list of choices, a boolean or a text; start : -> one of the choices, or #f
(define (value-control name x start)
  (cond [(pair? x) (choice-control name x (if start (start) (car x)))]
        [(null? x) (complain who "the list of choices of ~a is empty" name)]
        [start
         (complain who "~a starts with what stands in place of a list; ~a\n  given: ~a"
                   name "#:start is for numbers and choices" (describe-with-value x))]
        [(boolean? x) (control name 'boolean (vector #f #t) x #f)]
        [(string? x) (control name 'text #f x #f)]
        [(number? x)
         (complain who "~a has one number, and a range has two: [~a from to]\n  given: ~a"
                   name name (describe-with-value x))]
        [else
         (complain-of-argument
          who (format "two numbers, a list of choices, #t, #f or a text for ~a" name) x)]))

(define (choice-control name choices start)
  (check-argument who list? choices (format "a list of choices for ~a" name))
  (unless (member start choices)
    (complain who "~a starts at ~a, which is none of its choices\n  choices: ~a"
              name (value->label start) (joined (map value->label choices))))
  (control name 'choice (list->vector choices) start #f))

;; A value as it stands beside its control.
(define (value->label x) (if (string? x) x (value->text x)))

;; ---------------------------------------------------------------------------

;; As it is written in `interact`.
(define (control-text c)
  (define-values (name start) (values (control-name c) (control-start c)))
  (define (written x) (if (string? x) (format "~s" x) (value->text x)))
  (define starting
    (if (memq (control-kind c) '(number choice))
        (if (equal? start (control-from c)) "" (format " #:start ~a" (written start)))
        ""))
  (case (control-kind c)
    [(number) (format "[~a ~a ~a #:step ~a~a]" name (control-from c) (control-to c)
                      (control-step c) starting)]
    [(choice) (format "[~a (list ~a)~a]" name
                      (joined (map written (vector->list (control-values c))) " ") starting)]
    [else (format "[~a ~a]" name (written start))]))

;; ---------------------------------------------------------------------------
;; Values from outside

;; x : from a page or a notebook, as JSON has it: a number; the position of a choice, from 0; a
;; boolean; a string
;; -> the value: the nearest one of a range, the last choice for a position beyond it
(define (value-from-outside c x)
  (define values (control-values c))
  (define (check good? expected)
    (unless (good? x) (complain-of-datum who (format "~a for ~a" expected (control-name c)) x)))
  (case (control-kind c)
    [(number)
     (check (lambda (x) (and (real? x) (finite? x))) "a number")
     (nearest values x)]
    [(choice)
     (check exact-integer? "the number of a choice")
     (vector-ref values (max 0 (min x (- (vector-length values) 1))))]
    [(boolean) (check boolean? "#t or #f") x]
    [else (check string? "a text") x]))

(define (nearest numbers x)
  (for/fold ([best (vector-ref numbers 0)]) ([n (in-vector numbers)])
    (if (< (abs (- n x)) (abs (- best x))) n best)))
