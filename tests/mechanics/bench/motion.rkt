#lang racket/base
;; Motions and paths computed from Lagrangians, derivation and compilation included.

(require (prefix-in m: mechanics)
         (only-in mechanics/dynamics/map/iterated-map iterated-map)
         (only-in mechanics/motion/event/event event)
         (only-in mechanics/motion/evolution evolve state-advancer)
         (only-in mechanics/motion/find-path find-path)
         (only-in mechanics/motion/evolve-trajectory evolve-trajectory)
         (only-in mechanics/motion/trajectory trajectory-events)
         "motion-systems.rkt" "task.rkt")

(provide motion-tasks motion-growth-sizes motion-growth-tasks)

;; -> how many states were shown
(define (driven-outputs)
  (define count 0)
  ((apply evolve driven-pendulum driven-parameters)
   (m:up 0.0 1.0 0.0) (lambda (state) (set! count (+ count 1))) 0.01 100.0 1e-13)
  count)

(define (released n)
  ((state-advancer (released-chain n)) (released-chain-start n) 1.0 1e-10))

(define (turned-body)
  ((state-advancer (rigid-body)) rigid-body-start 100.0 1e-13))

;; About 6.3 units of time from one crossing of x = 0 with p_x > 0 to the next
;; -> how many there were
(define (Henon-Heiles-crossings)
  (define crossing (event (lambda (s) (m:ref s 1 0)) #:direction 'rising))
  (length
   (trajectory-events
    (evolve-trajectory Henon-Heiles (Henon-Heiles-start 1/12 0.1 0.0) 62500.0
                       #:tolerance 1e-12 #:events crossing))))

(define (standard-map-orbit) ((iterated-map (standard-map 0.6) 20000000) 1.0 1.0 list void))

;; ---------------------------------------------------------------------------
;; In numbers of higher precision

(define ((oscillator) state)
  (m:up 1 (m:velocity state) (m:* -1 (m:coordinate state))))

(define (oscillator-to-50-digits)
  ((state-advancer oscillator) (m:up 0 1 0) 10 1e-50 #:precision 200))

(define (driven-to-30-digits)
  ((apply state-advancer driven-pendulum driven-parameters)
   (m:up 0 1 0) 1 1e-30 #:precision 120))

(define (precise-task name title run)
  (make-prepared-task name title
                      (lambda () (dynamic-require 'mechanics/motion/precise-run #f))
                      (lambda (_) (run))))

;; ---------------------------------------------------------------------------

(define ((L-harmonic m k) local)
  (m:- (m:* 1/2 m (m:square (m:velocity local))) (m:* 1/2 k (m:square (m:coordinate local)))))

(define (harmonic-path n) ((find-path (L-harmonic 1.0 1.0) 0.0 1.0 (* 2.0 (atan 1.0)) 0.0 n) 0.5))

;; ---------------------------------------------------------------------------

(define (chain-task n)
  (make-task (string->symbol (format "E~a" n))
             (format "motion of ~a links from 1 rad to t = 1, error 1e-10" n)
             (lambda () (released n))))

(define motion-tasks
  (append
   (list (make-task 'D1 "driven pendulum to t = 100, 10 001 outputs, error 1e-13"
                    driven-outputs #:size values)
         (make-task 'B1 "free rigid body in Euler angles to t = 100, error 1e-13" turned-body)
         (make-task 'H1 "crossings of a section by Hénon and Heiles's motion, to t = 62 500"
                    Henon-Heiles-crossings #:size values)
         (make-task 'M1 "standard map, 20 million times" standard-map-orbit)
         (precise-task 'V1 "harmonic oscillator to t = 10, to 50 digits" oscillator-to-50-digits)
         (precise-task 'V2 "driven pendulum to t = 1, to 30 digits" driven-to-30-digits))
   (map chain-task '(2 3 4 20))
   (for/list ([n (in-list '(3 10))])
     (make-task (string->symbol (format "P~a" n))
                (format "find-path, harmonic oscillator, ~a points" n)
                (lambda () (harmonic-path n))))))

(define motion-growth-sizes '(2 3 4 6 8 10 15 20 30 40 50))
(define motion-growth-tasks (map chain-task motion-growth-sizes))
