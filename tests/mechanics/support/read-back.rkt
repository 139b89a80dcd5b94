#lang racket/base
;; Random formulas, of names that are easily mistaken, and their values at seeded points: to see
;; that what was written of them is read back.

(require mechanics/algebra/expression/expression
         mechanics/algebra/expression/operation
         mechanics/algebra/expression/substitute
         racket/list
         "evaluate.rkt"
         (only-in "property/expressions.rkt" random-expression choose))

(provide random-formula value-of close?)

(define (random-formula [depth (choose 1 2 3 4)]) (renamed (random-expression depth kinds)))

(define kinds
  '(rational trigonometric hyperbolic exponential power logarithm radical root nested inverse
    modulus literal flonum))

;; Names that look like each other, like operations and like nothing a formula has.
(define names
  '(theta theta_1 thetadot p_phi v^x_r xdotdot omega0 omega_0 D Dx sin e i pi :pi mass L-free
    θ φ_1 ẋ x₁ 𝐢 |a b| |x+y| bar\| |</mi>| x^2 x_ab GM))

;; An expression that divides by 0 when it is made again is left as it is.
(define (renamed e)
  (with-handlers ([exn:fail? (lambda (x) e)]) (with-other-names e)))

(define (with-other-names e)
  (substitute-expression e (map cons '(a b c x) (take (shuffle names) 4))))

;; ---------------------------------------------------------------------------
;; Values

;; A value for each symbol, and one that is smooth in the arguments for each function.
(define ((value-at seed) leaf arguments)
  (define key (if (symbol? leaf) leaf (head->datum (node-head leaf))))
  (define phase (/ (modulo (equal-hash-code (format "~s" (list seed key))) 1000) 1000.0))
  (for/fold ([v (make-rectangular (+ 0.4 phase) (- 0.7 (* 0.6 phase)))])
            ([x (in-list (flatten arguments))] #:when (number? x))
    (+ v (* 0.37 x))))

(define-syntax-rule (value-of expression seed)
  (value-from (lambda () expression) seed))

;; #f where there is none
(define (value-from make seed)
  (with-handlers ([exn:fail? (lambda (x) #f)])
    (define e (make))
    (define v (evaluate-expression e (value-at seed)))
    (and (number? v) (< (magnitude v) 1e8) v)))

(define (close? v w) (<= (magnitude (- v w)) (* 1e-6 (+ 1 (magnitude v)))))
