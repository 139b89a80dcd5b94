#lang racket/base
;; Is a system one that leapfrog and its like can follow?
;;
;; They move the coordinates at constant velocities or momenta and these at constant
;; coordinates in turn.  So the rates of the coordinates may depend on the velocities
;; alone, and those of the velocities not on them: no damping, no magnetic field, no
;; mass that depends on the position.  Whether a rate depends on something shows where
;; that is changed.  Its formula may hold a velocity that cancels, as that of a driven
;; pendulum does.

(require racket/flonum
         "system.rkt"
         "../../error/complain.rkt"
         "../../generic/describe.rkt"
         "../../numeric/flvector.rkt"
         "../../numeric/ode/stepper.rkt")

(provide check-separable check-method-of-displacements)

;; m : method; s : system; y : flvector, the state at the start
(define (check-separable who m s y)
  (when (and (method-alternative m) (not (unbox (system-separable s))))
    (define n (flvector-length y))
    (define first (if (system-clock? s) 1 0))      ; of the coordinates
    (define middle (+ first (quotient (- n first) 2)))
    (define f! ((system-make-slope! s)))
    (define (slope y) (rates-at f! y))
    (unless (even? (- n first)) (raise-odd who m s y))
    (define elsewhere (moved y (car moves) 0 n))
    (define (depend? rates-from rates-to on-from on-to)
      (for*/or ([from (in-list (list y elsewhere))] [move (in-list moves)])
        (changed? (slope from) (slope (moved from move on-from on-to)) rates-from rates-to)))
    (when (depend? middle n middle n)
      (raise-not-separable who m "velocities" "velocities"))
    (when (depend? first middle 0 middle)
      (raise-not-separable who m "coordinates" "time or the coordinates"))
    (set-box! (system-separable s) #t)))

(define moves
  (list (lambda (x k) (fl+ x (fl* (fl+ 1.0 (flabs x)) (fl+ 0.1 (fl/ 0.3 (->fl (+ k 1)))))))
        (lambda (x k) (fl- (fl* -1.3 x) (fl/ 0.7 (->fl (+ k 2)))))
        (lambda (x k) (fl+ (fl* 2.5 x) (fl/ 1.9 (->fl (+ k 3)))))))

(define (moved y move from to)
  (for/flvector #:length (flvector-length y) ([x (in-flvector y)] [k (in-naturals)])
    (if (and (>= k from) (< k to)) (move x k) x)))

;; By more than rounding?  What is not a number tells nothing.
(define (changed? v w from to)
  (define rounding (fl* 1e-14 (flmax (greatest v) (greatest w))))
  (for/or ([x (in-flvector v from to)] [y (in-flvector w from to)])
    (define change (flabs (fl- x y)))
    (and (fl> change rounding)
         (fl> change (fl* 1e-9 (flmax (flabs x) (flabs y)))))))

(define (raise-odd who m s y)
  (complain who
            (string-append "~a takes states of a time, some coordinates and as many "
                           "velocities or momenta\n  state: ~a~a")
            (method-name m) (value->text (system-state s y)) (instead m)))

(define (raise-not-separable who m rates what)
  (complain who
            (string-append "~a moves coordinates and velocities in turn; "
                           "here the rates of the ~a depend on the ~a~a")
            (method-name m) rates what (instead m)))

;; The motion of a state with its displacements is that of no coordinates and velocities.
;; m : method, or #f where numbers have more bits than flonums
(define (check-method-of-displacements who m)
  (when (and m (method-alternative m))
    (complain who "~a follows a state and not how it depends on where it starts~a"
              (method-name m) (instead m))))

(define (instead m)
  (format "\n  use ~a, or a method that chooses its own steps"
          ((method-alternative m) (method-step m))))
