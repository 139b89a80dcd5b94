#lang racket/base
;; SICM 3.2, Poisson Brackets (pp. 218-222).

(require mechanics
         "../support/checks.rkt" "../support/session.rkt")

(define s (up 't (up 'x 'y) (down 'px 'py)))
(define-values (F G H)
  (values (literal-function 'F (Hamiltonian 2))
          (literal-function 'G (Hamiltonian 2))
          (literal-function 'H (Hamiltonian 2))))

(test-case "p. 218: the bracket of functions of one coordinate"
  (define-values (f g)
    (values (literal-function 'f (Hamiltonian 1)) (literal-function 'g (Hamiltonian 1))))
  (define one (up 't 'q 'p))
  (check-identity ((Poisson-bracket f g) one)
                  (- (* (((partial 1) f) one) (((partial 2) g) one))
                     (* (((partial 2) f) one) (((partial 1) g) one)))))

(test-case "Hamilton's equations are brackets with H"
  (check-identity ((Poisson-bracket coordinate H) s) (((partial 2) H) s))
  (check-identity ((Poisson-bracket momentum H) s) (- (((partial 1) H) s)))
  (define slope ((Hamiltonian->state-derivative H) s))
  (check-identity (* ((D F) s) slope)
                  (+ (((partial 0) F) s) ((Poisson-bracket F H) s))))

(test-case "brackets of coordinates and momenta"
  (check-unsimplified ((Poisson-bracket coordinate momentum) s) '(up (down 1 0) (down 0 1)))
  (check-unsimplified ((Poisson-bracket momentum coordinate) s) '(down (up -1 0) (up 0 -1)))
  (check-unsimplified ((Poisson-bracket coordinate coordinate) s) '(up (up 0 0) (up 0 0))))

(test-case "properties of brackets"
  (check-identity ((+ (Poisson-bracket F G) (Poisson-bracket G F)) s) 0)
  (check-identity ((Poisson-bracket F (+ G H)) s)
                  ((+ (Poisson-bracket F G) (Poisson-bracket F H)) s))
  (check-identity ((Poisson-bracket F (* 'c G)) s) ((* 'c (Poisson-bracket F G)) s))
  (check-identity ((Poisson-bracket F (* G H)) s)
                  ((+ (* G (Poisson-bracket F H)) (* (Poisson-bracket F G) H)) s)))

(test-case "Jacobi's identity"
  (check-identity ((+ (Poisson-bracket F (Poisson-bracket G H))
                      (Poisson-bracket G (Poisson-bracket H F))
                      (Poisson-bracket H (Poisson-bracket F G)))
                   s)
                  0))

(test-case "a planted mistake is seen: without its third term it is none"
  (check-eq? (verdict-status
              (prove-zero ((+ (Poisson-bracket F (Poisson-bracket G H))
                              (Poisson-bracket G (Poisson-bracket H F)))
                           s)))
             'refuted))
