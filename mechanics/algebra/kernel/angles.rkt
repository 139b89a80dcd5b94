#lang racket/base
;; Sines and cosines, circular and hyperbolic, of angles that may depend on each
;; other.
;;
;; Angles are gathered as linear forms over atoms, the terms they are sums of;
;; when all are known, a lattice basis gives the basic angles.  So sin(ωt + φ)
;; stays as it is unless φ or ωt occur apart, and only then is expanded.
;; Inverse functions within an angle go at once, by the addition formulas and
;;
;;     sin(asin u) = u,  cos(asin u) = √(1 - u²),  sin(atan(y, x)) = y/√(x² + y²),
;;     cosh(log u) = (u + 1/u)/2 ...
;;
;; and so do multiples of π (turns.rkt).

(require "circle.rkt" "exponentials.rkt" "integer-lattice.rkt" "kernel.rkt" "kernel-collector.rkt"
         "turns.rkt"
         "../expression/expression.rkt" "../expression/operation.rkt"
         "../expression/simplifier.rkt")

(provide visit-angle! settle-angles! doubled-circles dependent-angles?)

(define (visit-angle! c n)
  (define head (node-head n))
  (define circular? (and (memq head circular-functions) #t))
  (define terms (simplifier-linear-parts (collector-simplifier c) (car (node-args n))))
  (define inverse (and circular? (findf inverse-term? terms)))
  (cond [inverse (resolve-alias! c n (unfold head inverse terms))]
        [(and circular? (turned head terms)) => (lambda (e) (resolve-alias! c n e))]
        [(and (not circular?) (ormap logarithm-term? terms)) (hyperbolic->exponential! c n)]
        [else
         (resolve! c n
                   (circular head
                             (intern-angle! c (if circular? 'circular 'hyperbolic)
                                            (linear-form c terms))))]))

;; ---------------------------------------------------------------------------
;; Inverse functions

(define (inverse-term? t)
  (and (exact-integer? (car t))
       (<= (abs (car t)) 16)
       (node? (cdr t))
       (memq (node-head (cdr t)) (operations-where arc))
       #t))

;; The function of Σ terms with one of the inverse functions in t taken away.
(define (unfold head t terms)
  (define-values (s c) (inverse-functions (cdr t)))
  (define step (if (positive? (car t)) 1 -1))
  (define rest
    (sum-of-terms (for/list ([u (in-list terms)])
                    (if (eq? u t) (cons (- (car u) step) (cdr u)) u))))
  (define of (function-at rest))
  (define sine (e:+ (e:* step (e:* s (of op:cos))) (e:* c (of op:sin))))
  (define cosine (e:- (e:* c (of op:cos)) (e:* step (e:* s (of op:sin)))))
  (function-value head sine cosine))

;; -> the sine and the cosine of (asin u), (acos u), (atan u) or (atan y x).
(define (inverse-functions e)
  (define args (node-args e))
  (define u (car args))
  (define (root u) (make-node op:sqrt (list u)))
  (define (square u) (e:expt u 2))
  (cond [(eq? (node-head e) op:asin) (values u (root (e:- 1 (square u))))]
        [(eq? (node-head e) op:acos) (values (root (e:- 1 (square u))) u)]
        [else
         (define x (if (null? (cdr args)) 1 (cadr args)))
         (define r (root (e:+ (square x) (square u))))
         (values (e:/ u r) (e:/ x r))]))

;; ---------------------------------------------------------------------------
;; Basic angles

;; Multiples of an angle up to this are expanded.
(define multiple-limit 32)

(define (settle-angles! c kind sign)
  (define ordered (sort-forms c (angles-of c kind)))
  (define-values (basis coordinates) (modest-basis (map angle-form ordered) multiple-limit))
  (settle-multiples! c ordered basis coordinates
                     (lambda (u) (make-circle u sign (lambda (e o) (intern-kernel! c e o))))))

;; The basic angles that occurred doubled.
(define (doubled-circles c)
  (for*/list ([(key a) (in-hash (collector-angles c))]
              #:when (eq? (car key) 'circular)
              [multiples (in-value (angle-multiples a))]
              #:when (and (= 1 (length multiples)) (eqv? 2 (abs (cdar multiples)))))
    (caar multiples)))

;; Was any angle a combination of basic ones?
(define (dependent-angles? c)
  (for/or ([(key a) (in-hash (collector-angles c))])
    (and (memq (car key) '(circular hyperbolic))
         (let ([multiples (angle-multiples a)])
           (and (pair? multiples)
                (or (pair? (cdr multiples)) (not (eqv? 1 (abs (cdar multiples))))))))))
