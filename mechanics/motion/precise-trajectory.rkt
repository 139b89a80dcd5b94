#lang racket/base
;; Trajectories in numbers of higher precision, as trajectory.rkt makes them of flonums.

(require "event.rkt" "plan.rkt" "precise-event.rkt" "precise.rkt"
         "../error/failure.rkt"
         "../numeric/progress.rkt")

(provide follow-precise-trajectory)

;; (make steps occurrences exactly shown state) makes a trajectory; a step is a list of
;; two times, exact, and the stretch they are of, which may be longer.
(define (follow-precise-trajectory p derivative state end events make)
  (define steps '())
  (define occurrences '())
  (define m (make-motion p derivative state (lambda (last) (so-far))))
  (define final (inexact->exact end))
  (for ([e (in-list events)]) (event-value 'evolve-trajectory e state))
  (define (record! s to) (set! steps (cons (list (stretch-from s) to s) steps)))
  (define (so-far)
    (when (null? steps) (record! (motion-stay m) (motion-start m)))
    (make (reverse steps)
          (reverse occurrences)
          inexact->exact
          (lambda (t) (shown-time m t))
          (lambda (s t) (stretch-state m s t))))
  (define (occur! e t state)
    (set! occurrences (cons (occurrence e (shown-time m t) state) occurrences)))
  ;; -> is the motion to go on?
  (define (visit s)
    (define (undefined e t state)
      (record! s t)
      (raise-undefined e (shown-time m t) state (so-far)))
    (let loop ([found (happening m s events (plan-bits p) undefined)])
      (cond [(null? found) (record! s (stretch-to s)) #t]
            [else
             (define-values (t e) (values (caar found) (cdar found)))
             (occur! e t (stretch-state m s t))
             (cond [(event-terminal? e) (record! s t) #f]
                   [else (loop (cdr found))])])))
  (define (run note!)
    (define note (noting note! p final))
    (motion-follow m final (lambda (s) (note s) (visit s))))
  (call-with-progress (plan-progress? p) run)
  (so-far))

;; ((time . event) ...) within a step, in the order of the motion.
(define (happening m s events bits undefined)
  (define tolerance (expt 2 (- bits)))
  (define all
    (for*/list ([e (in-list events)]
                [t (in-list (crossings m s e tolerance
                                       (lambda (t state) (undefined e t state))))])
      (cons t e)))
  (sort all (if (< (stretch-to s) (stretch-from s)) > <) #:key car))
