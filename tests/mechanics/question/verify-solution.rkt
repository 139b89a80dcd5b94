#lang racket/base
;; Verdicts on proposed paths.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/value/structure
         mechanics/calculus/literal-function
         mechanics/verdict/verdict
         mechanics/question/verify-solution
         mechanics/lagrangian/local-tuple
         (only-in mechanics/book L-free-particle L-harmonic)
         "../support/checks.rkt" "../support/systems.rkt")

(define (oscillation omega) (lambda (t) (g:* 'a (g:cos (g:+ (g:* omega t) 'phi)))))

;; A condition (= left right) as plain data.
(define (expression-of condition)
  (read (open-input-string (format "~s" condition))))

(test-case "the oscillator: refuted in general, proved for the right frequency"
  (define L (L-harmonic 'm 'k))
  (define v (verify-solution L (oscillation 'omega)))
  (check-true (refuted? v))
  (check-not-false (member '(= k (* m (expt omega 2))) (map expression-of (verdict-conditions v))))
  (check-true (proved? (verify-solution L (oscillation (g:sqrt (g:/ 'k 'm))))))
  (check-true (proved? (verify-solution (L-harmonic 'm (g:* 'm (g:square 'omega)))
                                        (oscillation 'omega)))))

(test-case "a circular orbit"
  (define (circle t) (up (g:* 'R (g:cos (g:* 'omega t))) (g:* 'R (g:sin (g:* 'omega t)))))
  (check-true (proved? (verify-solution (L-orbital 'm (g:* 'm (g:square 'omega) (g:cube 'R)))
                                        circle)))
  (check-true (refuted? (verify-solution (L-orbital 'm 'mu) circle))))

(test-case "with a force: the damped oscillator, exactly when γ and ω satisfy the two relations"
  (define (damped gamma omega) (lambda (t) (g:* (g:exp (g:* -1 gamma t)) (g:cos (g:* omega t)))))
  (define (friction local) (g:* -1 'b (velocity local)))
  (define (verdict gamma omega)
    (verify-solution (L-harmonic 'm 'k) (damped gamma omega) #:force friction))
  (define general (verdict 'gamma 'omega))
  (check-true (refuted? general))
  (check-equal? (map expression-of (verdict-conditions general))
                '((= b (* 2 gamma m))
                  (= k (+ (* b gamma) (* -1 (expt gamma 2) m) (* m (expt omega 2))))))
  (define gamma (g:/ 'b (g:* 2 'm)))
  (check-true (proved? (verdict gamma (g:sqrt (g:- (g:/ 'k 'm) (g:square gamma)))))))

(test-case "decimals: proved if it holds for any number, refuted if it is wrong"
  (define ((L-falling g) local)
    (g:- (g:* 1/2 'm (g:square (velocity local))) (g:* 'm g (coordinate local))))
  (define (fall half-g) (lambda (t) (g:- 'h (g:* half-g (g:square t)))))
  (check-true (proved? (verify-solution (L-falling 9.8) (fall 4.9))))
  (define v (verify-solution (L-falling 9.81) (fall 4.9)))
  (check-regexp-match #rx"residual: \\(\\* 0[.]01 m\\)\n" (format "~a" v)))

(test-case "with an order"
  (define (L local)
    (g:- (g:* -1/2 'm (coordinate local) (acceleration local))
         (g:* 1/2 'k (g:square (coordinate local)))))
  (check-true (proved? (verify-solution L #:order 2 (oscillation (g:sqrt (g:/ 'k 'm)))))))

(test-case "what is no path or no Lagrangian is refused"
  (check-exn #rx"[(]literal-function 'x[)] makes a path of that name"
             (lambda () (verify-solution (L-free-particle 'm) 'x)))
  (check-exn #rx"^verify-solution: a Lagrangian is a function"
             (lambda () (verify-solution 3 (literal-function 'x)))))
