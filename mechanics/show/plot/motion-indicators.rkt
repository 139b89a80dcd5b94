#lang racket/base
;; The indicators of chaos of many motions, whose starts stand on a grid of points, by the workers
;; of ensembles.

(require racket/flonum
         "../../dynamics/chaos-indicator.rkt" "../../dynamics/map/period-check.rkt"
         "../../error/complain.rkt"
         "../../generic/describe.rkt" "../../generic/function-check.rkt"
         "../../generic/wrong-argument.rkt"
         "../../motion/observed-systems.rkt" "../../motion/system/check.rkt"
         "../../scale/ensemble/evolve-ensemble.rkt"
         "../../value/shape.rkt")

(provide motion-indicators)

;; f : state derivative; state-at : x y -> the state there, or #f where there is none
;; xs, ys : flvectors -> an flvector, row by row, with not-a-number where there is no motion
;; (grown all) after each row, where motions to come are -inf.0
(define (motion-indicators who f state-at xs ys duration
                           #:indicator kind #:tolerance tolerance #:jobs jobs #:checkpoint file
                           #:grown [grown void])
  (check-asked who f state-at duration kind)
  (define states
    (for*/list ([y (in-flvector ys)] [x (in-flvector xs)]) (state-at x y)))
  (define starts (filter values states))
  (unless (pair? starts) (complain who "#:state gives no state in the frame"))
  (check-derivative who f (car starts))
  (note-followed f '() (car starts))
  (define begin-time (if (timed-state? f (car starts)) (car (scalars (car starts))) 0))
  (define-values (all add!) (spread states (flvector-length xs) grown))
  (call-unwatched
   (lambda ()
     (evolve-ensemble (watched-derivative kind f)
                      (for/list ([s (in-list starts)]) (watched-start kind f s))
                      (+ begin-time duration)
                      #:collect (lambda (all) (indicator-of kind all))
                      #:observe add! #:fold void #:initial #f
                      #:tolerance (or tolerance usual-tolerance) #:method indicator-method
                      #:jobs jobs #:checkpoint file)))
  all)

(define (check-asked who f state-at duration kind)
  (check-kind who kind)
  (check-positive who "duration" duration)
  (unless (takes-arguments? f 1)
    (complain who "with #:state, expected a state derivative\n  given: ~a" (describe-with-value f)))
  (unless (takes-arguments? state-at 2)
    (complain-of-argument who "#:state, a function of two coordinates" state-at)))

;; -> an flvector for all states, in rows of that width, and a procedure that puts the value of the
;; k-th of those that are none #f into it
(define (spread states width grown)
  (define all
    (for/flvector #:length (length states) ([s (in-list states)]) (if s -inf.0 +nan.0)))
  (define places (for/vector ([s (in-list states)] [k (in-naturals)] #:when s) k))
  (define last (- (vector-length places) 1))
  (values all
          (lambda (k x)
            (define place (vector-ref places k))
            (flvector-set! all place (if (real? x) (real->double-flonum x) +nan.0))
            (unless (and (< k last)
                         (= (quotient place width) (quotient (vector-ref places (+ k 1)) width)))
              (grown all)))))
