#lang mechanics
;; The orbit of Hénon and Heiles that runs to and fro on a straight line towards a saddle, by its
;; energy: the closer it comes, the longer it stays there, and the faster stable and unstable
;; intervals follow one another.  At each border another orbit is born.

(define (H (up t (up x y) (down px py)))
  (+ (* 1/2 (+ (square px) (square py))) (* 1/2 (+ (square x) (square y)))
     (* (square x) y) (* -1/3 (cube y))))

(define straight
  (continue-periodic-orbit (Hamiltonian->state-derivative H)
                           (up 0 (up 0 0.1) (down 0 0.1)) 6.3 0.01 0.166 #:energy H))
straight

;; In units of the energy of the saddles, 1/6
(define births
  (for/list ([s (branch-special-points straight)] #:when (eq? (special-point-kind s) 'pitchfork))
    (* 6 (special-point-parameter s))))
births

(module+ test
  (require rackunit)
  ;; M. Brack, Foundations of Physics 31 (2001) 209
  (test-case "the energies that Brack gives"
    (for ([birth births] [published '(0.969309 0.986709)]) (check-= birth published 1e-6)))
  (test-case "the orbit is on the line, and its period rises from that of small oscillations"
    (for ([s (branch-states straight)]) (check-= (ref s 1 0) 0 1e-9))
    (check-= (car (branch-periods straight)) (* 2 :pi) 0.1)
    (check-true (apply < (branch-periods straight)))))
