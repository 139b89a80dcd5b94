#lang racket/base
;; Mass matrices without an inverse: which directions carry no inertia.

(require mechanics "../support/checks.rkt")

(define (advance L state [method 'Dormand-Prince-853])
  ((state-advancer (lambda () (Lagrangian->state-derivative L))) state 1 1e-10 #:method method))

(define-check (check-directions L state expected)
  (with-handlers
      ([exn:fail:mechanics:singular:matrix?
        (lambda (e)
          (define found (exn:fail:mechanics:singular:matrix-null-vectors e))
          (with-check-info (['found found] ['message (exn-message e)])
            (unless (and (= (length found) (length expected))
                         (for/and ([v found] [w expected])
                           (and (< (min (euclidean-norm (- v w)) (euclidean-norm (+ v w))) 1e-9)
                                (regexp-match? (regexp-quote
                                                (format "no inertia in the direction: ~a" v))
                                               (exn-message e)))))
              (fail-check))))])
    (advance L state)
    (fail-check)))

(define (particle-of terms) (lambda (s) (* 1/2 (for/sum ([f terms]) (square (f (velocity s)))))))
(define (component k) (lambda (v) (ref v k)))

(test-case "one direction: only the sum of the velocities counts"
  (check-directions (particle-of (list (lambda (v) (+ (ref v 0) (ref v 1)))))
                    (up 0 (up 1 2) (up 3 4)) (list (up -1 1))))

(test-case "a coordinate whose velocity does not occur"
  (check-directions (particle-of (list (component 0) (component 2)))
                    (up 0 (up 1 2 3) (up 3 4 5)) (list (up 0 1 0))))

(test-case "several directions, for small and for large matrices"
  (check-directions (particle-of (list (lambda (v) (+ (ref v 0) (ref v 1) (ref v 2)))))
                    (up 0 (up 1 2 3) (up 3 4 5)) (list (up -1 1 0) (up -1 0 1)))
  (check-directions (particle-of (list (lambda (v) (+ (ref v 0) (ref v 1)))
                                       (lambda (v) (- (ref v 2) (ref v 4)))
                                       (component 3)))
                    (up 0 (up 1 2 3 4 5) (up 3 4 5 6 7)) (list (up -1 1 0 0 0) (up 0 0 1 0 1))))

(test-case "singular but for rounding"
  (check-directions (particle-of (list (lambda (v) (+ (* (cos 0.3) (ref v 0))
                                                      (* (sin 0.3) (ref v 1))))))
                    (up 0 (up 1 2) (up 3 4)) (list (up (- (tan 0.3)) 1))))

(test-case "where the state makes it so: the angle at the centre of polar coordinates"
  (define L
    (lambda (s) (* 1/2 (+ (square (ref (velocity s) 0))
                          (square (* (ref (coordinate s) 0) (ref (velocity s) 1)))))))
  (check-directions L (up 0 (up 0 2) (up 1 4)) (list (up 0 1)))
  (check-exn #rx"direction: [(]up 0.0 1.0[)]" (lambda () (advance L (up 0 (up 0 2) (up 1 4))))))

(test-case "reached on the way: the last state and the direction are told"
  (define (L s)
    (define v (velocity s))
    (* 1/2 (+ (square (ref v 0)) (* (if (< (ref (coordinate s) 0) 2) 1 0) (square (ref v 1))))))
  (define tr
    (with-called ([told (lambda (e)
                          (check-regexp-match
                           (string-append
                            "^evolve-trajectory: the motion cannot be followed any further\n"
                            "  time: (1.0|0.99999)[^\n]*\n  last state: [^\n]*\n"
                            "  the mass matrix has no inverse (there|beyond)\n"
                            "  no inertia in the direction: [(]up 0 1[)]$")
                           (exn-message e))
                          (exn:fail:mechanics:singular-where e))])
      (with-handlers ([exn:fail:mechanics:singular? told])
        (evolve-trajectory (Lagrangian->state-derivative L) (up 0 (up 1 0) (up 1 3)) 10))))
  (check-= (ref (coordinate (tr 0.5)) 1) 1.5 1e-9))

(test-case "almost singular is not singular"
  (define ((L e) s)
    (define v (velocity s))
    (* 1/2 (+ (square (+ (ref v 0) (ref v 1))) (* e (square (ref v 0))))))
  (for ([e '(1e-6 1e-12)])
    (check-= (ref (coordinate (advance (L e) (up 0 (up 1 2) (up 3 4)))) 0) 4 1e-8)))
