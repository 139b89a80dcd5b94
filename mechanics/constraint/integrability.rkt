#lang racket/base
;; Is a constraint on the velocities one on the coordinates in disguise?
;;
;; a(t, q) v + b(t, q) = 0 says that the form ω = b dt + a dq vanishes along the motion.
;; Forms ω₁ ... ω_m are integrable, the motions they allow filling surfaces, if, and only if,
;;
;;     dω_k(X, Y) = Σ (∂_i ω_kj − ∂_j ω_ki) X_i Y_j = 0
;;
;; for all X and Y that all of them take to zero (Frobenius).  Of a single form there is then
;; an integrating factor μ with μ ω = dG.  Tried are 1, 1/ω_i, and those that depend on one
;; coordinate x: of these, (log μ)' = (∂_i ω_x − ∂_x ω_i)/ω_i has to be a function of x.

(require (only-in racket/vector vector-append vector-drop)
         "constraint.rkt" "constraint-jacobian.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/operation.rkt"
         "../algebra/simplify/simplify-expression.rkt"
         "../calculus/antiderivative.rkt" "../calculus/expression-function.rkt"
         "../error/failure.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/printed-function.rkt"
         "../generic/sums-and-products.rkt" "../generic/up-down.rkt" "../generic/wrong-argument.rkt"
         "../lagrangian/generic-state.rkt"
         "../value/assumptions.rkt" "../value/shape.rkt"
         (only-in "../value/structure.rkt" list->down list->up zero-like)
         "../value/matrix/row-systems.rkt"
         "../verdict/prove-zero.rkt" "../verdict/surveyed-zero.rkt" "../verdict/verdict.rkt")

(provide Frobenius-test constraint-integral check-generic)

;; q : coordinates that are symbols.  Proved: the constraints together are integrable.
(define (Frobenius-test constraints q)
  (define who 'Frobenius-test)
  (define cs (gather who constraints))
  (check-coordinates who cs q)
  (define variables (cons 't (scalars q)))
  (Frobenius-verdict who variables (lambda () (forms who cs q))))

;; forms : a procedure, as it may differentiate
(define (Frobenius-verdict who variables forms)
  (prove-residual-zero (lambda () (Frobenius-residual who variables (forms))) variables))

;; Time is left out if no form depends on it.
(define (Frobenius-residual who variables forms)
  (define (timeless? w)
    (and (eqv? 0 (simple (vector-ref w 0)))
         (for/and ([a (in-vector w)]) (eqv? 0 (simple (expression-derivative a 't))))))
  (if (andmap timeless? forms)
      (residual-of who (cdr variables)
                   (for/list ([w (in-list forms)]) (vector-drop w 1)))
      (residual-of who variables forms)))

;; The local tuple stands for any state, and none of its symbols is a parameter of the
;; constraints as well.
(define (check-generic who cs local)
  (check-generic-state who local)
  (check-parameters who
                    (unary-function (lambda () (value->datum cs)) (local)
                      (constraint-values who cs local))
                    local))

(define (check-coordinates who cs q)
  (unless (and (andmap symbol? (scalars q)) (not (memq 't (scalars q))))
    (complain-of-argument who "coordinates that are symbols other than t, such as (up 'x 'y)" q))
  (check-generic who cs (up 't q (symbols-like q "v"))))

;; A vector (b a₁ a₂ ...) for each scalar of the constraints.
(define (forms who cs q)
  (check-linear who cs q)
  (define at-rest (up 't q (zero-like q)))
  (define-values (positions rates) (positions-and-velocities who cs at-rest))
  (for/list ([b (in-list rates)] [a (in-list (jacobian-rows who cs at-rest))])
    (vector-append (vector b) a)))

(define (residual-of who variables forms)
  (define allowed (rows-null-space who forms (list->vector forms)))
  (define found
    (for*/list ([w (in-list forms)]
                [slopes (in-value (derivative-of-form w variables))]
                [(X k) (in-indexed allowed)]
                [(Y l) (in-indexed allowed)]
                #:when (< k l))
      (on-pair slopes X Y)))
  (single-or list->down found))

;; The component dω_ij of the derivative of a form.
(struct component (i j value) #:authentic)

;; Components with i < j that are not zero.
(define (derivative-of-form w variables)
  (for*/list ([(x i) (in-indexed variables)] [(y j) (in-indexed variables)]
              #:when (< i j)
              [slope (in-value (simple (curl w x i y j)))]
              #:unless (eqv? slope 0))
    (component i j slope)))

;; ∂_i ω_j − ∂_j ω_i; x, y : the variables of these indices
(define (curl w x i y j)
  (e:- (expression-derivative (vector-ref w j) x) (expression-derivative (vector-ref w i) y)))

(define (on-pair slopes X Y)
  (g:for/sum ([c (in-list slopes)])
    (define-values (i j) (values (component-i c) (component-j c)))
    (g:* (component-value c)
         (g:- (g:* (vector-ref X i) (vector-ref Y j))
              (g:* (vector-ref X j) (vector-ref Y i))))))

(define (simple e) (simplify-expression e (assumptions-in-force)))

;; ---------------------------------------------------------------------------
;; The integral

;; G, a function of (t, q) whose rate of change is a multiple of that of the constraint; of
;; several constraints the tuple of theirs, each being integrable by itself.
(define (constraint-integral constraints q)
  (define who 'constraint-integral)
  (define cs (gather who constraints))
  (check-coordinates who cs q)
  (define variables (cons 't (scalars q)))
  (define integrals
    (for/list ([w (in-list (forms who cs q))]) (integral-of who cs w variables)))
  (define found
    (if (and (constraint-set-single? cs) (null? (cdr integrals)))
        (car integrals)
        (list->up integrals)))
  (make-function (lambda (t at) (evaluate-at found (up 't q) (up t at)))
                 4
                 (call-datum who cs)))

(define (integral-of who cs w variables)
  (define v (Frobenius-verdict who variables (lambda () (list w))))
  (unless (proved? v) (raise-not-integrable who cs v))
  (or (for/or ([factor (in-list (integrating-factors w variables))])
        (integral-of-gradient (for/list ([a (in-vector w)]) (simple (e:* factor a))) variables))
      (raise-no-answer who
                       "the constraint is integrable; its integral was not found\n  constraint: ~a"
                       (value->text cs))))

(define (raise-not-integrable who cs v)
  (raise-no-answer who
                   (string-append "the constraint ~a integrable"
                                  "\n  constraint: ~a"
                                  "\n  by Frobenius's condition this had to vanish: ~a~a")
                   (if (refuted? v) "is not" "is not known to be")
                   (value->text cs)
                   (value->text (verdict-residual v))
                   (kinks->text v)))

(define (integrating-factors w variables)
  (append (list 1)
          (for*/list ([a (in-vector w)] #:unless (eqv? a 0)) (e:/ 1 a))
          (for*/list ([(x i) (in-indexed variables)]
                      [factor (in-value (factor-in x i w variables))]
                      #:when factor)
            factor)))

;; exp ∫ h dx, where h = (∂_j ω_x − ∂_x ω_j)/ω_j depends on x alone; or #f.
(define (factor-in x i w variables)
  (define h
    (for/first ([(y j) (in-indexed variables)]
                #:unless (or (= i j) (eqv? (vector-ref w j) 0)))
      (simple (e:/ (curl w y j x i) (vector-ref w j)))))
  (define alone?
    (and h (for/and ([y (in-list variables)] #:unless (eq? x y))
             (eqv? 0 (simple (expression-derivative h y))))))
  (define exponent (and alone? (antiderivative h x (assumptions-in-force))))
  (and exponent (simple (e:apply op:exp exponent))))

;; The expression whose derivatives by the variables are the slopes, or #f.
(define (integral-of-gradient slopes variables)
  (define G (potential slopes variables (assumptions-in-force)))
  (and G
       (for/and ([x (in-list variables)] [slope (in-list slopes)])
         (proved? (verify-equal (expression-derivative G x) slope)))
       G))
