#lang racket/base
;; Racket at a terminal: a pseudo-terminal that the program `script` of util-linux opens,
;; which reads from us what somebody would type.  A test waits for what it expects to see.

(require compiler/find-exe
         racket/port
         racket/string
         racket/system
         "checks.rkt" "patience.rkt")

(provide terminals? libedit?
         call-at-terminal    ; (call-at-terminal arguments home f) : (f terminal)
         type                ; (type terminal text) : as typed, with \r for Enter
         shows               ; (shows terminal regexp) : a check, of what came since the last
         close-terminal)     ; (close-terminal terminal) : as one closes its window

(require (only-in ffi/unsafe ffi-lib))

;; `script` may be there, and no pseudo-terminal for it.
(define (terminals?)
  (define script (and (eq? (system-type) 'unix) (find-executable-path "script")))
  (and script
       (parameterize ([current-input-port (open-input-bytes #"")]
                      [current-output-port (open-output-nowhere)]
                      [current-error-port (open-output-nowhere)])
         (system* script "-qfc" "true" "/dev/null"))))

(define (libedit?)
  (and (ffi-lib "libedit" '("3" "2" "0" "") #:fail (lambda () #f)) #t))

;; process : the program `script`; keys : where we write; seen : what was printed and not yet
;; expected
(struct terminal (process keys screen [seen #:mutable]))

;; home : folder in which the session keeps what it keeps; kind : of terminal
(define (call-at-terminal arguments home f #:kind [kind "xterm"])
  (define custodian (make-custodian))
  (dynamic-wind
   void
   (lambda ()
     (parameterize ([current-custodian custodian]
                    [current-subprocess-custodian-mode 'kill]
                    [current-environment-variables (settings home kind)])
       (define-values (process screen keys errors)
         (subprocess #f #f #f (find-executable-path "script")
                     "-qfc" (command arguments) "/dev/null"))
       (f (terminal process keys screen ""))))
   (lambda () (custodian-shutdown-all custodian))))

(define (command arguments)
  (format "stty rows 24 cols 80; exec ~a" (string-join (map quoted (cons (find-exe) arguments)))))

(define (quoted x)
  (format "'~a'" (string-replace (if (path? x) (path->string x) x) "'" "'\\''")))

(define (settings home kind)
  (define e (environment-variables-copy (current-environment-variables)))
  (for ([setting (list (cons #"HOME" (path->bytes home))
                       (cons #"PLTUSERHOME" (path->bytes home))
                       (cons #"SHELL" #"/bin/sh")
                       (cons #"LC_ALL" #"C.UTF-8")
                       (cons #"TERM" (string->bytes/utf-8 kind)))])
    (environment-variables-set! e (car setting) (cdr setting)))
  e)

(define (type t text)
  (write-string text (terminal-keys t))
  (flush-output (terminal-keys t)))

;; The program there is told that its terminal is gone.
(define (close-terminal t)
  (subprocess-kill (terminal-process t) #t)
  (subprocess-wait (terminal-process t)))

;; Waits until the pattern is seen, and takes what is up to its end as read.
(define-check (shows t pattern)
  (let wait ()
    (define found (regexp-match-positions pattern (terminal-seen t)))
    (cond [found (set-terminal-seen! t (substring (terminal-seen t) (cdar found)))]
          [(more t) (wait)]
          [else (with-check-info (['pattern pattern] ['seen (terminal-seen t)]) (fail-check))])))

;; Adds what is printed next, if anything is.
(define (more t)
  (define buffer (make-bytes 4096))
  (define n (sync/patience 60 (read-bytes-avail!-evt buffer (terminal-screen t))))
  (and (exact-positive-integer? n)
       (let ([text (bytes->string/utf-8 (subbytes buffer 0 n) #\?)])
         (set-terminal-seen! t (string-append (terminal-seen t) (string-replace text "\r" "")))
         #t)))
