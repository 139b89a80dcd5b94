#lang racket/base
;; Trajectories in numbers of higher precision, as trajectory.rkt makes them of flonums.

(require racket/list
         "integration-plan.rkt" "precise-event.rkt" "precise-run.rkt" "trajectory-recording.rkt"
         "partial-result.rkt"
         "event/event.rkt"
         "../error/progress.rkt")

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
    (record-crossings! r (happening m s events (plan-bits p)) (stretch-to s)
                       (lambda (t) (record-step! r (step s t)))
                       #:state (lambda (t) (stretch-state m s t))
                       #:shown (lambda (t) (shown-time m t))
                       #:give-up (lambda (e t there)
                                   (raise-undefined e (shown-time m t) there (so-far)))))
  (define (run note!)
    (define note (noting note! p final))
    (motion-follow m final (lambda (s) (note s) (visit s))))
  (keeping-so-far so-far (call-with-progress (plan-progress? p) run))
  (so-far))

;; -> the crossings within a step, with times, in the order of the motion
(define (happening m s events bits)
  (define tolerance (expt 2 (- bits)))
  (define all (append-map (lambda (e) (crossings m s e tolerance)) events))
  (sort all (if (< (stretch-to s) (stretch-from s)) > <) #:key crossing-at))
