#lang racket/base
;; Square roots of numbers a + b √c that are sums of two square roots.
;;
;; If a² - b²c is the square of a rational number d, then for a > 0
;;
;;     √(a + b √c) = √((a + d)/2) ± √((a - d)/2),
;;
;; with the sign of b: √(3 - 2√2) = √2 - 1.  For other numbers there is no such form.

(require racket/list
         "../expression/expression.rkt" "../expression/operation.rkt"
         "../field/field.rkt"
         "../kernel/kernel.rkt"
         "../polynomial/fraction.rkt" "../polynomial/polynomial.rkt")

(provide (struct-out square) as-square)

;; A number is sign · root².
(struct square (sign root) #:authentic)

;; p : polynomial over F -> square, or #f
(define (as-square F p)
  (define variables (poly-variables (field-ring F) p))
  (define c (and (= 1 (length variables)) (squared-number F (car variables))))
  (define coefficients (and c (line F p (car variables))))
  (and coefficients (sum-of-roots (first coefficients) (second coefficients) c)))

;; The rational number whose square root the kernel of that index is, or #f.
(define (squared-number F i)
  (define r (relation-of F i))
  (define u (and r (eqv? 2 (relation-degree r)) (relation-radicand r)))
  (define c
    (and u (root? (kernel-relation (field-kernel F i))) (fraction-number u)))
  (and c (positive? c) c))

;; (a b) if p is a + b x with a ≠ 0
(define (line F p i)
  (define slices (poly-coefficients (field-ring F) p i))
  (and (equal? '(1 0) (map slice-degree slices))
       (reverse (for/list ([s (in-list slices)]) (poly-constant-value (slice-coefficient s))))))

(define (sum-of-roots a b c)
  (define d² (- (* a a) (* b b c)))
  (define d (and (>= d² 0) (sqrt d²)))
  (and d
       (exact? d)
       (square (if (> a 0) 1 -1)
               (e:+ (root (/ (+ (abs a) d) 2))
                    (e:* (if (> (* a b) 0) 1 -1) (root (/ (- (abs a) d) 2)))))))

(define (root x)
  (define r (sqrt x))
  (if (exact? r) r (make-node op:sqrt (list x))))
