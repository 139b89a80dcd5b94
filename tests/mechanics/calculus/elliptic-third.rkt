#lang racket/base
;; Elliptic integrals of the third kind, and moduli from 1 on, against values of 20 digits.

(require mechanics "../support/checks.rkt")

(define-check (check-close found expected)
  (unless (<= (abs (- found expected)) (* 2e-14 (max 1.0 (abs expected))))
    (with-check-info (['found found] ['expected expected]) (fail-check))))

(test-case "of the third kind"
  (check-close (elliptic-integral-Pi 1/3 1 1/2) 1.152026455582065406837)
  (check-close (elliptic-integral-Pi 1/3 4 1/2) 5.114765412479382093517)
  (check-close (elliptic-integral-Pi -5 -3/2 0.9) -0.7643060658051123671395)
  (check-close (elliptic-integral-Pi 2 1/2 3/2) 0.7010808201024941957192)
  (check-close (third-elliptic-integral -2 1/2) 0.9547988196277867025908)
  (check-close (third-elliptic-integral 0.99 0.99) 80.21811660142535717544)
  (check-close (third-elliptic-integral 0 0.3) (first-elliptic-integral 0.3))
  (check-close ((D (lambda (n) (elliptic-integral-Pi n 1 1/2))) 1/3) 0.4101186617138384473956)
  (check-close ((D (lambda (k) (third-elliptic-integral 1/4 k))) 1/2) 0.6755733280768437477586)
  (check-close ((D (lambda (phi) (elliptic-integral-Pi 1/3 phi 1/2))) 1)
               (/ 1 (* (- 1 (* 1/3 (square (sin 1.0)))) (sqrt (- 1 (* 1/4 (square (sin 1.0)))))))))

(test-case "moduli from 1 on"
  (check-close (elliptic-integral-F 1/2 2) 0.6774175382039303865809)
  (check-close (elliptic-integral-F -1/4 3) -0.282020781963521741176)
  (check-close (elliptic-integral-F 1 1) 1.226191170883517070813)
  (check-close (elliptic-integral-E 5 1) 3.041075725336861531107)
  (check-equal? (second-elliptic-integral 1) 1.0)
  ;; up to the end: F(asin 1/k, k) = K(1/k)/k
  (for ([k (in-list '(1.5 2 7))])
    (check-close (elliptic-integral-F (asin (/ 1.0 k)) k)
                 (/ (first-elliptic-integral (/ 1.0 k)) k)))
  (check-close (elliptic-integral-E (asin 1/2) 2) 0.4062988864599602466128))

(test-case "what is infinite or not real is refused"
  (define-syntax-rule (check-refused pattern call) (check-exn pattern (lambda () call)))
  (check-refused #rx"^elliptic-integral-F: expected a modulus k between -1 and 1, or one with "
                 (elliptic-integral-F 1 2))
  (check-refused #rx"^elliptic-integral-F: .* given the modulus 1 and the angle 1.57"
                 (elliptic-integral-F :pi/2 1))
  (check-refused #rx"^third-elliptic-integral: expected a characteristic below 1"
                 (third-elliptic-integral 2 1/2))
  (for ([phi (in-list '(1 3.1 -1 -3.1))])
    (check-refused #rx"^elliptic-integral-Pi: expected a characteristic n with n sin² φ < 1"
                   (elliptic-integral-Pi 2 phi 1/2))))
