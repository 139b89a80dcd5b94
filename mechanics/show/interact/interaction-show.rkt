#lang racket/base
;; Interactions on the screen, where there is one.  The window and the libraries for it are loaded
;; when the first is opened.

(require "control.rkt" "interaction.rkt"
         "../plot/window-screen.rkt"
         "../../error/message-words.rkt"
         "../../generic/describe.rkt" "../../generic/define-plain.rkt" "../../generic/on-demand.rkt"
         "../../generic/wrong-argument.rkt")

(require-on-demand #:in-this-thread
                   ["interaction-window.rkt" loaded? open-interaction-window wait-until-closed])

(provide interaction-show printed-interaction
         ;; for tests: -> the session
         interaction-window stay-until-closed)

;; wait? : until the reader closes the window
(define-plain (interaction-show i #:wait? [wait? #f])
  (define session (interaction-window i))
  (when wait? (wait-until-closed session)))

(define (interaction-window i)
  (define who 'interaction-show)
  (check-argument who interaction? i "an interaction, such as (interact ([k 1 10]) k)")
  (check-screen who loaded? "raco mechanics show FILE" "a page with its sliders is made by ")
  (open-interaction-window i (joined (map name-of (interaction-controls i)))))

(define (name-of c) (symbol->string (control-name c)))

;; ---------------------------------------------------------------------------
;; As a result

;; screen? : may windows be opened?  stay? : does a program that ends wait for them?
;; -> a value to be printed in place of i, and a remark beneath it, or #f
(define (printed-interaction i screen? stay?)
  (define session (and screen? (with-handlers ([exn:fail:unsupported? (lambda (e) #f)])
                                 (interaction-window i))))
  (cond [session
         (when stay? (stay-until-closed session))
         (values (words (value->text i)) #f)]
        [else (values ((interaction-first i)) (remark i))]))

;; The text is printed as it is, and never typeset.
(struct words (text)
  #:property prop:custom-print-quotable 'never
  #:property prop:custom-write (lambda (w port mode) (write-string (words-text w) port)))

(define (remark i)
  (format "at ~a; controls: ~a"
          (joined (for/list ([c (in-list (interaction-controls i))])
                    (format "~a = ~a" (name-of c) (value->label (control-start c)))))
          "in a window, with a display; on a page, by raco mechanics show"))

;; The program ends when its windows are closed.
(define (stay-until-closed session)
  (define before (executable-yield-handler))
  (executable-yield-handler
   (lambda (status)
     (wait-until-closed session)
     (before status))))
