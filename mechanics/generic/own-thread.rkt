#lang racket/base
;; Work in a thread of its own, which may be given up: it is stopped by a break.
;;
;; A killed thread leaves its work half done: a part of the library half loaded, a table locked.
;; A break comes only where breaks are enabled.

(provide call-in-own-thread stop-thread)

;; thunk : -> value; late : -> value, called instead when so many seconds are over
;; An exception of the thunk is raised here.  A break of the caller ends the work.
(define (call-in-own-thread thunk [most-seconds #f] [late void])
  (define outcome #f)
  (define worker
    (parameterize-break #t
      (thread (lambda ()
                (set! outcome (with-handlers ([void (lambda (e) (lambda () (raise e)))])
                                (define result (thunk))
                                (lambda () result)))))))
  (define in-time?
    (dynamic-wind void
                  (lambda () (sync/timeout/enable-break most-seconds worker))
                  (lambda () (stop-thread worker))))
  (if in-time? (outcome) (late)))

;; Work that takes no break, in a procedure of the user's perhaps, is killed after all.
(define (stop-thread worker)
  (break-thread worker)
  (unless (sync/timeout longest-break worker) (kill-thread worker)))

(define longest-break 10)        ; seconds
