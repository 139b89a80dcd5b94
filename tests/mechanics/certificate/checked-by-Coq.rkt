#lang racket/base
;; A few certificates of each kind are accepted by Coq, where it is installed, and false
;; neighbours of them rejected; `make certify` tries many.

(require racket/list
         (only-in mechanics - + * / assuming cos cosh sinh sqrt square up
                  verify-conserved verify-equal verify-solution Lagrangian->energy)
         mechanics/book
         mechanics/certificate/certificate mechanics/certificate/Coq-check
         "../support/checks.rkt" "../support/skip.rkt"
         "../support/certification/false-neighbours.rkt"
         "../support/certification/proved-claims.rkt")

(define coqc (find-Coq))
(define without-Coq "Coq is not there (Debian: coq, libcoq-coquelicot)")

(define (accepted? text) (judgement-accepted? (check-by-Coq coqc text)))

(define few
  '(rationalized root-of-quotient symbolic-power oscillator oscillator-from-a-time
    oscillating-circuit central-energy turned-phase-space circle-on-a-string))

(test-case "certificates are accepted: sines, roots, powers, a motion, a conserved quantity"
  (skip-unless coqc without-Coq
    (for ([c (in-list (proved-claims few))])
      (check-true (accepted? (certificate-text (certificate-or-reason (asked-verdict c))))
                  (format "~a" (asked-name c))))))

(test-case "unknown functions of several variables, gauges, and transformed motions are accepted"
  (skip-unless coqc without-Coq
    (define claims (proved-claims '(momentum-beside-a-wall gauge-of-unknown moving-frame)))
    (for ([c (in-list claims)])
      (define x (certificate-or-reason (asked-verdict c)))
      (check-equal? (certificate-level x) 2 (format "~a" (asked-name c)))
      (check-true (accepted? (certificate-text x)) (format "~a" (asked-name c))))
    (for ([n (in-list (neighbours-by-definitions (list (car claims)) 1))])
      (check-false (accepted? (neighbour-text n)) (neighbour-name n)))))

(test-case "hyperbolic functions may be divisors, also of half an angle"
  (skip-unless coqc without-Coq
    (for ([u (in-list (list (sinh 'x) (cosh (/ 'x 2))))])
      (define v (verify-equal (* 2 (+ 'y (/ 1 u))) (+ (* 2 (/ 1 u)) (* 2 'y))))
      (check-true (accepted? (certificate-text (certificate v)))))))

(test-case "where 0 < k / m and 0 < m, there is a root of k"
  (skip-unless coqc without-Coq
    (define swing
      (assuming ('(> m 0))
        (verify-solution (L-harmonic 'm 'k)
                         (lambda (t) (* 'A (cos (+ (* (sqrt (/ 'k 'm)) t) 'phi)))))))
    (check-true (accepted? (certificate-text (certificate swing))))))

(test-case "symbols may be called as what the file defines, or as what Coq does"
  (skip-unless coqc without-Coq
    (for ([(m k) (in-parallel '(L ex_derive) '(path I))])
      (check-true
       (accepted?
        (certificate-text
         (certificate
          (verify-solution (L-harmonic m k) (lambda (t) (* 'q (cos (* (sqrt (/ k m)) t)))))))))
      (define L (L-harmonic m k))
      (check-true
       (accepted? (certificate-text
                   (certificate (verify-conserved L (Lagrangian->energy L) (up 't 'x 'v)))))))
    (check-true
     (accepted? (certificate-text (certificate (verify-equal (- (square 'True) (square 'claim))
                                                             (* (+ 'True 'claim)
                                                                (- 'True 'claim)))))))))

(test-case "changed claims, dropped hypotheses and empty domains are rejected"
  (skip-unless coqc without-Coq
    (define all
      (append (false-neighbours (proved-claims '(rationalized)) 1)
              (take (neighbours-by-hypotheses (proved-claims '(square-root))) 3)
              (neighbours-by-definitions (proved-claims '(central-energy)) 2)))
    (check-equal? (length all) 6)
    (for ([n (in-list all)]) (check-false (accepted? (neighbour-text n)) (neighbour-name n)))))

(test-case "each claim of the table is proved; false neighbours are written of most of them"
  (for ([c (in-list (proved-claims few))])
    (check-pred certificate? (certificate-or-reason (asked-verdict c)))))
