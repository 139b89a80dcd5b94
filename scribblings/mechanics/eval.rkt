#lang racket/base
;; The prompts that the manual's examples run at.

(require racket/sandbox scribble/example)

(provide examples make-session make-racket-session close-session)

;; Columns of a page of the manual that a result may fill.
(define page-columns 66)

;; A prompt of `#lang mechanics`, which prints as the prompt of a reader does.
(define (make-session . forms)
  (define session (apply make-base-eval #:lang 'mechanics #:pretty-print? #f forms))
  (call-in-sandbox-context
   session
   (lambda ()
     ((dynamic-require 'racket/pretty 'pretty-print-columns) page-columns)
     ((dynamic-require 'mechanics/lang/printer 'install-printer!))))
  session)

;; A prompt of plain Racket: what happens where `mechanics` was forgotten.
(define (make-racket-session)
  (make-base-eval #:lang 'racket/base #:pretty-print? #f))

(define close-session close-eval)
