#lang mechanics
;; The electric and the magnetic field as one form: Maxwell's equations, waves, and the field of a
;; charge that moves.

(require mechanics/geometry)
(define-coordinates (up ct x y z) SR)
(define event ((point SR) (up 'ct 'x 'y 'z)))

;; Fields of which nothing is known
(define (unknown name) (literal-manifold-function name SR))
(define F (Faraday (unknown 'E_x) (unknown 'E_y) (unknown 'E_z)
                   (unknown 'B_x) (unknown 'B_y) (unknown 'B_z)))
(define J (four-current (unknown 'rho) (unknown 'I_x) (unknown 'I_y) (unknown 'I_z) #:c 'c))

;; dF = 0 says that there are no magnetic charges,
(((d F) d/dx d/dy d/dz) event)
;; and that a field which changes induces another.
(((d F) d/dct d/dy d/dz) event)
;; d*F = 4 pi *J is Gauss's law
(define sources (- (d (SR-star F)) (* 4 ':pi (SR-star J))))
((sources d/dx d/dy d/dz) event)
;; and Ampère's with Maxwell's term.
((sources d/dct d/dy d/dz) event)

;; Any wave along x solves both, if E and B are alike and in the right order.
(define f (compose (literal-function 'f) (- x ct)))
(define wave (Faraday 0 f 0 0 0 f))
(define waves (list (verify-equal (d wave) 0) (verify-equal (d (SR-star wave)) 0)))
waves
(define backwards (verify-equal (d (Faraday 0 f 0 0 0 (* -1 f))) 0))
(verdict-status backwards)

;; An observer who follows it sees the same wave with less of a field: Doppler's factor.
(define observer
  (make-SR-frame 'observer the-ether (up 1 0 0) 'v (make-SR-coordinates the-ether (up 0 0 0 0))))
(define seen (ref (electric-field wave observer) 1))
(define Doppler (verify-equal (square (/ seen f)) (/ (- 1 'v) (+ 1 'v))))
Doppler

;; The charge q rests at the origin of the observer's frame; in ours it moves.
(define charge
  (let-coordinates ([(up ct x y z) observer])
    (define r^3 (expt (+ (square x) (square y) (square z)) 3/2))
    (Faraday (/ (* 'q x) r^3) (/ (* 'q y) r^3) (/ (* 'q z) r^3) 0 0 0 #:in observer)))
(define moving (list (verify-equal (d charge) 0) (verify-equal (d (SR-star charge)) 0)))
moving

;; There is a magnetic field round its way, v times the electric one, as of a current.
(define-values (E B) (values (electric-field charge) (magnetic-field charge)))
(define magnetism
  (list (verify-equal (ref B 0) 0)
        (verify-equal (ref B 1) (* -1 'v (ref E 2)))
        (verify-equal (ref B 2) (* 'v (ref E 1)))))
magnetism

(module+ test
  (require rackunit)
  (test-case "what is proved"
    (for ([v (append waves moving magnetism (list Doppler))]) (check-pred proved? v)))
  (test-case "a wave with the magnetic field turned round is none"
    (check-pred refuted? backwards)))
