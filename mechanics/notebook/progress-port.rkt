#lang racket/base
;; A port for lines of progress (error/progress.rkt): each is a message, which takes the place of
;; the one before.

(provide progress-port)

;; send : message -> void
(define (progress-port send)
  (make-output-port
   'progress always-evt
   (lambda (bytes start end buffered? enable-break?)
     (define text (bytes->string/utf-8 (subbytes bytes start end) #\?))
     (unless (string=? text "")
       (send (hasheq 'kind "progress" 'text (regexp-replace* #rx"\r|\e\\[K" text ""))))
     (- end start))
   void))
