#lang racket/base
;; Screens of a tour: forms as they are written in the file, what each answers, and the time
;; that took.  At a terminal the tour waits between screens.

(require (for-syntax racket/base
                     racket/file)
         racket/string)

(provide screens)

;; (screens print [title form ...] ...)
;; `print` shows a value; forms are definitions or expressions.
(define-syntax-rule (screens print [title form ...] ...)
  (begin (screen print title form ...) ...))

(define-syntax-rule (screen print title form ...)
  (begin (begin-screen title)
         (show print form) ...))

(define-syntax (show stx)
  (syntax-case stx ()
    [(_ print form)
     (with-syntax ([text (written-text #'form)])
       (if (definition? #'form)
           #'(begin (print-input text) form)
           #'(begin (print-input text) (print-timed print (lambda () form)))))]))

(begin-for-syntax
  (define (definition? form)
    (syntax-case form ()
      [(keyword . _) (eq? (syntax-e #'keyword) 'define)]
      [_ #f]))

  ;; The form as it stands in the file, its first line at the margin.
  (define (written-text form)
    (define text (file->string (syntax-source form)))
    (define start (sub1 (syntax-position form)))
    (define margin (make-string (syntax-column form) #\space))
    (regexp-replace* (string-append "\n" margin)
                     (substring text start (+ start (syntax-span form)))
                     "\n")))

;; ---------------------------------------------------------------------------
;; Printing

;; As typed at the prompt.
(define (print-input text)
  (printf "> ~a\n" (string-replace text "\n" "\n  ")))

(define (print-timed print thunk)
  (define start (current-inexact-milliseconds))
  (print (thunk))
  (define elapsed (- (current-inexact-milliseconds) start))
  (printf "; ~a ms\n" (if (< elapsed 10)
                          (/ (round (* 10 elapsed)) 10)
                          (inexact->exact (round elapsed)))))

;; ---------------------------------------------------------------------------
;; Waiting

(define begun? #f)

(define (begin-screen title)
  (when begun? (wait))
  (set! begun? #t)
  (printf "── ~a\n" title))

(define (wait)
  (newline)
  (when (and (terminal-port? (current-input-port)) (terminal-port? (current-output-port)))
    (printf "[Enter] the next screen, [q] enough: ")
    (flush-output)
    (define answer (read-line))
    (when (or (eof-object? answer) (regexp-match? #rx"^[qQ]" answer)) (exit 0))))
