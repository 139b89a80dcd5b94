#lang racket/base
;; Motions and paths computed from Lagrangians, derivation and compilation included.

(require (prefix-in m: mechanics)
         ;; loaded before the clock starts
         (only-in mechanics/motion/evolution evolve state-advancer)
         (only-in mechanics/compile/scalar compile-scalar)
         (only-in mechanics/motion/find-path find-path)
         "systems.rkt" "task.rkt")

(provide motion-tasks)

;; ---------------------------------------------------------------------------
;; The driven pendulum: m = l = 1, g = 9.8, a pivot moved by 0.1 cos 2√9.8 t.

(define ((L-driven-pendulum m l g ys) local)
  (define t (m:time local))
  (define angle (m:coordinate local))
  (define v (m:velocity local))
  (define pivot ((m:D ys) t))
  (m:+ (m:* 1/2 m (m:+ (m:square (m:* l v)) (m:square pivot) (m:* 2 l v pivot (m:sin angle))))
       (m:* m g (m:- (m:* l (m:cos angle)) (ys t)))))

(define ((drive amplitude frequency) t) (m:* amplitude (m:cos (m:* frequency t))))

(define (driven-pendulum m l g amplitude frequency)
  (m:Lagrangian->state-derivative (L-driven-pendulum m l g (drive amplitude frequency))))

;; -> how many states were shown
(define (driven-outputs)
  (define count 0)
  ((evolve driven-pendulum 1.0 1.0 9.8 0.1 (* 2.0 (sqrt 9.8)))
   (m:up 0.0 1.0 0.0) (lambda (state) (set! count (+ count 1))) 0.01 100.0 1e-13)
  count)

;; ---------------------------------------------------------------------------
;; Equal links, m = l = 1, g = 9.8, released at 1 rad

(define (released-chain n)
  (define angles (m:vector->up (make-vector n 1.0)))
  ((state-advancer (m:Lagrangian->state-derivative (chain-Lagrangian/equal n)))
   (m:up 0.0 angles (m:* 0.0 angles)) 1.0 1e-10))

;; ---------------------------------------------------------------------------

(define ((L-harmonic m k) local)
  (m:- (m:* 1/2 m (m:square (m:velocity local))) (m:* 1/2 k (m:square (m:coordinate local)))))

(define (harmonic-path n) ((find-path (L-harmonic 1.0 1.0) 0.0 1.0 (* 2.0 (atan 1.0)) 0.0 n) 0.5))

;; ---------------------------------------------------------------------------
;; The action of two links that follow a given path for 100 s: some 20 000 evaluations
;; of the Lagrangian.  A test of the time keeps it from being compiled.

(define (waving t) (m:up (m:sin (m:* 3 t)) (m:cos (m:* 7 t))))
(define (waving/not-compiled t) (if (m:< t -1) (m:up 0 0) (waving t)))
(define (action q) (m:Lagrangian-action (chain-Lagrangian/equal 2) q 0 100))

;; ---------------------------------------------------------------------------

(define motion-tasks
  (append
   (list (make-task 'D1 "driven pendulum to t = 100, 10 001 outputs, error 1e-13"
                    driven-outputs #:size values))
   (for/list ([n (in-list '(2 3 4 20))])
     (make-task (string->symbol (format "E~a" n))
                (format "motion of ~a links from 1 rad to t = 1, error 1e-10" n)
                (lambda () (released-chain n))))
   (list (make-task 'A1 "action of 2 links along a given path, 100 s" (lambda () (action waving)))
         (make-task 'A1g "the same by the generic arithmetic"
                    (lambda () (action waving/not-compiled))))
   (for/list ([n (in-list '(3 10))])
     (make-task (string->symbol (format "P~a" n))
                (format "find-path, harmonic oscillator, ~a points" n)
                (lambda () (harmonic-path n))))))
