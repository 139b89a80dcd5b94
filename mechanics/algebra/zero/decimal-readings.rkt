#lang racket/base
;; Exact numbers that a decimal may stand for.
;;
;; 1.4142135623730951 is √2, as far as flonums can tell, and 0.30000000000000004 is 3/10.  A
;; decimal is read as the simplest number within two units in its last place, of: a
;; fraction; a root of one, up to the sixth; a root of a quadratic equation with
;; coefficients up to 100; and fractions and square roots times a power of π or e.
;;
;; A number is simple if it takes so few bits to write that meeting it by chance among the
;; flonums is out of the question: of 52 bits, less than two thirds.  So 1.41421356 stays
;; a decimal.  No proof rests on a reading alone: readings are told (zero-test.rkt).
;;
;; Numbers written differently were meant to be different: 0.3 and 0.30000000000000004, two
;; decimals of one question, are not both 3/10.  A decimal beside an exact number may be
;; that number; readings are for this.
;;
;; Reading takes milliseconds, a thousand times the cost of a flonum elsewhere, and where many
;; stand in one question they were measured or computed, not written.  So only few are read.

(require racket/list
         "../expression/exact-numbers.rkt" "../expression/expression.rkt"
         "../expression/flat-graph.rkt"
         "../expression/operation.rkt" "../expression/pi.rkt" "../expression/substitute.rkt")

(provide read-decimal decimals-in decimals-of read-decimals readings-as-written too-many-to-read?
         with-decimals-read all-different? (struct-out reading))

;; Exact e, for the algebra.
(define exact-e (make-node op:exp '(1)))

(define unit (expt 2 -52))

;; decimal : a flonum; expression : its reading, or #f
(struct reading (decimal expression) #:transparent)

;; The flonums on a tape, each once.
(define (decimals-in t)
  (remove-duplicates
   (for/list ([e (in-vector (tape-items t))] #:when (and (number? e) (not (exact? e)))) e)))

(define (decimals-of e) (decimals-in (expression->plain-tape e)))

;; A reading of each; without expressions where there are too many.
(define (read-decimals xs)
  (define few? (not (too-many-to-read? (length xs))))
  (for/list ([x (in-list xs)]) (reading x (and few? (read-decimal x)))))

(define (too-many-to-read? count) (> count most-decimals-read))

(define most-decimals-read 24)

;; Are decimals of different size read as different numbers, too?
(define (all-different? readings)
  (define sizes (make-hash))
  (for/and ([r (in-list readings)])
    (define size (magnitude (reading-decimal r)))
    (define e (reading-expression r))
    (eqv? size (hash-ref! sizes (if (negative? (reading-decimal r)) (e:negate e) e) size))))

;; e with decimals as they are read
(define (with-decimals-read e readings)
  (substitute-expression e (for/list ([r (in-list readings)])
                             (cons (reading-decimal r) (reading-expression r)))))

;; The flonums of an expression as they are written, with few digits; #f if one is not
(define (readings-as-written e)
  (define readings
    (for/list ([x (in-list (decimals-of e))])
      (reading x (and (rational? x) (as-written x)))))
  (and (andmap reading-expression readings) readings))

;; -> an exact expression, or #f
(define (read-decimal x)
  (cond [(not (rational? x)) #f]
        [(negative? x)
         (define e (read-decimal (- x)))
         (and e (e:negate e))]
        [else
         (define exact (inexact->exact x))
         (or (read-root exact 1 fraction-bits)
             (as-written x)
             (for/or ([degree (in-range 2 7)]) (read-root exact degree root-bits))
             (read-multiple exact)
             (read-quadratic exact))]))

(define fraction-bits 34)
(define root-bits 30)
(define multiple-bits 24)

;; The root of a fraction.
(define (read-root x degree most-bits)
  (define power (expt x degree))
  (define bound (* 2 degree unit power))
  (define f (simplest-between (- power bound) (+ power bound)))
  (and (<= (rational-bits f) most-bits)
       (case degree
         [(1) f]
         [(2) (make-node op:sqrt (list f))]
         [else (make-node op:expt (list f (/ 1 degree)))])))

;; A decimal of few digits, such as 6.674e-11, as the fraction that was written; else #f
(define (as-written x)
  (define mantissa (car (regexp-match #rx"^[^e]*" (number->string x))))
  (define digits (filter char-numeric? (string->list mantissa)))
  (and (<= (length digits) most-digits)
       (string->number (string-append "#e" (number->string x)))))

(define most-digits 8)

;; A fraction, or the square root of one, times a power of π or e.
(define (read-multiple x)
  (for*/or ([constant (in-list (list (cons exact-pi pi-digits) (cons exact-e e-digits)))]
            [n (in-list '(1 -1 2 -2))])
    (define rest (/ x (expt (cdr constant) n)))
    (define factor
      (or (read-root rest 1 multiple-bits) (read-root rest 2 multiple-bits)))
    (and factor (e:* factor (e:expt (car constant) n)))))

(define e-digits 27182818284590452353602874713526624978/10000000000000000000000000000000000000)

;; ---------------------------------------------------------------------------
;; Fractions

;; The simplest fraction from low to high, by the continued fractions of both; 0 <= low <= high
(define (simplest-between low high)
  (define whole (ceiling low))
  (if (<= whole high)
      whole
      (let ([below (floor low)])
        (+ below (/ 1 (simplest-between (/ 1 (- high below)) (/ 1 (- low below))))))))

;; ---------------------------------------------------------------------------
;; Quadratic equations

(define most 100)

;; a x² + b x + c = 0 with the least coefficients.  Flonums tell where to look closer.  How far
;; the root is from x, the slope 2 a x + b tells.  A root that is a fraction was looked for among
;; these.
(define (read-quadratic x)
  (define z (exact->inexact x))
  (define (c-of a b)
    (define y (+ (* a z z) (* b z)))
    (define c (round y))
    (and (<= (abs c) most) (< (abs (- y c)) 1e-9) (- (inexact->exact c))))
  (and (< 1/1000 x 1000)
       (for*/or ([a (in-range 1 (+ most 1))] [b (in-range (- most) (+ most 1))])
         (define c (c-of a b))
         (and c
              (<= (abs (+ (* a x x) (* b x) c)) (* 2 unit x (abs (+ (* 2 a x) b))))
              (quadratic-root a b c x)))))

(define (quadratic-root a b c x)
  (define D (- (* b b) (* 4 a c)))
  (define sign (if (>= (* 2 a x) (- b)) 1 -1))
  (and (positive? D)
       (not (exact? (sqrt D)))
       (e:/ (e:+ (- b) (e:* sign (make-node op:sqrt (list D)))) (* 2 a))))
