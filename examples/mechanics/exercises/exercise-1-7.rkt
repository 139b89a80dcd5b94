#lang mechanics
;; Exercise 1.7 (SICM 1.5.1): rules for variations
;; Checked: the rules for sums, multiples, products and compositions, and for D
;; How: both sides compared for arbitrary functions of the path

;; Which rules does the variation of a function of paths obey?  Below, f and g are functions
;; of paths of which nothing is known, and h is a function of their values.

(define (function-of-paths name)
  (define F (literal-function name (-> (UP Real Real Real) Real)))
  (lambda (q) (compose F (Gamma q))))

(define f (function-of-paths 'F))
(define g (function-of-paths 'G))
(define h (literal-function 'h))
(define q (literal-function 'q))
(define vary (delta (literal-function 'eta)))

(define (same left right)
  (verify-equal ((left q) 't) ((right q) 't)))

(define rules
  (list
   (same (vary (+ f g)) (+ (vary f) (vary g)))
   (same (vary (* 'c f)) (* 'c (vary f)))
   (same (vary (* f g)) (+ (* (vary f) g) (* f (vary g))))
   (same (vary (lambda (q) (compose h (f q))))
         (lambda (q) (* (compose (D h) (f q)) ((vary f) q))))
   (same (vary (lambda (q) (D (f q)))) (lambda (q) (D ((vary f) q))))))
(map verdict-status rules)

;; A composition differentiated as if the outer function were linear: what is left over has
;; the factor h(f) − h′(f) in it.
(define slip
  (same (vary (lambda (q) (compose h (f q))))
        (lambda (q) (* (compose h (f q)) ((vary f) q)))))
(verdict-status slip)
(define left-over
  (- ((compose (D h) (f q)) 't) ((compose h (f q)) 't)))
(verify-equal (verdict-residual slip) (* left-over (((vary f) q) 't)))

(module+ test
  (require rackunit)
  (test-case "the rules of the derivative hold"
    (for ([rule rules]) (check-pred proved? rule)))
  (test-case "the chain rule needs the outer function's derivative"
    (check-pred refuted? slip)
    (check-pred proved? (verify-equal (verdict-residual slip)
                                      (* left-over (((vary f) q) 't))))))
