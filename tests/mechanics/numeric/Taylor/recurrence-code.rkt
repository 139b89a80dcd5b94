#lang racket/base
;; Machine code of recurrences has the coefficients that kernels give, bit for bit: of random lists
;; of all kinds, with infinite, tiny and missing numbers among the coefficients.  Lists that differ
;; in numbers share it.

(require racket/flonum
         racket/list
         mechanics/numeric/machine/executable
         mechanics/numeric/Taylor/expansion
         mechanics/numeric/Taylor/kernels
         mechanics/numeric/Taylor/recurrence-list
         mechanics/numeric/Taylor/motion-code
         "../../support/checks.rkt" "../../support/random.rkt" "../../support/skip.rkt")

(define order 13)
(define given 6)                        ; rows that are known, the first of which end

(define (random-degree k) (if (< k 3) k +inf.0))

;; wild : how often a coefficient is no plain number
(define (random-coefficient wild)
  (if (< (random) wild)
      (random-choice +nan.0 +inf.0 -inf.0 0.0 -0.0 4.9e-324 1e-310 -1e308)
      (random-flonum)))

(define (random-rows count wild)
  (for/vector #:length count ([k (in-range count)])
    (for/flvector #:length (+ order 1) ([j (in-range (+ order 1))])
      (if (and (< k given) (<= j (random-degree k))) (random-coefficient wild) 0.0))))

;; A list of recurrences that make rows from `given` on -> starts, steps, and how many rows there
;; are
(define (random-list length)
  (for/fold ([starts '()] [steps '()] [count given]) ([_ (in-range length)])
    (define-values (more-starts more-steps rows) (random-recurrences count))
    (values (append starts more-starts) (append steps more-steps) (+ count rows))))

;; k : the number of the next row -> recurrences of order 0, others, and how many rows these make
(define (random-recurrences k)
  (define (any) (let ([i (random k)]) (row i (if (< i given) (random-degree i) +inf.0))))
  (define (endless) (row (+ 3 (random (- k 3))) +inf.0))
  (define (new i) (row (+ k i) +inf.0))
  (define-values (r p q) (values (new 0) (new 1) (new 2)))
  (define (some make) (for/list ([_ (in-range (+ 1 (random 5)))]) (make)))
  (define (weight) (random-choice 1.0 -1.0 (random-flonum)))
  (define base (random-choice #f (weighed (weight) (any))))
  (define (always recurrences [rows 1]) (values recurrences recurrences rows))
  (define (after starts . steps) (values starts steps (length starts)))
  (define (start name x [r r])
    (make-recurrence 'value r name (hash-ref functions name) x))
  (case (random 13)
    [(0) (always (sum-recurrences r (some (lambda () (weighed (weight) (any)))) base))]
    [(1 2) (always (product-recurrences r (some (lambda () (product (weight) (any) (any)))) base))]
    [(3) (always (square-recurrences r (some (lambda () (weighed (weight) (endless)))) base))]
    [(4) (let ([n (+ 1 (random 3))] [b (endless)])
           (always (shared-product-recurrences
                    (for/list ([i (in-range n)]) (target (new i) (endless))) b)
                   n))]
    [(5) (let ([x (any)])
           (after (list (start 'sin x) (start 'cos x p) (start 'exp x q))
                  (make-recurrence 'derivative q x)
                  (pair-recurrence r 1.0 p -1.0 (row (row-index q) (row-degree x)))))]
    [(6) (let ([x (any)])
           (after (list (start 'exp x) (make-recurrence 'constant p 0.0)
                        (make-recurrence 'constant q 0.0))
                  (make-recurrence 'derivative p x)
                  (differential-recurrence q (weight) p r #f)
                  (make-recurrence 'integral r q)))]
    [(7) (let ([x (any)] [y (any)])
           (define copy (sum-recurrences r (list (weighed 1.0 x)) #f))
           (values (list (make-recurrence 'ratio r x y))
                   (append copy (list (leading-recurrence r y)))
                   1))]
    [(8) (after (list (make-recurrence 'power-value r (any) 1/2))
                (make-recurrence 'root r (any)))]
    [(9) (after (list (make-recurrence 'power-value r (any) -1))
                (make-recurrence 'reciprocal r (any)))]
    [(10) (let ([n (random-choice 3/2 -3/2 -3 0.3 -1.7)])
            (after (list (make-recurrence 'power-value r (any) n))
                   (make-recurrence 'power r (any) (real->double-flonum n))))]
    [(11) (after (list (make-recurrence 'constant r (weight)) (start 'sqrt (any) p))
                 (make-recurrence 'derivative r (any))
                 (make-recurrence 'differential-leading r (any)))]
    [else (let ([d (row 1 1)])
            (after (list (start 'cos d) (start 'sin d p)) (pair-recurrence r 1.0 p -1.0 d)))]))

(define functions (hasheq 'sin flsin 'cos flcos 'exp flexp 'sqrt flsqrt))

;; ---------------------------------------------------------------------------

(define (by-kernels! starts steps rows)
  (define (kernels rs) (for/list ([r (in-list rs)]) (recurrence->kernel r rows)))
  (for ([kernel (in-list (kernels starts))]) (kernel 0))
  (define all (kernels steps))
  (for* ([k (in-range 1 (+ order 1))] [kernel (in-list all)]) (kernel k)))

;; Machine code fills rows that are made; others are given.
(define (by-code! starts steps rows)
  (define count (vector-length rows))
  (define (rows-between from end) (for/list ([k (in-range from end)]) (row k +inf.0)))
  (define code
    (follow-code count (rows-between 0 given) (rows-between given count) starts '() steps order 5))
  ((car code) 1.0 rows (make-flvector (* count (+ order 1))) (make-flvector 4)))

(define (copied rows) (for/vector ([r (in-vector rows)]) (flvector-copy r)))

(define (check-list length wild)
  (define-values (starts steps count) (random-list length))
  (define rows (random-rows count wild))
  (define others (copied rows))
  (by-kernels! starts steps rows)
  (by-code! starts steps others)
  (for ([row (in-vector rows)] [other (in-vector others)] [i (in-naturals)])
    (for ([x (in-flvector row)] [y (in-flvector other)] [k (in-naturals)] #:unless (eqv? x y))
      (with-check-info (['row i] ['order k] ['kinds (map recurrence-kind steps)])
        (check-eqv? y x)))))

;; -> expansion of y' = w y, of which machine code is kept in the box
(define (exponential w kept order)
  (define-values (y slope) (values (row 0 +inf.0) (row 1 +inf.0)))
  (define all (sum-recurrences slope (list (weighed w y)) #f))
  (recurrences->expansion (make-recurrences kept 2 (list y) (list slope) all '() all #f)
                          order (flvector 0.0)))

(skip-unless (machine?) "no processor that machine code is written for"
  (test-case "systems that differ in numbers earn their code together, and share it"
    (define kept (box (hash)))
    (define rates '(2.0 -3.0))
    (define expansions (for/list ([w (in-list rates)]) (exponential w kept order)))
    (for* ([_ (in-range 300)] [e (in-list expansions)]) (expand! e (flvector 1.0) 1.0))
    (check-equal? (hash-count (unbox kept)) 1)
    (for ([e (in-list expansions)] [w (in-list rates)])
      (check-not-eq? (expansion-machine e) 'later)
      (for/fold ([expected 1.0]) ([c (in-flvector (coefficient-row e 0))] [k (in-naturals 1)])
        (check-= c expected 1e-14)
        (/ (* expected w) k))))
  (test-case "random recurrences, short lists and long"
    (with-seeds 200 (check-list 12 0.0))
    (with-seeds 10 (check-list 200 0.0)))
  (test-case "among numbers that are infinite, tiny, or missing"
    (with-seeds 200 (check-list 10 0.02))))
