#lang racket/base
;; A look at a point: the value of an expression there.
;;
;; A try is a source of numbers for leaves, and a finding its result: the values
;; of the expression as it is given, and of a simpler one that should agree.

(require "assignment.rkt" "../ball/ball-tape.rkt" "existence.rkt" "flonum-independence.rkt"
         "point-value.rkt"
         "region.rkt")

(provide make-question question-e question-residual question-place question-certain?
         integer-try fraction-try placed-try
         look finding? finding-of-e
         exactly-not-zero? witness? listed-point shown)

;; e, residual : tapes of the expression and of a simpler one of the same value
;; value-of : of a tape, real or complex; certain? : are there no flonums in e?
;; decisive : the leaves on which it depends whether e has a value, as a table
(struct question (e residual place value-of certain? decisive) #:authentic)

;; numbers : -> a source of numbers; others : of those for leaves that the residual lacks
;; places : leaf -> the number that it is to be
(struct try (numbers others places) #:authentic)

;; Findings at a point: a table leaf -> (place in the list . number), and the values there.
(struct finding (leaves of-residual of-e) #:authentic)

(define (make-question e residual place)
  (define complex? (contains-complex? e))
  (question e (if (or complex? (not (contains-complex? residual))) residual e) place
            (if complex? complex-value tape-value)
            (not (or complex? (contains-flonum? e)))
            (if (eq? e residual) (hash) (decisive-leaves e))))

(define (integer-try k places) (try-from integers-from k places))
(define (fraction-try k places) (try-from fractions-from k places))

(define (try-from source k places)
  (try (lambda () (source k)) (lambda () (integers-from (+ 100 (abs k)))) places))

;; The try, with x for one leaf
(define (placed-try t leaf x) (struct-copy try t [places (hash-set (try-places t) leaf x)]))

;; ---------------------------------------------------------------------------
;; A look at a point

;; -> a finding; 'no-value where a part of e or of the residual has none, the point is out of
;; place, or e and the residual differ, so that it is outside of the assumptions of
;; simplification; 'unknown where p bits do not tell.
(define (look q t p)
  (define seen (make-assignment))
  (define place (question-place q))
  (define next ((try-numbers t)))
  (define next-other ((try-others t)))
  (define listed (make-hash))
  (define (number-of leaf arguments next)
    (assigned seen leaf arguments
              (lambda ()
                (or (hash-ref (try-places t) leaf #f) (region-place place leaf (next))))))
  (define (numbers leaf arguments)
    (define x (number-of leaf arguments next))
    (hash-ref! listed leaf (lambda () (cons (hash-count listed) x)))
    x)
  (define (other-numbers leaf arguments) (number-of leaf arguments next-other))
  (define e (question-e q))
  (define residual (question-residual q))
  (define value-of (question-value-of q))
  (define r (value-of residual numbers p))
  (define v
    (if (or (symbol? r) (eq? e residual))
        r
        (value-of e (naming (question-decisive q) numbers other-numbers) p)))
  (cond [(symbol? v) v]
        [(and (agree? r v) (region-admits? place other-numbers p)) (finding listed r v)]
        [else 'no-value]))

;; Leaves that the residual lacks are named as well if e may have no value for another number:
;; (y - y)/√x is refuted by no point that does not give x.
(define (naming decisive numbers other-numbers)
  (if (hash-empty? decisive)
      other-numbers
      (lambda (leaf arguments)
        ((if (hash-ref decisive leaf #f) numbers other-numbers) leaf arguments))))

;; ---------------------------------------------------------------------------
;; Judgement of a finding

(define (exact-number? v) (and (number? v) (exact? v)))

(define (exactly-not-zero? f)
  (and (exact-number? (finding-of-e f))
       (exact-number? (finding-of-residual f))
       (not-zero? (finding-of-e f))))

;; Not zero, and neither too great nor too small to be shown.
(define (witness? f)
  (and (not-zero? (finding-of-e f))
       (let ([size (magnitude (shown f))]) (and (rational? size) (< 0 size)))))

;; Where the value of e is not zero, the exact value that agrees with it says more: -4 where
;; leaves that cancel made it -4.0.
(define (shown f)
  (define r (finding-of-residual f))
  (value-shown (if (and (exact-number? r) (not-zero? r)) r (finding-of-e f))))

;; In the order in which the leaves were met.
(define (listed-point f)
  (for/list ([entry (in-list (sort (hash->list (finding-leaves f)) < #:key cadr))])
    (cons (car entry) (cddr entry))))
