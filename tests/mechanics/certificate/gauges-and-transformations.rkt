#lang racket/base
;; Certificates of gauges, equivalent Lagrangians and transformations, as they are written.

(require mechanics
         (only-in mechanics/certificate/certificate certificate-gap)
         "../support/checks.rkt" "../support/certification/certificate-parts.rkt")

(test-case "a total time derivative: the function whose rate it is along every path"
  (define local (up 't 'x 'v))
  (check-regexp-match
   (regexp-quote
    (string-append "Definition gauge (t x : R) : R := a * x ^ 2. "
                   "Theorem claim : forall (path velocity : R -> R) (t : R), "
                   "hypotheses a (path t) (velocity t) t -> "
                   "is_derive path t (velocity t) -> "
                   "is_derive (fun s => gauge s (path s)) t (F t (path t) (velocity t))."))
   (statement (verify-total-time-derivative (lambda (s) (* 2 'a (coordinate s) (velocity s)))
                                            local)))
  (check-equal? (format "~a" (certificate (verify-total-time-derivative velocity local)))
                (string-append "a theorem for Coq to check: the function is a total time "
                               "derivative; by Coq's own derivatives"))
  (define (L1 s) (* 1/2 'm (square (velocity s))))
  (define ((L2 k) s) (+ (* k (L1 s)) (* 'b (velocity s))))
  (define (rate k) (statement (verify-equivalent-Lagrangians L1 (L2 k) local)))
  (check-regexp-match
   (regexp-quote "t (L_2 t (path t) (velocity t) - L_1 t (path t) (velocity t)).") (rate 1))
  (check-regexp-match
   (regexp-quote "t (L_2 t (path t) (velocity t) - 2 * k * L_1 t (path t) (velocity t)).")
   (rate (* 2 'k)))
  (define (Fresnel s) (* (velocity s) (sin (square (coordinate s)))))
  (define unknown (verify-total-time-derivative Fresnel local))
  (check-equal? (certificate-gap (certificate unknown))
                "no formula was found of which it is the rate"))

(test-case "Lagrangians that differ by a factor as well: it is named, and not 0 once"
  (define ((L m) s) (* 1/2 m (square (velocity s))))
  (define (words a b)
    (format "~a" (certificate (verify-equivalent-Lagrangians (L a) (L b) (up 't 'x 'v)))))
  (check-regexp-match #rx": the second Lagrangian and the first, multiplied by 3, differ by a total"
                      (words 1 3))
  (check-regexp-match
   (regexp-quote "multiplied by (/ a m), differ by a total time derivative under a <> 0, m <> 0;")
   (words 'm 'a))
  (check-regexp-match #rx": the Lagrangians differ by a total time derivative" (words 'm 'm)))

(test-case "the domain of what was found for the proof is told from that of the claim"
  (define (hyperbola s) (/ (velocity s) (coordinate s)))
  (define v (verify-total-time-derivative hyperbola (up 't 'x 'v)))
  (check-regexp-match
   (regexp-quote
    (string-append "(* domain: each part of the claim has a value *) x <> 0 /\\ "
                   "(* no part of the claim: what was found for the proof has a value *) 0 < x."))
   (statement v))
  (check-regexp-match
   (regexp-quote "under x <> 0, where what was found for the proof has a value, 0 < x;")
   (format "~a" (certificate v)))
  (define (L s) (* 1/2 'm (square (velocity s))))
  (check-regexp-match
   (regexp-quote "under x <> 0, where what was found")
   (format "~a" (certificate (verify-equivalent-Lagrangians L (+ L hyperbola) (up 't 'x 'v)))))
  (check-false
   (regexp-match? #rx"found"
                  (statement (verify-total-time-derivative
                              (lambda (s) (* (velocity s) (coordinate s)))
                              (up 't 'x 'v))))))

(test-case "a transformation with two Hamiltonians takes motions to motions"
  (define (moving s) (up (time s) (+ (coordinate s) (* 'u (time s))) (momentum s)))
  (define (H s) (/ (square (momentum s)) (* 2 'm)))
  (define (new-H s) (- (H (moving s)) (* 'u (momentum s))))
  (define v (verify-canonical moving H new-H (up 't 'q 'p)))
  (check-regexp-match #rx"takes motions of the new Hamiltonian to those of the old"
                      (format "~a" (certificate v)))
  (define text (statement v))
  (check-regexp-match #rx"Definition old_H \\(T Q P : R\\) : R := P [*] P / \\(2 [*] m\\)[.]" text)
  (check-regexp-match
   (regexp-quote
    (string-append
     "is_derive (fun s => old_time s (coordinate s) (momentum s)) t 1 /\\ "
     "is_derive (fun s => old_coordinate s (coordinate s) (momentum s)) t "
     "(old_rate t (coordinate t) (momentum t)) /\\ "
     "is_derive (fun s => old_momentum s (coordinate s) (momentum s)) t "
     "(- old_slope t (coordinate t) (momentum t)))."))
   text))

(test-case "a transformation that shifts the time: its old time goes as the new one"
  (check-regexp-match
   (regexp-quote "is_derive (fun s => time s q p) t (1) /\\ is_derive (fun s => time t s p) q (0)")
   (statement (verify-canonical (lambda (s) (up (+ (time s) 'dt) (coordinate s) (momentum s)))
                                (up 't 'q 'p)))))

(test-case "a question about brackets alone has no time in its theorem"
  (check-false
   (regexp-match? #rx"time"
                  (statement (verify-symplectic
                              (lambda (s) (up (* 2 (time s)) (coordinate s) (momentum s)))
                              (up 't 'q 'p))))))
