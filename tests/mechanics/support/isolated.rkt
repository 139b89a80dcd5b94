#lang racket/base
;; The output of a program where submissions run, without a sandbox of Racket's around it.

(require mechanics/teaching/class/isolation
         racket/port
         "skip.rkt")

(provide isolated                 ; (isolated i form library ...) -> string
         call-with-namespaces)    ; (call-with-namespaces test) : (test i), or a skip

(define (isolated i form . libraries)
  (define arguments
    (append '("-l" "racket/base")
            (apply append (for/list ([l (in-list libraries)]) (list "-l" l)))
            (list "-e" (format "~s" form))))
  (define-values (process out in err) (start-isolated i arguments))
  (close-output-port in)
  (begin0 (port->string out)
          (close-input-port out)
          (close-input-port err)
          (subprocess-wait process)))

(define (call-with-namespaces test)
  (call-with-isolation
   512 30
   (lambda (i)
     (skip-unless (isolation-complete? i)
                  "no namespaces for submissions here: unshare, setpriv and prlimit are needed"
       (test i)))))
