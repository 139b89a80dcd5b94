#lang racket/base
;; Common slips: how a wrong answer differs from the key.
;;
;; Each is a claim that is proved before it is told: that the answer is the key with the other
;; sign, that it lacks a term, and the like.

(require racket/list
         (only-in racket/math pi)
         "answer-parts.rkt" "judge-equations.rkt" "prescribed-symbols.rkt"
                 "../../generic/arithmetic.rkt" "../../generic/describe.rkt"
         "../../value/shape.rkt"
         "../../value/simplify.rkt" "../../value/structure.rkt")

(provide slip-of-values slip-of-equations slip-of-number slip-sort)

;; A remark on a slip -> sign or factor, for which worksheets may give credit; or #f
(define (slip-sort text)
  (cond [(member text (list opposite-sign opposite-term)) 'sign]
        [(or (member text (list factor-2 other-factor))
             (regexp-match? #rx"^it is right but for" text))
         'factor]
        [else #f]))

(define opposite-sign "the sign is the opposite")
(define opposite-term "one term has the opposite sign")
(define factor-2 "it is off by a factor 2")
(define other-factor "one term has another factor than it should")

;; -> a string or #f
(define (slip-of-values key answer)
  (cond [(alike? key answer) (slip-of-parts (scalars key) (scalars answer))]
        [(not (= (shape-length key) (shape-length answer))) #f]
        [(and (tuple? key) (tuple? answer) (alike? key (turned answer)))
         (if (same? key (turned answer))
             "the components are right, but up and down are exchanged"
             "up and down are exchanged")]
        [else #f]))

(define (turned x)
  (define parts (list->up (structure->list x)))
  (if (up? x) (flip parts) parts))

(define (slip-of-parts ks as)
  (define ds (for/list ([k (in-list ks)] [a (in-list as)]) (simplify (g:- a k))))
  (define (all? claim?) (andmap claim? ks as))
  (cond [(all? (lambda (k a) (same? a (g:negate k)))) opposite-sign]
        [(constant-factor ks as)
         => (lambda (c) (format "it is right but for a factor: it is ~a times what it should be"
                                (value->text c)))]
        [(and (pair? (cdr ks)) (permuted? ks as)) "the components are exchanged"]
        [else (for/or ([k (in-list ks)] [d (in-list ds)] #:unless (zero-value? d))
                (slip-of-terms k d))]))

(define (permuted? ks as)
  (and (<= (length ks) 4)
       (for/or ([p (in-permutations ks)])
         (andmap same? p as))))

;; The number by which the answer differs from the key, or #f.
(define (constant-factor ks as)
  (define ratio
    (for/first ([k (in-list ks)] [a (in-list as)] #:unless (zero-value? k))
      (simplify (g:/ a k))))
  (and ratio (number? ratio) (not (zero? ratio))
       (andmap (lambda (k a) (same? a (g:* ratio k))) ks as)
       ratio))

;; d : answer less key
(define (slip-of-terms key d)
  (define terms (terms-of key))
  (define (ratio-to t) (and (not (zero-value? t)) (simplify (g:/ d t))))
  (define ratios (filter number? (map ratio-to terms)))
  (cond [(or (null? terms) (null? (cdr terms))) #f]
        [(memv -2 ratios) opposite-term]
        [(memv -1 ratios) "a term is missing"]
        [(pair? ratios) other-factor]
        [else #f]))

;; ---------------------------------------------------------------------------
;; Equations of motion

;; right? : does an answer, in symbols of the long tuple, agree with the key?
(define (slip-of-equations names key answer right?)
  (define long (structure->list (long-tuple-of names)))
  (define-values (q v a) (apply values (map scalars (cdr long))))
  (define (with from to) (replace answer (map cons from to)))
  (cond [(right? (with v a)) "a first derivative stands where a second one should"]
        [(right? (with q v)) "a derivative is missing: a coordinate stands for its velocity"]
        [(right? (with q a)) "a second derivative is missing"]
        [(and (pair? (cdr names))
              (right? (with (append q v a) (append (turn q) (turn v) (turn a)))))
         "the coordinates are exchanged"]
        [else (slip-of-accelerations key answer names)]))

(define (turn xs) (append (cdr xs) (list (car xs))))

;; Compares the accelerations that follow from either.
(define (slip-of-accelerations key answer names)
  (define-values (k a) (values (accelerations-by key names) (accelerations-by answer names)))
  (and k a (not (andmap same? k a)) (or (factor-of-accelerations k a) (slip-of-parts k a))))

;; Multiples of an equation are right: a factor of the accelerations is one of its terms'.
(define (factor-of-accelerations k a)
  (define c (constant-factor k a))
  (and c (not (eqv? c -1)) other-factor))

;; ---------------------------------------------------------------------------
;; Numbers

(define (slip-of-number k a within?)
  (define (is? x) (within? x a))
  (define (off-by? factor) (or (is? (* k factor)) (is? (/ k factor))))
  (cond [(or (zero? k) (zero? a)) #f]
        [(is? (- k)) opposite-sign]
        [(for/or ([n (in-range 1 10)]) (off-by? (expt 10. n)))
         "it is off by a power of ten: is it in the unit asked for?"]
        [(off-by? (/ 180 pi)) "degrees and radians are mixed up"]
        [(off-by? 2) factor-2]
        [(off-by? (* 2 pi))
         "it is off by a factor 2π: angular frequency, frequency and period differ"]
        [(is? (/ k)) "it is the reciprocal"]
        [(is? (* k k)) "it is the square"]
        [(and (positive? k) (is? (sqrt k))) "it is the square root"]
        [(< (abs (- a k)) (* 1/10 (abs k))) "it is near, but not within the tolerance"]
        [else #f]))
