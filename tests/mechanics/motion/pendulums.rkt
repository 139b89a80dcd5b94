#lang racket/base
;; Pendulums in numbers: against exact solutions, and digits computed elsewhere.

(require mechanics
         (only-in mechanics/book L-pendulum pend-state-derivative)
         "../support/checks.rkt" "../support/close.rkt" "../support/systems.rkt")

(define (crossing-times derivative start end f direction)
  (map occurrence-time
       (trajectory-events
        (evolve-trajectory derivative start end #:tolerance 1e-14
                           #:events (event f #:direction direction)))))

;; ---------------------------------------------------------------------------
;; The plane pendulum: m = l = 1, g = 9.8

(define pendulum (Lagrangian->state-derivative (L-pendulum 9.8 1 1)))

(define (period-from amplitude)
  (* 4 (/ (first-elliptic-integral (sin (/ amplitude 2))) (sqrt 9.8))))

(test-case "periods by elliptic integrals"
  (check-= (period-from 1) 2.140228719018093 1e-14)
  (define small (/ :2pi (sqrt 9.8)))
  (check-= small 2.007089923154493 1e-14)
  (check-= (/ (period-from (/ :pi 6)) small) 1.017408797596 1e-12)
  (check-= (/ (period-from :pi/2) small) 1.1803405990161 1e-13))

(test-case "periods of the motion are those"
  (for ([amplitude (list 1e-3 (/ :pi 6) 1 :pi/2 3)])
    (define T (period-from amplitude))
    (define tops (crossing-times pendulum (up 0 amplitude 0) (* 10.2 T) velocity 'falling))
    (check-equal? (length tops) 10)
    (for ([t tops] [k (in-naturals 1)])
      (check-= (/ t (* k T)) 1 1e-11))))

(test-case "the motion is an elliptic function of the time"
  (define k (sin 0.5))
  (define motion (evolve-trajectory pendulum (up 0 1 0) 20 #:tolerance 1e-14))
  (define omega (sqrt 9.8))
  (define quarter (/ (period-from 1) 4))
  (for ([t (in-range 0 20 7/10)])
    (define-values (sn cn dn)
      (Jacobi-elliptic-functions (* omega (+ t quarter)) k values))
    (check-= (coordinate (motion t)) (* 2 (asin (* k sn))) 1e-11)))

;; H = p²/2 - 9.8 cos(theta), from the bottom with p
(define p0 4.9006733894348145)

(test-case "frequency and Fourier coefficients of a wide swing"
  (define omega 2.5043962735932018)
  (define T (/ :2pi omega))
  (define motion (evolve-trajectory pendulum (up 0 0 p0) T #:tolerance 1e-14))
  (define crossings (crossing-times pendulum (up 0 0 p0) (* 3.2 T) coordinate 'rising))
  (check-close crossings (list T (* 2 T) (* 3 T)) 1e-11)
  (define (coefficient n)
    (* (/ 2 T)
       (for/fold ([sum 0]) ([k 64])     ; the trapezoidal rule: exact for what is periodic
         (define t (* k (/ T 64)))
         (+ sum (* (/ T 64) (coordinate (motion t)) (sin (* n omega t)))))))
  (check-close (map coefficient '(1 2 3 4 5))
               '(1.8349993630565 0 .038213003445971 0 .0013531286425114) 1e-12))

;; ---------------------------------------------------------------------------
;; The driven pendulum (1.6.2): m = l = 1, g = 9.8, the pivot at a cos(omega t)

(define (driven a omega) (pend-state-derivative 1 1 9.8 a omega))

(test-case "the driven pendulum of Fig. 1.7"
  (define advance (state-advancer driven 0.1 (* 2 (sqrt 9.8))))
  (for ([row '((1 -1.03011568739188687 -1.40985359335821735 1e-12)
               (10 1.27379225442614696 -3.45379718978431025 1e-11))])
    (define s (advance (up 0 1 0) (car row) 1e-14))
    (check-close (list (coordinate s) (velocity s)) (list (cadr row) (caddr row)) (cadddr row))))

;; Where sin(omega t) = 0 the momentum is the velocity.
(define (strobe a omega n)
  (define T (/ :2pi omega))
  (define s ((state-advancer driven a omega) (up 0 1 0) (* n T) 1e-14))
  (list ((principal-value :pi) (coordinate s)) (velocity s)))

(test-case "stroboscopic sections of the driven pendulum (Figs. 3.12 and 3.13)"
  (define-values (w fast slow) (values (sqrt 9.8) (* 4.2 (sqrt 9.8)) (* 2 (sqrt 9.8))))
  (check-= (/ :2pi fast) .4778785531320222 1e-15)
  (check-= (/ :2pi slow) 1.003544961577247 1e-15)
  (check-close (strobe .05 fast 1) '(.1545220284860514 -3.305964200270147) 1e-12)
  (check-close (strobe .05 fast 10) '(.03176555779650096 -3.36601214267835) 1e-11)
  (check-close (strobe .1 slow 1) '(-1.035081853906921 -1.391954888314461) 1e-12)
  (check-close (strobe .1 slow 10) '(1.147844209815797 -3.649871292786374) 1e-11))

;; The map's derivative at a fixed point by small steps about it.
(define (one-period-Jacobian a omega theta)
  (define h 1e-5)
  (define (image x p)
    (define s ((state-advancer driven a omega) (up 0 x p) (/ :2pi omega) 1e-14))
    (list (coordinate s) (velocity s)))
  (define (slopes plus minus) (for/list ([x plus] [y minus]) (/ (- x y) (* 2 h))))
  (append (slopes (image (+ theta h) 0) (image (- theta h) 0))
          (slopes (image theta h) (image theta (- h)))))

(test-case "its fixed points: traces, and areas that stay"
  (for ([row (list (list .05 4.2 0 .10692861069) (list .05 4.2 :pi 4.63081658352)
                   (list .1 2 0 -2.09858252542) (list .1 2 :pi 22.8213)
                   (list .03 100 0 1.97829406926) (list .03 100 :pi 1.98618058754))])
    (define J (one-period-Jacobian (car row) (* (cadr row) (sqrt 9.8)) (caddr row)))
    (define-values (a c b d) (apply values J))
    (check-= (+ a d) (cadddr row) (if (= (cadddr row) 22.8213) 1e-4 1e-7))
    (check-= (- (* a d) (* b c)) 1 1e-7)))

;; ---------------------------------------------------------------------------
;; The double pendulum (exercise 1.44)

(test-case "the double pendulum"
  (define motion
    (evolve-trajectory (Lagrangian->state-derivative (L-double-pendulum 1 3 1 0.9 9.8))
                       (up 0 (up :pi/2 :pi) (up 0 0)) 10 #:tolerance 1e-14))
  (for ([row '((1 1e-10 .0910630038849611 -1.66626245247204 -5.1832373624753 -4.02581660181084)
               (5 1e-8 6.82360398985888 8.60368993913788 -3.01497306538466 3.79006470284155)
               (10 1e-5 -1.83791138086248 7.23436805118771 -5.55782260321376 -2.85430402618441))])
    (define s (motion (car row)))
    (check-close (append (structure->list (coordinate s)) (structure->list (velocity s)))
                 (cddr row) (cadr row))))

;; ---------------------------------------------------------------------------
;; The Moon's rotation about its direction from the Earth (2.11): as a pendulum

(test-case "libration on a circular orbit: period in orbits, and amplitude"
  (define ((libration eps) (up t x v)) (up 1 v (* -1/2 (square eps) (sin (* 2 x)))))
  (define T (* 40.01601442 :2pi))
  (define start (up 0 0 .01))
  (define period
    (- (cadr (crossing-times (libration .026) start (* 2.1 T) coordinate 'rising))
       (car (crossing-times (libration .026) start (* 1.1 T) coordinate 'rising))))
  (check-= (/ period :2pi) 40.01601442 1e-8)
  (define top
    (trajectory-final-state
     (evolve-trajectory (libration .026) start T #:tolerance 1e-14
                        #:events (event velocity #:terminal? #t))))
  (check-= (coordinate top) .3947911197 1e-10))
