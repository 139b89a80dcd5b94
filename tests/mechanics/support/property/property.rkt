#lang racket/base
;; Properties of simplification, fingerprints and verdicts.
;;
;; A property maps an expression, and what was derived from it, to #f or to a
;; text that says what went wrong.  Values are compared at points where the
;; assumptions simplification reports hold: elsewhere it claims nothing.

(require mechanics/algebra/expression/expression
         mechanics/algebra/expression/operation
         mechanics/algebra/simplify/simplify-expression
         mechanics/algebra/zero/fingerprint
         mechanics/algebra/zero/zero-test
         mechanics/algebra/expression/read
         "../evaluate.rkt"
         "value.rkt")

(provide value-kept idempotent
         same-by-form same-by-print same-by-fingerprint same-by-verdict
         told-apart)

(define points '(1 2 3 4 5 6))

(define (shown e) (format "~s" (expression->datum e)))

(define (holds? assumption point)              ; (>= expression 0)
  (define v (value-at-point (datum->expression (cadr assumption)) point))
  (and v (agree? v (value-at-point (datum->expression `(abs ,(cadr assumption))) point))))

;; ---------------------------------------------------------------------------
;; One expression

;; Equal where both are defined; and defined wherever the expression is.
(define (value-kept e)
  (define-values (s assumptions) (simplify-expression/assumptions e))
  (for/or ([p (in-list points)])
    (define u (value-at-point e p))
    (and u
         (not (undefined? s))
         (andmap (lambda (a) (holds? a p)) assumptions)
         (let ([v (value-at-point s p)])
           (cond [(not v) (format "~a has no value at point ~a" (shown s) p)]
                 [(differ? u v)
                  (format "at point ~a the value is ~a, of ~a it is ~a, assuming ~a"
                          p (car u) (shown s) (car v) assumptions)]
                 [else #f])))))

;; A division by zero may be left standing.
(define (undefined? e)
  (node-fold e
             (lambda (leaf) #f)
             (lambda (n parts)
               (or (ormap values parts)
                   (and (eq? (node-head n) op:/) (eqv? 0 (cadr (node-args n))))))))

(define (idempotent e)
  (define s (simplify-expression e))
  (define again (simplify-expression s))
  (and (not (equal? (expression->datum s) (expression->datum again)))
       (format "~a, simplified again ~a" (shown s) (shown again))))

;; ---------------------------------------------------------------------------
;; Two equal expressions

(define (difference e other) (make-node op:- (list e other)))

(define (contains-flonum? e)
  (node-fold e
             (lambda (leaf) (and (number? leaf) (not (exact? leaf))))
             (lambda (n parts) (ormap values parts))))

(define (same-by-form e other)
  (define d (simplify-expression (difference e other)))
  (and (not (eqv? d 0))
       (not (undefined? d))
       (not (and (flonum? d) (< (abs d) 1e-12)))    ; rounded when it was shown
       (format "the difference from ~a leaves ~a" (shown other) (shown d))))

(define (same-by-print e other)
  (define u (simplify-expression e))
  (define v (simplify-expression other))
  (and (not (equal? (expression->datum u) (expression->datum v)))
       (not (undefined? v))
       (not (undefined? u))
       (not (algebraic-below? u))
       (not (algebraic-below? v))
       (format "~a, but ~a gives ~a" (shown u) (shown other) (shown v))))

;; Is something divided by a sum with roots, or by sines?  Short denominators are
;; freed of them, long ones may be written in several ways.
(define (algebraic-below? e)
  (node-fold* e
              (lambda (n) (and (eq? (node-head n) op:/) (entangled? (cadr (node-args n)))))))

(define (entangled? e)
  (or (node-fold* e (lambda (n) (memq (node-head n) (list op:sin op:cos op:sinh op:cosh op:abs))))
      (node-fold* e (lambda (n) (and (memq (node-head n) (list op:+ op:-))
                                     (node-fold* n root?))))))

(define (root? n)
  (or (eq? (node-head n) op:sqrt)
      (and (eq? (node-head n) op:expt) (not (exact-integer? (cadr (node-args n)))))))

;; Does any node have the property?
(define (node-fold* e has?)
  (node-fold e (lambda (leaf) #f) (lambda (n parts) (and (or (has? n) (ormap values parts)) #t))))

;; Laws of logarithms are not known to fingerprints, which then do not claim to
;; be sure.
(define (same-by-fingerprint e other)
  (define v (fingerprint (difference e other)))
  (and (not (memq v '(zero unknown nonzero?)))
       (format "the difference from ~a has the fingerprint ~a" (shown other) v)))

(define (same-by-verdict e other)
  (define d (difference e other))
  (define v (zero-test-status (zero-test d)))
  (and (not (memq v (if (contains-flonum? d) '(undecided proved) '(proved))))
       (not (undefined? (simplify-expression d)))
       (format "that ~a is the same is ~a" (shown other) v)))

;; ---------------------------------------------------------------------------
;; Two expressions whose values differ somewhere

(define (told-apart e other)
  (define point
    (for/first ([p (in-list points)]
                #:when (let ([u (value-at-point e p)] [v (value-at-point other p)])
                         (and u v (differ? u v))))
      p))
  (and point (claimed-equal (difference e other) point)))

(define (claimed-equal d point)
  (define-values (s assumptions) (simplify-expression/assumptions d))
  (define assumed? (andmap (lambda (a) (holds? a point)) assumptions))
  (cond [(and (eqv? s 0) assumed?) (format "~a is simplified to 0" (shown d))]
        [(and (odd? point) assumed? (eq? 'zero (fingerprint d)))   ; for positive symbols
         (format "~a has the fingerprint zero" (shown d))]
        [else (wrong-verdict d)]))

(define (wrong-verdict d)
  (define z (zero-test d))
  (case (zero-test-status z)
    [(proved) (and (null? (zero-test-assumptions z)) (format "~a is proved to be 0" (shown d)))]
    [(refuted) (and (not (witness-holds? d z))
                    (format "~a is ~a at ~a, it is said" (shown d) (zero-test-value z)
                            (zero-test-witness z)))]
    [else #f]))

;; Is the value at the witness what it is said to be, as far as flonums tell, in which what
;; is small is a difference of numbers about 1?  Where it is not real, or not defined, nothing
;; is known.
(define (witness-holds? d z)
  (define lookup (point-lookup (zero-test-witness z) (lambda (leaf arguments) 2/7)))
  (define v
    (and (real? (zero-test-value z))
         (with-handlers ([exn:fail? (lambda (x) #f)])
           (evaluate-expression d lookup))))
  (or (not v)
      (not (real? v))
      (< (abs (- v (zero-test-value z)))
         (+ 1e-12 (* 1e-9 (abs v))))))
