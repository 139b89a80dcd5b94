#lang racket/base
;; Trajectories in numbers of higher precision, as trajectory.rkt makes them of flonums.

(require "event.rkt" "plan.rkt" "precise-event.rkt" "precise.rkt" "recording.rkt"
         "../numeric/progress.rkt")

(provide follow-precise-trajectory)

;; (make steps occurrences exactly shown state) makes a trajectory; a step is a list of
;; two times, exact, and the stretch they are of, which may be longer.
(define (follow-precise-trajectory p derivative state end events make)
  (define r (make-recording))
  (define m (make-motion p derivative state (lambda (last) (so-far))))
  (define final (inexact->exact end))
  (for ([e (in-list events)]) (event-value 'evolve-trajectory e state))
  (define (step s to) (list (stretch-from s) to s))
  (define (so-far)
    (make (recorded-steps r (lambda () (step (motion-stay m) (motion-start m))))
          (recorded-occurrences r)
          inexact->exact
          (lambda (t) (shown-time m t))
          (lambda (s t) (stretch-state m s t))))
  ;; -> is the motion to go on?
  (define (visit s)
    (define (end! t) (record-step! r (step s t)))
    (define (give-up e t state)
      (raise-undefined e (shown-time m t) state (so-far)))
    (define (undefined e t state)
      (end! t)
      (give-up e t state))
    (record-crossings! r (happening m s events (plan-bits p) undefined) (stretch-to s) end!
                       #:state (lambda (t) (stretch-state m s t))
                       #:shown (lambda (t) (shown-time m t))
                       #:give-up give-up))
  (define (run note!)
    (define note (noting note! p final))
    (motion-follow m final (lambda (s) (note s) (visit s))))
  (call-with-progress (plan-progress? p) run)
  (so-far))

;; What is within a step, with times, in the order of the motion.
(define (happening m s events bits undefined)
  (define tolerance (expt 2 (- bits)))
  (define all
    (for*/list ([e (in-list events)]
                [t (in-list (crossings m s e tolerance
                                       (lambda (t state) (undefined e t state))))])
      (crossing t e)))
  (sort all (if (< (stretch-to s) (stretch-from s)) > <) #:key crossing-at))
