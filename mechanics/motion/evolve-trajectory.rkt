#lang racket/base
;; A motion followed from one time to another, step by step, as a trajectory; with the events
;; on the way.  If it ends before its time, the motion followed so far is kept.

(require racket/flonum
         racket/list
         "method-names.rkt" "observed-systems.rkt" "integration-plan.rkt" "trajectory-recording.rkt"
         "run-system.rkt" "partial-result.rkt"
         "choose-method.rkt" "trajectory.rkt"
         "event/event.rkt" "event/event-watch.rkt" "event/region-watch.rkt" "event/within-step.rkt"
         "system/check.rkt" "system/make-system.rkt" "system/system.rkt"
         "../generic/define-plain.rkt" "../generic/on-demand.rkt"
         "../numeric/flvector.rkt" "../error/progress.rkt")

(require-on-demand ["precise-trajectory.rkt" follow-precise-trajectory])

(provide evolve-trajectory
         ;; for those who follow a motion piece by piece
         flonum-trajectory)

(define-plain (evolve-trajectory derivative state end
                           #:tolerance [tolerance #f]
                           #:events [events '()]
                           #:method [method #f]
                           #:longest-step [longest +inf.0]
                           #:most-steps [most +inf.0]
                           #:precision [bits (ode-precision)]
                           #:progress? [progress? (report-progress)])
  (check-real 'evolve-trajectory "final time" end)
  (define p
    (make-plan 'evolve-trajectory tolerance method longest most
               #:precision bits #:progress? progress?))
  (define all-events (check-events 'evolve-trajectory events))
  (note-followed derivative '() state)
  (if bits
      (precise-trajectory p derivative state (real-number end) all-events)
      (flonum-trajectory p derivative state end all-events #f)))

(define (precise-trajectory p derivative state end events)
  (define (make steps occurrences exactly shown state)
    (trajectory (for/vector ([s (in-list steps)])
                  (step (first s) (second s) (third s) (second s)))
                occurrences
                (reading exactly shown (lambda (s t) (state (step-inside s) t)))
                'extrapolation))
  (follow-precise-trajectory p derivative state end events make))

;; given : a plan; within : a region or #f
(define (flonum-trajectory given derivative state end events within)
  (define who (plan-who given))
  (define s (for-one-integration (make-system who derivative state)))
  (define y (state-vector who state))
  (define p (suited given s y))
  (define watch (watch-for who events state (flvector-length y) (plan-tolerance p)))
  (define events-in
    (if within
        (watch-region within watch (flvector-length y))
        (lambda (at from to) (watch at))))
  (define start (start-time s y))
  (define r (make-recording))
  (define (stay)
    (step start start (lambda (theta out) (flvector-copy! out y)) start))
  (define (so-far)
    (trajectory (list->vector (recorded-steps r stay)) (recorded-occurrences r)
                (flonum-reading s) (method-shown (plan-method p))))
  ;; -> is the integration to go on?
  (define (visit from to interpolant)
    (define at (interpolant))
    (record-crossings! r (crossings-in-time (events-in at from to) from to) to
                       (lambda (t) (record-step! r (step from t at to)))
                       #:state (lambda (t) (state-within s (step from to at to) t))
                       #:shown values
                       #:give-up (lambda (e t there) (raise-undefined e t there (whole) who))))
  (define (whole) (if within ((region-whole within) (so-far)) (so-far)))
  (keeping-so-far whole
    (run-system p s y start (real->double-flonum (real-number end)) visit
                (lambda (state) (whole))))
  (so-far))

(define (flonum-reading s)
  (reading real->double-flonum values (lambda (st t) (state-within s st t))))
