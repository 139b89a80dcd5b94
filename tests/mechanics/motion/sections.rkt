#lang racket/base
;; Surfaces of section of Hénon and Heiles's motion, as events of a trajectory: SICM 3.6.3,
;; in numbers.

(require mechanics
         "../support/checks.rkt" "../support/close.rkt")

(define (V x y)
  (+ (* 1/2 (+ (square x) (square y))) (* (square x) y) (* -1/3 (cube y))))

(define (H (up t (up x y) (down px py)))
  (+ (* 1/2 (+ (square px) (square py))) (V x y)))

(define (Hamilton-equations s)
  (up 1 (((partial 2) H) s) (- (((partial 1) H) s))))

;; On x = 0 with p_x > 0.
(define (section->state E y py)
  (up 0 (up 0 y) (down (sqrt (- (* 2 (- E (V 0 y))) (square py))) py)))

(define section (event (lambda (s) (ref s 1 0)) #:direction 'rising #:name 'section))

(define (crossings E y py time)
  (map occurrence-state
       (trajectory-events
        (evolve-trajectory Hamilton-equations (section->state E y py) time
                           #:tolerance 1e-14 #:events section))))

(define (on-section s) (list (ref s 1 1) (ref s 2 1)))

(test-case "first crossings"
  (define (first-three E y py) (map on-section (take-3 (crossings E y py 25))))
  (define (take-3 xs) (list (car xs) (cadr xs) (caddr xs)))
  (check-close (first-three 1/12 .1 0)
               '((.1723588468181 -.07374133880061)
                 (.3078743994648 -.08703493045268)
                 (.3881287410275 -.001652596947874))
               1e-11)
  (check-close (first-three 1/12 0 .1)
               '((-.05665634318842 .03173094606216)
                 (-.05516057138897 -.03546401691902)
                 (.005033309266668 -.1036517400932))
               1e-11)
  (check-close (first-three 1/8 .1 0)
               '((.3208297390186 -.07183026254416)
                 (.4701527853973 .02838154029137)
                 (.2205938962713 .06373223962777))
               1e-11)
  (check-close (first-three 1/6 .1 0)
               '((.5488146036799 -.003258636757405)
                 (.1181464121045 .0005288435752169)
                 (.5457781280972 .003036448911103))
               1e-11))

(test-case "five hundred crossings lie on the section and keep the energy"
  (define points (crossings 1/8 .1 0 3200))
  (check-true (> (length points) 500))
  (for ([s points])
    (check-= (ref s 1 0) 0 1e-10)
    (check-true (> (ref s 2 0) 0))
    (check-= (H s) 1/8 1e-11)))

(test-case "where the section ends"
  (for ([row '((1/12 -.3660254038 .5) (1/8 -.4396926208 .6736481777) (1/6 -.5 1))])
    (define E (car row))
    (for ([y (cdr row)] [within '(1 -1)])
      (check-= (V 0 y) E 1e-9)
      (define p (section->state E (+ y (* 1e-6 within)) 0))
      (check-true (real? (ref p 2 0))))))
