#lang racket/base
;; Perturbations of Hamiltonians with decimals in them: each order was rounded, so that no claim
;; from the second on was proved, after ten times as long as with exact numbers.

(require mechanics
         (prefix-in found: mechanics/canonical/perturbation/perturbation-results)
         (only-in mechanics/canonical/perturbation/Poisson-series series-scale)
         "../support/checks.rkt" "../support/close.rkt")

(define line (up 't 'theta 'p))
(define two (up 't (up 'theta 'phi) (down 'p 'P)))

(define ((rotor alpha omega) (up t q (down p P))) (+ (/ (square p) (* 2 alpha)) (* omega P)))
(define ((drive beta gamma) (up t (up theta phi) p))
  (+ (* -1 beta (cos theta)) (* gamma (+ (cos (+ theta phi)) (cos (- theta phi))))))

(define (driven order alpha omega beta gamma)
  (perturbation-series (rotor alpha omega) (drive beta gamma) two #:order order))

(define (all-proved? P)
  (for/and ([v (in-list (perturbation-verdicts P))]) (proved? (caddr v))))

(test-case "each claim is proved, as for exact numbers"
  (check-true (all-proved? (driven 2 1.3 0.7 0.9 0.31)))
  (check-pred proved? (verify-perturbation (driven 3 1.3 0.7 0.9 0.31))))

;; Independent: the same with the numbers that are meant
(test-case "the values are those of exact numbers"
  (define (energy P) (series:sum ((perturbation-Hamiltonian P) (up 0 (up 0 0) (down 3/2 2))) 3))
  (define (old P) ((perturbation-transformation P) (up 0 (up 1/3 1/5) (down 3/2 2))))
  (define (at x) (substitute x 'epsilon 1/10))
  (define-values (decimal exact) (values (driven 3 1.3 0.7 0.9 0.31)
                                         (driven 3 13/10 7/10 9/10 31/100)))
  (check-close (expression (at (energy decimal))) (expression (at (energy exact))) 1e-13)
  (check-close (at (old decimal)) (at (old exact)) 1e-12))

(test-case "phases, multiples and powers that are decimals"
  (define (free s) (* 0.7 (square (momentum s))))
  (define (with H1) (perturbation-series free H1 line #:order 2))
  (for ([H1 (list (lambda (s) (* -0.3 (cos (+ (coordinate s) 0.3))))
                  (lambda (s) (* 2.0 (cos (* 2.0 (coordinate s)))))
                  (lambda (s) (* 1.5 (cos (* 0.5 (+ (coordinate s) (coordinate s))))))
                  (lambda (s) (* (sqrt (* 1.4 (momentum s))) (cos (coordinate s))))
                  (lambda (s) (* 0.7 (expt (momentum s) 0.5) (cos (coordinate s))))
                  (lambda (s) (expt (cos (coordinate s)) 3.0)))])
    (check-true (all-proved? (with H1)))))

;; Nothing is proved that is wrong.
(test-case "a wrong generator is found out among decimals, too"
  (define P (perturbation-series (lambda (s) (* 0.7 (square (momentum s))))
                                 (lambda (s) (* -0.3 (cos (coordinate s)))) line #:order 2))
  (define wrong
    (found:perturbation line (found:perturbation-given P) 'epsilon (found:perturbation-terms P)
                        (cons (series-scale -1 (car (found:perturbation-Ws P)))
                              (cdr (found:perturbation-Ws P)))
                        (found:perturbation-removals P) (found:perturbation-decimals P)))
  (check-pred refuted? (verify-perturbation wrong)))

(test-case "powers of waves that are whole numbers in decimals, alone among exact ones"
  (define (P exponent)
    (perturbation-series (lambda (s) (square (momentum s)))
                         (lambda (s) (expt (cos (coordinate s)) exponent)) line #:order 2))
  (check-equal? (format "~a" (P 3.0)) (format "~a" (P 3))))

(test-case "what it prints"
  (check-equal? (format "~a" (perturbation-series (lambda (s) (* 0.5 (square (momentum s))))
                                                  (lambda (s) (* -0.3 (cos (coordinate s))))
                                                  line #:order 2))
                (string-append "perturbation to order 2 in epsilon\n"
                               "  order 0: (* 0.5 (expt p 2))\n"
                               "  order 1: 0\n"
                               "  order 2: (/ 0.0225 (expt p 2))\n"
                               "  divided by: p, of the wave (1)\n"
                               "  divided by: (* 2 p), of the wave (2)")))
