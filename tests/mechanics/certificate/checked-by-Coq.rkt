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
         "../support/certification/kept-judgements.rkt"
         "../support/certification/proved-claims.rkt")

(define coqc (find-Coq))
(define without-Coq "Coq is not there (Debian: coq, libcoq-coquelicot)")

(define (accepted? text) (judgement-accepted? (check-by-Coq coqc text)))

(define few
  '(rationalized symbolic-power central-energy unit-mass-in-a-plane turned-phase-space
    circle-on-a-string))

(test-case "certificates are accepted: sines, roots, powers, a motion, a conserved quantity"
  (skip-unless coqc without-Coq
    (for ([c (in-list (proved-claims few))])
      (check-true (accepted? (certificate-text (certificate-or-reason (asked-verdict c))))
                  (format "~a" (asked-name c))))))

(test-case "unknown functions of several variables, gauges, and transformed motions are accepted"
  (skip-unless coqc without-Coq
    (for ([c (in-list (proved-claims '(gauge-of-unknown moving-frame)))])
      (define x (certificate-or-reason (asked-verdict c)))
      (check-equal? (certificate-level x) 2 (format "~a" (asked-name c)))
      (check-true (accepted? (certificate-text x)) (format "~a" (asked-name c))))))

(test-case "hyperbolic functions may be divisors, also of half an angle"
  (skip-unless coqc without-Coq
    (define u (+ (/ 1 (sinh 'x)) (/ 1 (cosh (/ 'x 2)))))
    (define v (verify-equal (* 2 (+ 'y u)) (+ (* 2 u) (* 2 'y))))
    (check-true (accepted? (certificate-text (certificate v))))))

(test-case "where 0 < k / m and 0 < m, there is a root of k"
  (skip-unless coqc without-Coq
    (define swing
      (assuming ('(> m 0))
        (verify-solution (L-harmonic 'm 'k)
                         (lambda (t) (* 'A (cos (+ (* (sqrt (/ 'k 'm)) t) 'phi)))))))
    (check-true (accepted? (certificate-text (certificate swing))))))

(test-case "symbols may be called as what the file defines, or as what Coq does"
  (skip-unless coqc without-Coq
    (define path
      (verify-solution (L-harmonic 'ex_derive 'path)
                       (lambda (t) (* 'claim (cos (* (sqrt (/ 'path 'ex_derive)) t))))))
    (define energy
      (let ([L (L-harmonic 'I 'motion)])
        (verify-conserved L (Lagrangian->energy L) (up 't 'L 'True))))
    (for ([v (in-list (list path energy))])
      (check-true (accepted? (certificate-text (certificate v)))))))

(test-case "changed claims, dropped hypotheses and empty domains are rejected"
  (skip-unless coqc without-Coq
    (define all
      (append (false-neighbours (proved-claims '(rationalized)) 1)
              (take (neighbours-by-hypotheses (proved-claims '(square-root))) 2)
              (neighbours-by-definitions (proved-claims '(central-energy)) 1)))
    (check-equal? (length all) 4)
    (for ([n (in-list all)]) (check-false (accepted? (neighbour-text n)) (neighbour-name n)))))

(test-case "each claim of the table is proved; false neighbours are written of most of them"
  (for ([c (in-list (proved-claims few))])
    (check-pred certificate? (certificate-or-reason (asked-verdict c)))))

(test-case "a file without an error is accepted only if Coq names axioms of real numbers, or none"
  (define reals "Axioms:\nClassicalDedekindReals.sig_not_dec : forall P : Prop, ...\n")
  (check-false (fault-in reals))
  (check-false (fault-in "Closed under the global context\n"))
  (check-equal? (fault-in (string-append reals "falsity : False\n  and more\n"))
                "falsity : False")
  (check-equal? (fault-in "claim is defined\n")
                "it does not say on which axioms it rests\nclaim is defined\n")
  (check-true (string? (fault-in ""))))

(test-case "judgements are used again, except where only the clock ran out"
  (check-true (lasting? (judgement 'rejected 0.5 "Unable to unify")))
  (check-true (lasting? (judgement 'unfinished (+ longest 1.) "it takes more than 120 seconds")))
  (check-false (lasting? (judgement 'unfinished 0.5 "it takes more than 120 seconds"))))

(test-case "a neighbour that Coq cannot read is told from one whose proof fails"
  (check-true (rejected-by-proof? (judgement 'rejected 0.5 "Error: Tactic failure.")))
  (check-false (rejected-by-proof? (judgement 'rejected 0.5 "Syntax error: [term] expected."))))
