#lang racket/base
;; SICM 3.6, Surfaces of Section (pp. 239-263).

(require mechanics
         mechanics/book
         "../support/checks.rkt" "../support/close.rkt")

(define (fail) 'no-image)
(define parse read-expression)
(define omega0 (sqrt 9.8))
(define (pendulum A ratio) (driven-pendulum-map 1 1 9.8 A (* ratio omega0)))
(define ((after n) T x y) ((iterated-map T n) x y list fail))

;; ---------------------------------------------------------------------------
;; Stroboscopic sections of the driven pendulum

(test-case "p. 247: one period, and ten, of the pendulum whose figure is 3.12"
  (define T (pendulum .05 4.2))
  (check-close ((after 1) T 1 0) '(.1545220284860514 -3.305964200270147) 1e-12)
  (check-close ((after 10) T 1 0) '(.03176555779650096 -3.36601214267835) 1e-10))

(test-case "and of the one whose figure is 3.13"
  (define T (pendulum .1 2))
  (check-close ((after 1) T 1 0) '(-1.035081853906921 -1.391954888314461) 1e-12)
  (check-close ((after 10) T 1 0) '(1.147844209815797 -3.649871292786374) 1e-10))

;; Rotations stay on one cylinder.
(test-case "angles are between minus pi and pi"
  (define T (pendulum .05 4.2))
  (for ([point (list '(3 12) '(-3 -12) '(0 18))])
    (define end ((after 5) T (car point) (cadr point)))
    (check-true (<= (- pi) (car end) pi))))

(define (multipliers T x y) (fixed-point-eigen T x y 1e-10 list))
(define (trace T x y)
  (define all (multipliers T x y))
  (real-part (+ (car all) (list-ref all 3))))
(define (area T x y)
  (define all (multipliers T x y))
  (real-part (* (car all) (list-ref all 3))))

(test-case "traces at the bottom and at the top"
  (check-close (list (trace (pendulum .05 4.2) 0 0) (trace (pendulum .05 4.2) :pi 0))
               '(.10692861069 4.63081658352) 1e-10)
  (check-close (list (trace (pendulum .1 2) 0 0) (trace (pendulum .1 2) :pi 0))
               '(-2.09858252542 22.8213) 5e-5)
  (check-close (trace (pendulum .1 2) 0 0) -2.09858252542 1e-10)
  (check-close (list (trace (pendulum .03 100) 0 0) (trace (pendulum .03 100) :pi 0))
               '(1.97829406926 1.98618058754) 1e-10))

(test-case "Liouville: the map keeps areas, at any point"
  (for ([point '((1 0) (2 -3) (-1 8))])
    (check-close (area (pendulum .1 2) (car point) (cadr point)) 1 1e-9)))

(test-case "with the frequency reversed it leads back"
  (define there ((pendulum .05 4.2) 1 0 list fail))
  (check-close ((pendulum .05 -4.2) (car there) (cadr there) list fail) '(1 0) 1e-11))

;; ---------------------------------------------------------------------------
;; Hénon and Heiles

(test-case "pp. 252 to 262: the potential, the energy, the state derivative"
  (define s (up 't (up 'x 'y) (down 'p_x 'p_y)))
  (check-true (proved? (verify-equal (HHpotential s) (parse '(+ (/ (+ (expt x 2) (expt y 2)) 2)
                                                                (* (expt x 2) y)
                                                                (/ (expt y 3) -3))))))
  (check-true (proved? (verify-equal (- (HHHam s) (HHpotential s))
                                     (parse '(/ (+ (expt p_x 2) (expt p_y 2)) 2)))))
  (check-true (proved? (verify-equal ((HHsysder) s)
                                     (up 1
                                         (up 'p_x 'p_y)
                                         (down (parse '(- (+ x (* 2 x y))))
                                               (parse '(- (expt y 2) (expt x 2) y))))))))

(test-case "a state on the section has the energy; where that does not suffice there is none"
  (for* ([E '(1/12 1/8 1/6)] [y '(-0.2 0 0.3)] [p_y '(-0.1 0.2)])
    (check-close (HHHam (section->state E y p_y)) E 1e-15))
  (check-false (section->state 1/12 0.6 0))
  (check-equal? ((HHmap 1/12 0.1 1e-10 1e-12) 0.6 0 list fail) 'no-image))

;; The range of y at p_y = 0.
(test-case "the section is as wide as the energy allows"
  (for ([E '(1/12 1/8)]
        [least '(-.3660254038 -.4396926208)]
        [greatest '(.5 .6736481777)])
    (define (inside? y) (and (section->state E y 0) #t))
    (check-equal? (map inside? (list (- least 1e-6) (+ least 1e-6)
                                     (- greatest 1e-6) (+ greatest 1e-6)))
                  '(#f #t #t #f)))
  ;; y = 1 is a saddle: beyond it the star is free to leave
  (check-equal? (for/list ([y '(-.500001 -.499999 .999999)]) (and (section->state 1/6 y 0) #t))
                '(#f #t #t)))

(define crossings
  '((1/12 (.1 0) (.1723588468181 -.07374133880061) (.3078743994648 -.08703493045268)
          (.3881287410275 -.001652596947874))
    (1/12 (0 .1) (-.05665634318842 .03173094606216) (-.05516057138897 -.03546401691902)
          (.005033309266668 -.1036517400932))
    (1/8 (.1 0) (.3208297390186 -.07183026254416) (.4701527853973 .02838154029137)
         (.2205938962713 .06373223962777))
    (1/6 (.1 0) (.5488146036799 -.003258636757405) (.1181464121045 .0005288435752169)
         (.5457781280972 .003036448911103))))

(test-case "the first crossings"
  (for ([case crossings])
    (define T (HHmap (car case) 0.1 1e-10 1e-13))
    (for ([expected (cddr case)] [n (in-naturals 1)])
      (check-close (apply (after n) T (cadr case)) expected 1e-10))))

(test-case "the book's way, step by step, crosses there too"
  (define advance (make-advance (state-advancer HHsysder) 1e-12))
  (define-values (crossing beyond)
    (find-next-crossing (section->state 1/8 0.1 0) advance 0.1 1e-10 values))
  (check-close (ref (coordinate crossing) 0) 0 1e-10)
  (check-close (list (ref (coordinate crossing) 1) (ref (momentum crossing) 1))
               '(.3208297390186 -.07183026254416) 1e-9)
  (check-true (< 0 (- (time beyond) (time crossing)) 0.1))
  (check-close (ref (coordinate (refine-crossing 1e-12 advance beyond)) 0) 0 1e-12))

;; Each step leaves an error of 1e-9 behind.
(test-case "where no step comes nearer a crossing is as near as it can be"
  (define (advance s dt)
    (up (+ (time s) dt) (+ (coordinate s) (* dt (flip (momentum s))) (up 1e-9 0)) (momentum s)))
  (define found (refine-crossing 1e-12 advance (up 0 (up 0.5 0) (down 1.0 0))))
  (check-close (ref (coordinate found) 0) 1e-9 1e-12))

(test-case "the section map keeps areas, and its derivatives are those of the motion"
  (define T (HHmap 1/8 0.1 1e-10 1e-12))
  (check-close (area T 0.1 0) 1 1e-9)
  (check-close (area T -0.2 0.1) 1 1e-9))
