#lang racket/base
;; The end of a program, called in this process: what it shows, and which windows it waits for.
;; Programs that end are in program-end.rkt.

(require mechanics/show/display/program-end
         (only-in mechanics/plot frame plot-point)
         "../../support/checks.rkt" "../../support/skip.rkt")

;; The program begins in the body and ends with a status -> what is said on the error port
(define-syntax-rule (ended status body ...)
  (parameterize ([executable-yield-handler void] [current-error-port (open-output-string)])
    (leave-program!)
    (start-program!)
    body ...
    (define end (executable-yield-handler))
    (end status)
    (leave-program!)
    (get-output-string (current-error-port))))

(define shown '())
(define (picture name [show (lambda () (set! shown (cons name shown)))])
  (note-unseen! name show (lambda () (format "never shown: ~a" name))))

(test-case "pictures that nobody has seen are shown in their order, or told; not behind an error"
  (define (pictures)
    (set! shown '())
    (picture 'a)
    (picture 'b)
    (picture 'c (lambda () (error "no screen")))
    (picture 'd)
    (note-seen! 'b))
  (check-equal? (ended 0 (pictures)) "; never shown: c\n")
  (check-equal? shown '(d a))
  (check-equal? (ended 1 (pictures)) "")
  (check-equal? shown '()))

(test-case "of many pictures the last twelve are shown"
  (set! shown '())
  (check-equal? (ended 0 (for ([k 20]) (picture k))) "")
  (check-equal? shown (for/list ([k (in-range 19 7 -1)]) k)))

(test-case "where no program will end nothing is kept"
  (parameterize ([executable-yield-handler void])
    (leave-program!)
    (define before (executable-yield-handler))
    (picture 'a)
    (note-seen! 'a)
    (stay-open! 'at-end always-evt (lambda (closed) (error "waits")))
    (check-eq? (executable-yield-handler) before)))

(test-case "the end waits for the windows that are open, those at once excepted"
  (define-values (open closed) (values (make-semaphore 0) (make-semaphore 1)))
  (define waited '())
  (define ((wait name) event) (set! waited (cons name waited)))
  (define (windows)
    (set! waited '())
    (stay-open! 'at-end (semaphore-peek-evt open) (wait 'old))
    (stay-open! 'at-end (semaphore-peek-evt closed) (wait 'closed))
    (stay-open! 'at-end (semaphore-peek-evt open) (wait 'open))
    (check-equal? waited '())
    (stay-open! #f (semaphore-peek-evt open) (wait 'never))
    (stay-open! #t (semaphore-peek-evt open) (wait 'now))
    (check-equal? waited '(now)))
  (check-equal? (ended 0 (windows))
                (string-append "; the program has ended; its windows stay until they are closed, "
                               "or until Ctrl-C\n"))
  (check-equal? waited '(old open now)))

(skip-unless (not (getenv "DISPLAY")) "there is a screen, on which a frame would be shown"
  (test-case "a frame is told if something was drawn on it"
    (define (told draw)
      (ended 0 (draw (frame 0 1 0 1))))
    (check-equal? (told void) "")
    (check-regexp-match #rx"^; never shown: [(]frame .*: 1 point[)]"
                        (told (lambda (f) (plot-point f 0 0))))))
