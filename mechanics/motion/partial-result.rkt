#lang racket/base
;; The partial result of a motion that an exception ended.
;;
;; The user's own procedures run in the middle of an integration: the state derivative, the
;; function of an event.  Their errors must reach the user unchanged, and so must a break from the
;; keyboard; neither may lose the part of the motion computed until then.  So the integration runs
;; with a continuation mark, which every exception raised within it keeps.

(provide keeping-so-far so-far (struct-out reached))

;; The point that a motion has reached whose steps are not kept.
;; exactly : real -> number of the kind of `time`; shown : back; method : that of the integration
(struct reached (time state exactly shown method) #:authentic)

(define key (make-continuation-mark-key 'so-far))

;; Evaluates the form; an exception raised in it carries the partial result that (give) makes.
(define-syntax-rule (keeping-so-far give form)
  (let ([value (with-continuation-mark key give form)]) value))

;; -> the innermost partial result of that kind that an exception carries, or #f
(define (so-far e [wanted? values])
  (for*/first ([give (in-list (continuation-mark-set->list (exn-continuation-marks e) key))]
               [result (in-value (give))]
               #:when (wanted? result))
    result))
