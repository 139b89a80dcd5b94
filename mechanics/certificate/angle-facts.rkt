#lang racket/base
;; Facts about the sines and cosines of the few angles by which others are written: those of arcs
;; and of points are known, those of parts of a turn as well, and of all others sin² = 1 - cos².

(require "claim-domain.rkt" "kernel-fact.rkt"
         "../algebra/expression/expression.rkt"
         "../algebra/expression/operation.rkt" "../algebra/expression/pi.rkt")

(provide circle-facts turn-facts angle-of-point? wave-of-angle)

(define (circle-facts angle)
  (define (of op) (make-node op (list angle)))
  (define u (and (node? angle) (pair? (node-args angle)) (car (node-args angle))))
  (define leg (and u (make-node op:sqrt (list (e:- 1 (make-node op:* (list u u)))))))
  (define hypotenuse (and u (make-node op:sqrt (list (e:+ 1 (make-node op:* (list u u)))))))
  (define (arc name sine cosine root)
    (list (root-relation root "radicand.")
          (fact 'value (of op:sin) sine (list (format "apply sin_~a; bounds." name)))
          (fact 'value (of op:cos) cosine (list (format "apply cos_~a; bounds." name)))))
  (cond [(headed? angle op:asin) (arc "asin" u leg leg)]
        [(headed? angle op:acos) (arc "acos" leg u leg)]
        [(and (node? angle) (angle-of-point? angle)) (point-facts angle of)]
        [(headed? angle op:atan)
         (append (arc "atan" (e:/ u hypotenuse) (e:/ 1 hypotenuse) hypotenuse)
                 (list (fact 'known hypotenuse '(<> . 0) '("apply hypotenuse_nonzero."))))]
        [else (list (circle-relation angle of))]))

;; The sine or cosine n of the angle of (x, y): y/√(x² + y²) or x/√(x² + y²); of others #f
(define (wave-of-angle n)
  (define angle (and (memq (node-head n) (list op:sin op:cos)) (car (node-args n))))
  (and (node? angle)
       (angle-of-point? angle)
       (e:/ ((if (eq? op:sin (node-head n)) car cadr) (node-args angle))
            (make-node op:sqrt (list (square-of-distance angle))))))

(define (point-facts angle of)
  (define h (make-node op:sqrt (list (square-of-distance angle))))
  (define (wave n)
    (fact 'value n (wave-of-angle n) '("apply wave_of_angle; first [assumption | nonzero].")))
  (list (wave (of op:sin))
        (wave (of op:cos))
        (fact 'known h '(<> . 0) '("apply Rgt_not_eq; apply sqrt_lt_R0; positive."))))

(define (circle-relation angle of)
  (fact 'relation (make-node op:* (list (of op:sin) (of op:sin)))
        (make-node op:- (list 1 (make-node op:* (list (of op:cos) (of op:cos)))))
        '("apply sine_squared.")))

;; The sine and cosine of a part of π
(define (turn-facts unit)
  (define q (/ 1 unit))
  (define angle (e:* unit exact-pi))
  (define (root n) (make-node op:sqrt (list n)))
  (define-values (s c)
    (case q
      [(1) (values 0 -1)]
      [(2) (values 1 0)]
      [(3) (values (e:/ (root 3) 2) 1/2)]
      [(4) (values (e:/ (root 2) 2) (e:/ (root 2) 2))]
      [(6) (values 1/2 (e:/ (root 3) 2))]))
  (define (value op e) (fact 'value (make-node op (list angle)) e (list (format "turn_~a." q))))
  (append (list (value op:sin s) (value op:cos c))
          (case q
            [(3 6) (list (root-relation (root 3)))]
            [(4) (list (root-relation (root 2)))]
            [else '()])))

;; Is it an arc tangent of two arguments, y and x?
(define (angle-of-point? n) (and (headed? n op:atan) (pair? (cdr (node-args n)))))
