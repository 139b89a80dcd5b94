#lang racket/base
;; Sums of terms as they are best read.
;;
;; Squares of sums are squares.  The rest is written expanded; or with the terms
;; that agree in all kernels but symbols collected; or grouped by common factors; or
;; with its content in front, or in one fraction.  The first form named is kept
;; unless another is smaller by a sixth.

(require racket/list
         "form.rkt" "grouping.rkt" "radicals.rkt" "squares-of-sums.rkt" "term.rkt"
         "../expression/expression.rkt" "../expression/operation.rkt" "../expression/order.rkt"
         "../field/field.rkt"
         "../kernel/kernel.rkt")

(provide sum-of sum->term)

;; -> the form of the sum
(define (sum-of F terms)
  (if (null? terms)
      (sum-form '())
      (terms-form F (turn-sine F (condense F terms)))))

;; -> one term equal to the sum
(define (sum->term F terms) (one-term F (condense F terms)))

;; One term equal to the sum: the only term there is, or a kernel that is the sum.
(define (one-term F terms)
  (if (null? (cdr terms))
      (car terms)
      (term 1 (list (cons (sum-kernel F terms) 1)))))

(define (sum-kernel F terms)
  (field-whole-kernel F ((form-build (terms-form F terms)) 1)))

;; The terms in the form they are shown in: as they are, or fewer; not none.
(define (condense F terms)
  (define merged (with-squares F terms))
  (define squares (if (null? merged) terms merged))
  (define grouped (if (null? (cdr squares)) squares (prefer-grouped F squares)))
  (if (null? (cdr grouped)) grouped (prefer-factored F grouped)))

(define (with-squares F terms)
  (merge-squares (if (null? (cdr terms)) terms (term-sort terms))
                 (lambda (terms) (unsigned-kernel F terms))))

;; The kernel of a sum or of its opposite, whichever begins with a plus.
(define (unsigned-kernel F terms)
  (define sorted (term-sort terms))
  (sum-kernel F (if (negative? (term-coefficient (car sorted)))
                    (scale-terms -1 sorted)
                    sorted)))

;; The first of the lists unless a later one is enough smaller.
(define (prefer F usual . others)
  (for/fold ([best usual]) ([other (in-list others)])
    (if (or (eq? best other)
            (not (smaller-form? (terms-form F best) (terms-form F other))))
        best
        other)))

(define (prefer-grouped F terms)
  (define (->term terms) (one-term F (with-squares F terms)))
  (define (collected terms)
    (group-by-kernels terms ->term (lambda (usual product core) (smaller? F usual product))))
  (define (->term/collected terms) (one-term F (collected terms)))
  (define (shorter? usual product)
    (< (terms-size F (list product)) (terms-size F usual)))
  (define (welcome? usual product core)
    (if (symbols-times-sum? product) (shorter? usual product) (smaller? F usual product)))
  (define (welcome-in-residual? usual product core)
    (if (>= (term-derivative product) 2)
        (shorter? usual product)
        (and (or (>= (term-derivative product) 1)
                 (ormap divided? usual)
                 (andmap without-circles? core))
             (smaller? F usual product))))
  (if (residual? terms)
      (group-by-factors (collected terms) residual-weight ->term/collected welcome-in-residual?)
      (group-by-factors (collected terms) heavy-size ->term/collected welcome?)))

(define (terms-size F terms) (form-size (terms-form F terms)))

(define (smaller? F usual product)
  (smaller-form? (terms-form F usual) (terms-form F (list product))))

;; ½ m (ẋ² + ẏ²) is how it is known, however little shorter.
(define (symbols-times-sum? t)
  (define others
    (filter-not (lambda (p) (symbol? (kernel-expression (car p)))) (term-powers t)))
  (and (not (divided? t)) (= 1 (length others)) (sum-kernel? (caar others))))

(define (divided? t) (ormap negative? (map cdr (term-powers t))))

;; Fractions within a fraction are no improvement, except over sums and roots.
(define (heavy-size k e) (if (heavy-power? k e) (power-size k e) 0))
(define (heavy-power? k e) (or (positive? e) (not (symbol? (kernel-expression k)))))

;; Equations of motion stay sums over the highest derivatives, their coefficients
;; collected.  Besides they may share divisors, or sines times a sum
;; without any: m l (g + ÿ) sin θ.
(define (residual? terms)
  (for/or ([t (in-list terms)]) (>= (term-derivative t) 2)))

;; The order of the highest derivative among the factors.
(define (term-derivative t)
  (apply max 0 (for/list ([p (in-list (term-powers t))])
                 (derivative-order (kernel-expression (car p))))))

(define (residual-weight k e)
  (if (or (circular-kernel? k)
          (negative? e)
          (>= (derivative-order (kernel-expression k)) 2))
      (heavy-size k e)
      0))

(define (without-circles? t) (not (ormap circular-kernel? (map car (term-powers t)))))

;; With the shared content in front, or all over one denominator, if that is
;; enough smaller; shared exponentials always.
(define (prefer-factored F terms)
  (define-values (c shared core) (extract-content terms #t))

  (define exponentials (filter exponential-power? shared))
  (define powers
    (if (ormap divided? core) (filter (lambda (p) (heavy-power? (car p) (cdr p))) shared) shared))
  (prefer F
          (if (null? exponentials) terms (with-factor F terms (if (negative? c) -1 1) exponentials))
          (with-factor F terms c powers)
          (if (ormap divided? terms) (in-one-fraction F terms) terms)))

(define (with-factor F terms c powers)
  (list (times-sum F c powers
                   (multiply-terms (scale-terms (/ 1 c) terms) (invert-powers powers)))))

(define (in-one-fraction F terms)
  (define-values (c powers core) (extract-content terms))
  (list (times-sum F c powers core)))

(define (times-sum F c powers terms)
  (make-term c (cons (cons (sum-kernel F terms) 1) powers)))

;; ---------------------------------------------------------------------------
;; Forms

(define (terms-form F terms)
  (define shown
    (if (field-inexact? F)
        terms
        (for/list ([t (in-list terms)])
          (gather-under-roots t
                              (lambda (e) (field-whole-kernel F e))
                              (lambda (e) (field-not-negative? F e))))))
  (sum-form (for/list ([t (in-list (in-order shown))])
              (term-form t (field-inexact? F)))))

;; A positive constant comes first, divided sums last.
(define (in-order terms)
  (define (divided-by-sum? t)
    (for/or ([p (in-list (term-powers t))]) (and (negative? (cdr p)) (sum-kernel? (car p)))))
  (define-values (last-ones others) (partition divided-by-sum? (constant-first terms)))
  (append others last-ones))

;; ---------------------------------------------------------------------------
;; Signs

;; A lone term - sin(φ - θ) is sin(θ - φ).
(define (turn-sine F terms)
  (define t (car terms))
  (define (turnable? p)
    (define o (kernel-relation (car p)))
    (and (odd? (cdr p)) (circle? o) (eq? (car p) (circle-sine o))
         (node? (circle-expression o)) (eq? (node-head (circle-expression o)) op:-)))
  (define p
    (and (null? (cdr terms))
         (negative? (term-coefficient t))
         (findf turnable? (term-powers t))))
  (if p
      (list (make-term (- (term-coefficient t))
                       (cons (cons (opposite-sine F (car p)) (cdr p)) (remq p (term-powers t)))))
      terms))

(define (opposite-sine F k)
  (define sine (kernel-expression k))
  (define difference (make-node op:- (reverse (node-args (car (node-args sine))))))
  (field-whole-kernel F (make-node (node-head sine) (list difference))))
