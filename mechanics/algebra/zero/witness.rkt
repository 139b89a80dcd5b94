#lang racket/base
;; Points at which an expression is not zero.
;;
;; A witness is for a person to check, so the first points tried give small
;; integers to everything and 0 to what stands under a sine, an exponential or
;; the like, where the value is then exact.  If the expression vanishes there,
;; points with integers for all leaves follow, where its value is known to
;; within rounding; zeros at those are what "undecided" reports.  The points
;; are always the same.  Where assumptions were made they hold at every point.
;;
;; Points where all is real come first, and among these positive ones: at
;; √(b² - 4km) a person expects strong damping and masses, not negative ones.

(require "approximate.rkt" "region.rkt"
         "../expression/expression.rkt" "../expression/flat-graph.rkt"
         "../expression/operation.rkt")

(provide find-witness)

;; How many points with integers for all leaves are tried; where relations have
;; to hold, most may be in vain.
(define point-limit 12)
(define point-limit/relations 100)

;; How many of them have positive numbers only.
(define positive-points 6)

;; e, residual : tapes of the expression and of a simpler one of the same value,
;; in whose leaves the point is given, or twice the same.  The value is that of e
;; itself, so simplification is no part of the evidence; it is given exactly if that of
;; the residual is exact.
;; place : region where the point has to be.  Where simplification took signs for
;; granted, `positive?`, all integers are that may be.
;; -> witness value bound points; witness is #f if none was found.
(define (find-witness e residual place positive?)
  (define complex? #f)
  (define (try refuse!)
    (define (at k zeros) (integer-point e residual place k zeros refuse!))
    (define-values (point value) (exact-witness residual at))
    (if point
        (values point value 0 0)
        (search (region-free? place) positive? at)))
  (define-values (point value bound points) (try (lambda () (set! complex? #t))))
  (if (or point (not complex?))
      (values point value bound points)
      (try #f)))

;; ---------------------------------------------------------------------------
;; Points where transcendental functions have exact values

;; at : as integer-point, of k and zeros
(define (exact-witness residual at)
  (define-values (under only-under) (leaves-under-functions residual))
  (define more
    (if (eqv? (hash-count under) (hash-count only-under)) '() (list (cons under 0))))
  (let loop ([tries (list* (cons only-under 0) (cons only-under 1) more)])
    (cond [(null? tries) (values #f 0)]
          [else
           (define-values (point value error) (at (cdar tries) (caar tries)))
           (if (and (exact? value) (not (eqv? value 0)) (eqv? error 0))
               (values point value)
               (loop (cdr tries)))])))

(define algebraic (list op:+ op:- op:* op:/ op:expt op:sqrt op:abs))

(define (transcendental? head) (not (memq head algebraic)))

;; -> the leaves standing somewhere below a function such as sin, and those that
;; stand nowhere else.  From the root down every item learns whether it is
;; outside (bit 1), below (bit 2) or both; a literal application is a leaf.
(define (leaves-under-functions t)
  (define items (tape-items t))
  (define heads (tape-heads t))
  (define n (vector-length items))
  (define states (make-vector n 0))
  (define leaves (make-hash))
  (vector-set! states (- n 1) 1)
  (for ([k (in-range (- n 1) -1 -1)])
    (define head (vector-ref heads k))
    (define state (vector-ref states k))
    (cond [(eqv? state 0) (void)]
          [(operation? head)
           (define below (if (transcendental? head) 2 state))
           (for ([j (in-list (vector-ref (tape-operands t) k))])
             (vector-set! states j (bitwise-ior below (vector-ref states j))))]
          [(number? (vector-ref items k)) (void)]
          [else
           (hash-update! leaves (vector-ref items k) (lambda (old) (bitwise-ior old state)) 0)]))
  (define (those test)
    (for/hash ([(leaf state) (in-hash leaves)] #:when (test state)) (values leaf #t)))
  (values (those (lambda (state) (>= state 2)))
          (those (lambda (state) (eqv? state 2)))))

;; ---------------------------------------------------------------------------
;; Points with integers for all leaves

(define (search free? positive? at)
  (define tries (if free? point-limit point-limit/relations))
  (let loop ([k 0] [bound 0] [points 0])
    (cond
      [(or (= k tries) (= points point-limit)) (values #f 0 bound points)]
      [else
       (define-values (point value error)
         (at (if (or positive? (< k positive-points)) k (- positive-points k 1)) #hash()))
       (cond [(not (decent? value error)) (loop (+ k 1) bound points)]
             [(> (magnitude value) (* 4 error)) (values point value error points)]
             [else (loop (+ k 1) (max bound error) (+ points 1))])])))

(define (decent? value error)
  (and (rational? (magnitude value)) (rational? error)))

;; ---------------------------------------------------------------------------

;; Small integers for the leaves of residual, zeros for those of `zeros`; other
;; leaves get integers of their own.  A literal function has one value for one
;; argument.
;; refuse! : #f, or called where something is not real
;; -> ((leaf . number) ...), the value and the error of e there; not a number
;; where e is not defined, the point is out of place or refused.
(define (integer-point e residual place k zeros refuse!)
  (define seen (make-hash))
  (define assign (assignment seen place (integers-from k)))
  (define assign-others (assignment seen place (integers-from (+ 100 (abs k)))))
  (define listed (make-hash))           ; leaf -> (number . value)
  (define (assign-and-list leaf arguments)
    (define value
      (if (hash-ref zeros leaf #f)
          (hash-ref! seen (leaf-key leaf arguments) 0)
          (assign leaf arguments)))
    (hash-ref! listed leaf (lambda () (cons (hash-count listed) value)))
    value)
  (define-values (value error) (value-at residual assign-and-list refuse!))
  (define-values (value-of-e error-of-e)
    (if (eq? e residual) (values value error) (value-at e assign-others refuse!)))
  (if (and (agree? value error value-of-e error-of-e)
           (admitted? place assign-others))
      (values (listed-point listed) (best-known value value-of-e error-of-e) error-of-e)
      (values #f +nan.0 +nan.0)))

;; Integers of `next`, brought to where they may be, for leaves that were not seen.
(define ((assignment seen place next) leaf arguments)
  (hash-ref! seen (leaf-key leaf arguments)
             (lambda () (region-place place leaf (next leaf arguments)))))

;; In the order in which the leaves were met.
(define (listed-point listed)
  (for/list ([entry (in-list (sort (hash->list listed) < #:key cadr))])
    (cons (car entry) (cddr entry))))

;; Where the value of e is not zero, the exact value that agrees with it says more: -4 where
;; leaves that cancel made it -4.0.
(define (best-known value value-of-e error-of-e)
  (define (not-zero? x) (> (magnitude x) (* 4 error-of-e)))
  (if (and (exact? value) (not-zero? value-of-e) (not-zero? value)) value value-of-e))

(define (admitted? place lookup)
  (with-handlers ([exn:fail:contract:divide-by-zero? (lambda (x) #f)])
    (region-admits? place lookup)))

;; Where e and the residual differ, the point is outside what simplification took
;; for granted.
(define (agree? x x-error y y-error)
  (and (decent? x x-error) (decent? y y-error)
       (<= (magnitude (- x y)) (* 4 (+ x-error y-error)))))

(define (value-at t lookup refuse!)
  (with-handlers ([exn:fail:contract:divide-by-zero? (lambda (x) (values +nan.0 +nan.0))])
    (approximate-tape t lookup refuse!)))

;; A literal function is known by its name, derivative and arguments' values.
(define (leaf-key leaf arguments)
  (if (symbol? leaf)
      leaf
      (let ([head (node-head leaf)])
        (list (literal-head-name head) (literal-head-index head) arguments))))

;; The k-th source of small integers, by a linear congruence: positive ones for
;; k not negative, of either sign for k negative.
(define (integers-from k)
  (define n (abs k))
  (define state (+ 12345 (* 7919 n)))
  (define range (cond [(< n 2) 3] [(< n 6) 5] [else 11]))
  (lambda (leaf arguments)
    (set! state (modulo (+ (* 1103515245 state) 12345) 2147483648))
    (define size (+ 1 (modulo (quotient state 65536) range)))
    (if (and (negative? k) (odd? (quotient state 1048576))) (- size) size)))
