#lang racket/base
;; Runs a program for a document: the output and the results of each form.
;;
;; The program runs once, as it would by itself: a module of its language, in a thread with
;; parameters of its own, so that assumptions and settings are gone afterwards.  An error ends it,
;; as it would end the program; earlier results are kept.

(require racket/path
         "watch.rkt"
         (only-in "../session-start.rkt" error->text)
         "../unknown-name/unknown-names.rkt"
         (only-in "../../error/refusal.rkt" raised?)
         "../../show/display/receiving-printer.rkt"
         "../../show/document/document-piece.rkt" "../../show/document/shown-result.rkt")

(provide run-program (struct-out outcome) (struct-out early-end))

;; found : vector of lists of outputs and results, one for each form
;; end   : early-end, or #f if it ran to its end
(struct outcome (found end))

;; number  : of the form where it ended, or #f if that is unknown
;; running?: did it run?  If not, it could not be compiled
;; message : of the error, or #f if it ended itself, by exit
(struct early-end (number running? message))

;; stx : of a module; file : where it was read -> outcome
;; shown : result -> its form in the outcome; begins : called with the number of each form
(define (run-program stx file #:shown [shown value->shown] #:begins [begins void])
  (define custodian (make-custodian))
  (define o #f)
  (dynamic-wind
   void
   (lambda ()
     (parameterize ([current-custodian custodian])
       (sync (thread (lambda () (set! o (run stx file shown begins)))))))
   (lambda () (custodian-shutdown-all custodian)))
  o)

;; ---------------------------------------------------------------------------
;; In the thread of the program

;; shown : as above; module : its name; number : of the form that runs, or #f
;; items : its outputs and results, latest first
(struct recorder (found printed shown module [number #:mutable] [items #:mutable]) #:authentic)

(define (run stx file shown form-begins)
  (define found (make-vector (length (module-forms stx)) '()))
  (define name (string->uninterned-symbol (path->string (file-name-from-path file))))
  (define r
    (recorder found (open-output-string) shown (make-resolved-module-path name) #f '()))
  (define ended
    (let/ec stop
      (define (exit-by-program code) (stop (early-end (recorder-number r) #t #f)))
      (parameterize ([exit-handler exit-by-program])
        (with-handlers ([raised? (lambda (e)
                                   (define running? (and (recorder-number r) #t))
                                   (early-end (place-of e stx r) running? (message e)))])
          (evaluate stx file r form-begins)
          #f))))
  (finish-form! r)
  (outcome (recorder-found r) ended))

(define (evaluate stx file r form-begins)
  (define printed (recorder-printed r))
  (define (receive x)
    (unless (void? x)
      (note-output! r)
      (add-item! r (result ((recorder-shown r) x)))))
  (define (begins number)
    (finish-form! r)
    (set-recorder-number! r number)
    (form-begins number))
  (define module (recorder-module r))
  (parameterize ([current-namespace (namespace-anchor->empty-namespace here)]
                 [current-load-relative-directory (path-only file)]
                 [current-command-line-arguments (vector)]
                 [current-input-port (open-input-string "")]
                 [current-output-port printed]
                 [current-error-port printed]
                 [print-as-expression #t]
                 [current-print (output-receiver receive printed)])
    (parameterize ([current-module-declare-name module]
                   [current-module-declare-source file])
      (eval (with-watched-forms stx begins)))
    (dynamic-require module #f)))

;; The program shares the library with the code that shows its results.
(define-namespace-anchor here)

;; ---------------------------------------------------------------------------
;; Recording

(define (add-item! r item) (set-recorder-items! r (cons item (recorder-items r))))

(define (note-output! r)
  (define port (recorder-printed r))
  (define text (get-output-string port))
  (unless (string=? text "")
    (get-output-bytes port #t)          ; empties it
    (add-item! r (output text))))

;; Output before the first form belongs to that form.
(define (finish-form! r)
  (note-output! r)
  (define found (recorder-found r))
  (when (positive? (vector-length found))
    (define n (or (recorder-number r) 0))
    (vector-set! found n (append (vector-ref found n) (reverse (recorder-items r))))
    (set-recorder-items! r '())))

;; ---------------------------------------------------------------------------
;; Errors

;; The message as it is printed where a program is run, with its hints.
(define (message e)
  (parameterize ([error-display-handler (error-display-handler)]
                 [error-print-source-location #f])
    (install-hints!)
    (error->text e "raised, though it is no error: ~v")))

;; The number of the form that was running; in a program that could not be compiled, of the form
;; that the error names, or #f.
(define (place-of e stx r)
  (or (recorder-number r)
      (and (exn:srclocs? e)
           (for*/or ([place (in-list ((exn:srclocs-accessor e) e))])
             (form-around place (module-forms stx))))))

(define (form-around place forms)
  (define at (srcloc-position place))
  (and at
       (for/or ([form (in-list forms)] [number (in-naturals)])
         (define start (syntax-position form))
         (and start (<= start at) (< at (+ start (syntax-span form))) number))))
