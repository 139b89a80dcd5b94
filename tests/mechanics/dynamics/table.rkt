#lang racket/base
;; Promises of maps, sections and flows, a row for each name: how far off a value may be
;; that is known otherwise, and the message where there is none.
;;
;; Published or independently computed values: SICM's figures 3.12, 3.19 and 4.20, and integrations
;; to 25 digits.

(require mechanics mechanics/book mechanics/plot
         "../support/checks.rkt" "../support/messages.rkt")

;; off : -> how far off it is; bound : how far it may be
;; refused : -> what raises; message : a regular expression
(struct row (name off bound refused message))
(define-syntax-rule (row-of name off bound refused message)
  (row 'name (lambda () off) bound (lambda () refused) message))

(define (off x expected)
  (for/fold ([most 0.0]) ([a (in-list (numbers x))] [b (in-list (numbers expected))])
    (max most (abs (- a b)))))

(define (numbers x)
  (cond [(list? x) (apply append (map numbers x))]
        [(up? x) (numbers (structure->list x))]
        [(down? x) (numbers (structure->list x))]
        [else (list x)]))

;; ---------------------------------------------------------------------------

(define omega (* 4.2 (sqrt 9.8)))
(define period (/ :2pi omega))
(define shaken (H-pend-sysder 1 1 9.8 0.05 omega))
(define strobe (stroboscopic-map shaken period))
(define T (standard-map 0.6))
(define strong (standard-map 1.4))
(define saddle (find-fixed-point strong (up 0 0)))
(define center (find-fixed-point T (up 3 0.1)))
(define golden (- 1 (/ 1 golden-ratio)))
(define (trace p) (apply + (map real-part (fixed-point-multipliers p))))
(define (silent x y return fail) (up x y))
(define (losing x y return fail) (return (+ x (* 0.9 y)) (* 0.9 y)))

(define (circling s) (up 1 (ref s 2) (- (ref s 1))))

;; Three oscillators, of frequencies 1, √2 and √3: six dimensions and the time.
(define frequencies (map sqrt '(1 2 3)))
(define (oscillators s)
  (define-values (q p) (values (coordinate s) (momentum s)))
  (up 1
      (apply up (structure->list p))
      (apply down (for/list ([w frequencies] [k 3]) (* -1 w w (ref q k))))))
(define rising (event (lambda (s) (ref (coordinate s) 0)) #:direction 'rising))
(define (after-a-turn q p)
  (define (turned f) (for/list ([w frequencies] [x q] [v p]) (f w x v (* :2pi w))))
  (list (turned (lambda (w x v a) (+ (* x (cos a)) (* (/ v w) (sin a)))))
        (turned (lambda (w x v a) (- (* v (cos a)) (* w x (sin a)))))))

(define branch
  (fixed-point-eigen strong 0 0 1e-10
                     (lambda (A dx dy B ex ey)
                       (list A (unstable-manifold strong 0 0 dx dy A 1e-8)))))

(define (widest-gap points)
  (for/fold ([most 0.0]) ([p points] [q (cdr points)])
    (define d (map (principal-value :pi) (numbers (- p q))))
    (max most (sqrt (apply + (map square d))))))

(define circle (invariant-circle (standard-map 0.95) golden))

(define table
  (list
   (row-of Poincare-map
           (let ([there ((Poincare-map oscillators rising)
                         (up 0 (up 0 0.3 -0.2) (down 1.0 0.1 0.4)))])
             (off (list (coordinate there) (momentum there))
                  (after-a-turn '(0 0.3 -0.2) '(1.0 0.1 0.4))))
           1e-11
           ((Poincare-map oscillators (event (lambda (s) (> (ref (coordinate s) 0) 0))))
            (up 0 (up 0 0.3 -0.2) (down 1.0 0.1 0.4)))
           #rx"it passes through zero: [(]- a b[)] where [(]< a b[)] changes$")
   (row-of HHmap
           (off ((HHmap 1/8 0.1 1e-10 1e-12) 0.1 0 list void)
                '(.3208297390186 -.07183026254416))
           1e-11
           (explore-map (frame -0.5 1 -0.6 0.6) (HHmap 1/8 0.1 1e-10 1e-12) 1
                        #:starts (list (up 0.9 0)))
           #rx"map: HHmap\n.*images of abscissas from -0.43969262[0-9]* to 0.67364817[0-9]*$")
   (row-of stroboscopic-map
           (off (strobe (up 0 1 0)) (list period .1545220284860514 -3.305964200270147))
           1e-11
           ((stroboscopic-map shaken omega) (up 0 1 0))
           #rx"has the period [(]/ :2pi omega[)]$")
   (row-of linearized-flow
           (let ([M ((linearized-flow (lambda () circling)) (up 0 1 0) 3.0 1e-12)])
             (off (list (ref M 1 1) (ref M 1 2) (ref M 2 1) (ref M 2 2))
                  (list (cos 3.0) (- (sin 3.0)) (sin 3.0) (cos 3.0))))
           1e-11
           ((linearized-flow HHsysder) (section->state 1/8 0.9 0) 1)
           #rx"expected a state")
   (row-of find-fixed-point
           (max (off (fixed-point-rotation-angle center) .795398830184)
                (off (trace (find-fixed-point (driven-pendulum-map 1 1 9.8 .05 omega) (up 0.1 0)))
                     .10692861069))
           1e-9
           (find-fixed-point shaken (up 0 1 0))
           #rx"a state derivative gives rates, it is no map of states")
   (row-of periodic-points
           (for/fold ([most 0.0]) ([p (periodic-points T 2 (list 0 :2pi 0 :2pi))])
             (define at (fixed-point-coordinates p))
             (define image ((iterated-map T 2) (ref at 0) (ref at 1) up void))
             (max most (off (map (principal-value :pi) (numbers (- image at))) '(0 0))))
           1e-11
           (periodic-points silent 1 (list 0 1 0 1))
           #rx"calls neither `return` nor `fail`")
   (row-of Floquet-multipliers
           (off (apply + (Floquet-multipliers shaken (up 0 :pi 0) period)) 4.63081658352)
           1e-9
           (Floquet-multipliers shaken (up 0 0 0) omega)
           #rx"which is no period")
   (row-of Lyapunov-exponents
           (off (Lyapunov-values (Lyapunov-exponents (lambda (s) (up 1 (* 2 (ref s 1))
                                                                     (* -1 (ref s 2))))
                                                     (up 0 1e-3 1.0) 10.0))
                '(2 -1))
           1e-2
           (Lyapunov-exponents T (up 1 1) 100)
           #rx"parameters are supplied first|expected a state derivative")
   (row-of rotation-number
           (off (rotation-value (rotation-number (standard-map 0.95) (up 0 2.1144605494391726)))
                golden)
           1e-10
           (rotation-number T 3)
           #rx"^rotation-number: expected a point")
   (row-of fast-Lyapunov-indicator
           (let ([sea (fast-Lyapunov-indicator strong (up 0.1 0.1))])
             (/ (fast-Lyapunov-indicator strong (up :pi 0.1)) sea))
           0.2
           (fast-Lyapunov-indicator silent (up 1 1))
           #rx"calls neither `return` nor `fail`")
   (row-of unstable-manifold
           (let ([p ((cadr branch) 0.7)])
             (off (strong (ref p 0) (ref p 1) up void) ((cadr branch) (* 0.7 (car branch)))))
           1e-9
           (unstable-manifold strong 0 0 1 1 0.4 1e-8)
           #rx"the unstable one of the inverse map")
   (row-of invariant-manifold
           (widest-gap (invariant-manifold strong saddle #:length 20 #:gap 0.05))
           0.0500001
           (invariant-manifold strong saddle #:stable? #t #:inverse strong)
           #rx"does not undo the map")
   (row-of homoclinic-points
           (let ([p (car (homoclinic-points strong saddle #:inverse (standard-map-inverse 1.4)
                                            #:stable-branch -1))])
             (for/fold ([most 0.0]) ([map (list strong (standard-map-inverse 1.4))])
               (define end ((iterated-map map 12) (ref p 0) (ref p 1) list void))
               (apply max most (for/list ([x end]) (abs ((principal-value :pi) x))))))
           1e-3
           (homoclinic-points strong center #:inverse (standard-map-inverse 1.4))
           #rx"only hyperbolic points have manifolds; this one is elliptic")
   (row-of find-invariant-curve
           (off (find-invariant-curve (standard-map 0.95) golden 0 2.0 2.2 1e-9)
                2.1144605494391726)
           1e-9
           (find-invariant-curve (standard-map 0.95) golden 0 2.2 2.4 1e-8)
           #rx"no curve is between them")
   (row-of invariant-circle
           (max (invariant-circle-error circle)
                (off (invariant-circle-ordinate circle 0) 2.1144605494391726))
           5e-13
           (invariant-circle losing golden)
           #rx"determinant of its derivatives: 0[.]9\n  off by: 0[.](09999|1)")
   (row-of radially-mapping-points
           (off ((iterated-map (standard-map 0.3) 3)
                 1.0 (radially-mapping-points (iterated-map (standard-map 0.3) 3) 1.8 2.4 1.0 1e-12)
                 (lambda (theta I) theta) void)
                1.0)
           1e-10
           (radially-mapping-points (standard-map 0) 0.1 0.2 1.0 1e-8)
           #rx"turns the angle the same way at both actions")))

(for ([r (in-list table)])
  (test-case (format "~a: as near as it is promised" (row-name r))
    (define found ((row-off r)))
    (check-true (<= found (row-bound r)) (format "off by ~a" found)))
  (test-case (format "~a: what is said where there is none" (row-name r))
    (check-regexp-match (row-message r) (message-of ((row-refused r)) exn:fail?))))
