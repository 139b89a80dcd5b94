#lang racket/base
;; The example of a card, run when the card is shown, at a prompt like those of the manual:
;; the language, its printer, and no definitions.  So no table of results can be out of date.
;; Most examples take a few milliseconds, and a break ends one that takes longer.

(require (only-in racket/list append*)
         (only-in racket/string string-split)
         "card.rkt"
         "../../generic/on-demand.rkt" "../../generic/own-thread.rkt"
         "../../show/display/result.rkt"
         "../../show/interact/live-result.rkt")

(require-on-demand ["../../show/interact/interaction-show.rkt" printed-interaction])

(provide (struct-out answer) demonstrate result-line)

;; typed : text; printed : list of lines, each a text or a value of result-line
(struct answer (typed printed))

;; value, columns -> its text, or whatever stands for it where the card is shown
(define result-line
  (make-parameter (lambda (x width) (format "~v" (simplified-result x width)))))

;; -> answers
;; The thread keeps declarations and settings of the example.
(define (demonstrate e width)
  (define space (fresh-prompt (example-libraries e)))
  (call-in-own-thread
   (lambda ()
     ;; Files that an example writes are none of the reader's.
     (parameterize ([current-namespace space]
                    [current-directory (find-system-path 'temp-dir)])
       (eval '(forget-assumptions))
       (for ([d (in-list (example-definitions e))]) (eval (read-form d)))
       (for/list ([typed (in-list (example-expressions e))]
                  [run (in-list (example-run e))])
         (answer typed (printed (read-form run) width)))))))

;; A namespace that shares the loaded modules.  Breaks wait while others are being loaded.
(define (fresh-prompt libraries)
  (define space (variable-reference->empty-namespace (#%variable-reference)))
  (parameterize ([current-namespace space])
    (parameterize-break #f
      (for-each namespace-require (cons 'mechanics libraries))))
  space)

(define (read-form text) (read (open-input-string text)))

;; The output of the evaluation, and its values; of an example that fails, the message.
(define (printed form width)
  (define out (open-output-string))
  (define results
    (parameterize ([current-output-port out])
      (with-handlers ([exn:fail? (lambda (e) (display (exn-message e)) '())])
        (call-with-values (lambda () (eval form))
                          (lambda results
                            (for/list ([x (in-list results)] #:unless (void? x))
                              ((result-line) (still x) width)))))))
  (append* (lines (get-output-string out))
           (for/list ([r (in-list results)]) (if (string? r) (lines r) (list r)))))

(define (lines text) (string-split text "\n"))

;; An interaction is shown as it is at first.
(define (still x)
  (cond [(live? x)
         (define-values (value remark) (printed-interaction x #f #f))
         value]
        [else x]))
