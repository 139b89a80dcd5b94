#lang racket/base
;; What was computed of a motion when something ended it.
;;
;; The user's own procedures run in the middle of an integration: the state derivative, the
;; function of an event.  An error of theirs must reach the user as it is, and so must a break
;; from the keyboard; neither may cost what was computed until then.  So the integration runs
;; with a continuation mark, which every exception raised within keeps a hold of.

(provide keeping-so-far so-far (struct-out reached))

;; Where a motion has come of which the steps are not kept.
;; exactly : real -> the same as `time` is; shown : back; method : what integrates it
(struct reached (time state exactly shown method) #:authentic)

(define key (make-continuation-mark-key 'so-far))

;; The value of a form; within it (give) makes what there is so far.
(define-syntax-rule (keeping-so-far give form)
  (let ([value (with-continuation-mark key give form)]) value))

;; The same for an exception: what was made when it was raised, or #f.
(define (so-far e)
  (define give (continuation-mark-set-first (exn-continuation-marks e) key))
  (and give (give)))
