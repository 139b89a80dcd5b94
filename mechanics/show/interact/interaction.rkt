#lang racket/base
;; Interactions: a value that depends on controls, for a reader to move them.
;;
;; An interaction computes nothing when it is made.  Each host (a window, a page, a notebook) shows
;; its controls, asks for the value where they are moved to, and shows that: a value as a prompt
;; would, an exception of the body in words.  Everything that a host needs is here.

(require file/convertible
         "control.rkt" "live-result.rkt" "outcome.rkt" "outcome-picture-on-demand.rkt"
         "../../error/complain.rkt" "../../error/computed-once.rkt" "../../error/message-words.rkt"
         "../../generic/value-struct.rkt")

(provide make-interaction interaction? interaction-controls
         interaction-result interaction-outcome interaction-first
         start-values check-values)

;; body : procedure of the values of the controls, in their order; source : data, the body as it
;; is written; first : -> the outcome at the start, computed once
(value-struct interaction (controls body source first)
  #:text (lambda (i) (interaction->text i))
  #:constructor-name new-interaction
  #:omit-define-syntaxes
  #:property prop:live #t
  #:property prop:convertible
  (lambda (i request default)
    (if (eq? request 'text)
        (interaction->text i)
        (convert-outcome ((interaction-first i)) request default))))

(define (make-interaction controls body source)
  (define i
    (new-interaction controls body source
                     (once (lambda () (interaction-outcome i (start-values i))))))
  i)

(define (start-values i) (map control-start (interaction-controls i)))

;; The values of the controls for those from outside (control.rkt), in the order of the controls.
(define (check-values i given)
  (define controls (interaction-controls i))
  (unless (and (list? given) (= (length given) (length controls)))
    (complain-of-datum 'interact (format "a list of ~a" (counted (length controls) "value")) given))
  (map value-from-outside controls given))

;; ---------------------------------------------------------------------------
;; Values of the body

;; -> the value of the body; its exceptions are raised
(define (interaction-result i values)
  (call-with-values
   (lambda () (apply (interaction-body i) values))
   (case-lambda
     [(x) (cond [(void? x) (raise-nothing)]
                [(interaction? x) (raise-nested)]
                [else x])]
     [() (raise-nothing)]
     [xs (complain 'interact "the body returns ~a values, and one is shown; ~a"
                   (length xs) "(list ...) makes one of them")])))

(define (raise-nested)
  (complain 'interact "the body returns an interaction\n  ~a"
            "the controls of both stand in one: (interact ([k 1 10] [n 1 10]) body)"))

(define (raise-nothing)
  (complain 'interact "the body returns nothing to be shown\n  ~a"
            "it ends with a value, such as the frame in which it has drawn"))

;; -> the value, or a `failed` (outcome.rkt); a break is raised
(define (interaction-outcome i values)
  (outcome-of (lambda () (interaction-result i values))))

;; ---------------------------------------------------------------------------

(define (interaction->text i)
  (format "(interact (~a)~a)"
          (joined (map control-text (interaction-controls i)) " ")
          (apply string-append (map body-text (interaction-source i)))))

(define (body-text form)
  (parameterize ([print-reader-abbreviations #t]) (format " ~s" form)))
