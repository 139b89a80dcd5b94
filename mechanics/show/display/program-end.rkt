#lang racket/base
;; The end of a program: pictures that nobody has seen are shown, and windows stay until the
;; reader closes them.
;;
;; Racket calls `executable-yield-handler` at the end of the program that it was started with.  In
;; an editor, which goes on and has events of its own, the end is the first event after the
;; program's, and nothing waits.  At a prompt no program ends.

(require "display-style.rkt"
         "../../error/note.rkt"
         "../../generic/on-demand.rkt")

(require-on-demand #:in-this-thread [racket/gui/dynamic gui-dynamic-require])

(provide start-program! leave-program!
         stay-open! note-unseen! note-seen!
         current-picture-watcher)

;; windows, unseen : the latest first
(struct program ([windows #:mutable] [unseen #:mutable]) #:authentic)

;; closed : event, that it was closed; wait : event ->, waits for it while windows work
(struct window (closed wait))

;; show : opens a window, or raises exn:fail; remark : -> text, said where there is none
(struct picture (value show remark))

;; A program, #f where none will end, or 'unknown.
(define current-program (make-parameter 'unknown))

;; Idempotent.
(define (start-program!)
  (unless (program? (current-program))
    (define p (program '() '()))
    (define after (executable-yield-handler))
    (current-program p)
    (executable-yield-handler
     (lambda (status)
       (when (eq? p (current-program)) (end! p status))
       (after status)))))

;; For a prompt.
(define (leave-program!) (current-program #f))

;; -> the program, which Racket's command line may name, or #f
(define (program-here)
  (when (and (eq? (current-program) 'unknown)
             (regexp-match? #rx"[.](?:rkt|ss|scm)$" (find-system-path 'run-file)))
    (start-program!))
  (and (program? (current-program)) (current-program)))

;; ---------------------------------------------------------------------------

;; wait? : until the window is closed; 'at-end : the end of the program waits
;; closed, wait : as in a window
(define (stay-open! wait? closed wait)
  (cond [(not (eq? wait? 'at-end)) (when wait? (wait closed))]
        [(current-program)
         (start-program!)
         (define p (current-program))
         (set-program-windows! p (cons (window closed wait) (open-windows p closed)))]))

;; #f, or called with a picture each time it changes: a notebook shows it at the end of its cell.
(define current-picture-watcher (make-parameter #f))

;; Without that whose event is given.
(define (open-windows p [other #f])
  (for/list ([w (in-list (program-windows p))]
             #:unless (or (eq? other (window-closed w)) (sync/timeout 0 (window-closed w))))
    w))

(define most-kept 12)

;; value : a picture that has changed for the first time
(define (note-unseen! value show remark)
  (define p (program-here))
  (when p
    (when (and (null? (program-unseen p)) (in-editor?))
      ((gui-dynamic-require 'queue-callback) (lambda () (show-unseen! p)) #f))
    (define all (cons (picture value show remark) (program-unseen p)))
    (set-program-unseen! p (for/list ([u (in-list all)] [_ (in-range most-kept)]) u))))

(define (note-seen! value)
  (define p (current-program))
  (when (program? p)
    (set-program-unseen! p (remove value (program-unseen p)
                                   (lambda (v u) (eq? v (picture-value u)))))))

(define (in-editor?) (eq? (manner-here 'typeset) 'snip))

;; ---------------------------------------------------------------------------

;; A program that ended by an error shows nothing more; its windows stay.
(define (end! p status)
  (with-handlers ([exn:break? void])
    (when (eqv? status 0) (show-unseen! p))
    (define open (open-windows p))
    (unless (null? open)
      (flush-output)
      (note "the program has ended; its windows stay until they are closed, or until Ctrl-C")
      (for ([w (in-list open)]) ((window-wait w) (window-closed w))))))

(define (show-unseen! p)
  (for ([u (in-list (reverse (program-unseen p)))])
    (with-handlers ([exn:fail? (lambda (e) (note ((picture-remark u))))])
      ((picture-show u))))
  (set-program-unseen! p '()))
