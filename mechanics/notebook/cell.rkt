#lang racket/base
;; A cell: lines of a session, which are evaluated as a prompt evaluates them, with its commands,
;; hints and notes.
;;
;; A cell of which a part cannot be read evaluates nothing.  Where a form fails, the values before
;; it have been shown, and the failure names its line.

(require "../error/complain.rkt"
         "../lang/prompt/lines.rkt" "../lang/prompt/session-entry.rkt"
         "../lang/prompt/typed-forms.rkt"
         "../lang/session-start.rkt")

(provide evaluate-cell cell-completeness end-in-menu told
         (struct-out failure))

;; message : in the session's words; line : of the form that failed, or #f where all of the cell
;; was refused; interrupted? : by a break
(struct failure (message line interrupted?))

;; Values go to the current printer -> #f, or a failure
(define (evaluate-cell text)
  (define line #f)
  (define (note-line! form) (set! line (or (syntax-line form) line)))
  (with-handlers* ([exn:break? (lambda (e) (failure "interrupted" line #t))]
                   [(lambda (e) #t) (lambda (e) (failure (told e) line #f))])
    (define entries (read-entries text))
    (for* ([e (in-list entries)] [form (in-list (forms-of e))])
      (note-line! form)
      (evaluate form))
    #f))

;; At a prompt end of file leaves the session; a notebook has a menu for that.
(define (forms-of e)
  (define forms (entry-forms e))
  (if (eof-object? forms)
      (complain 'cell end-in-menu)
      forms))

(define end-in-menu "a notebook is left by closing it, and its kernel ended in the menu Kernel")

(define (evaluate form)
  (check-kind form)
  (unless (eq? (head-of form) 'provide) (evaluate-at-prompt form)))

(define (evaluate-at-prompt form)
  (call-with-continuation-prompt
   (lambda ()
     (call-with-values
      (lambda ()
        ((current-eval)
         (namespace-syntax-introduce (datum->syntax #f (cons '#%top-interaction form) form))))
      (lambda results (for-each (current-print) results))))
   (default-continuation-prompt-tag)
   (lambda (thunk) (thunk))))

;; ---------------------------------------------------------------------------
;; Reading

(define (read-entries text)
  (define lines (cell-lines text))
  (let loop ()
    (define e (read-entry lines))
    (if (eof-object? e) '() (cons e (loop)))))

;; -> line-source
(define (cell-lines text)
  (define rest (regexp-split #rx"\r\n|\n|\r" text))
  (define number 1)
  (define (next prompt)
    (cond [(null? rest) eof]
          [else
           (define line (car rest))
           (when (regexp-match? #px"^#lang\\b" line) (refuse-language))
           (set! rest (cdr rest))
           (set! number (add1 number))
           line]))
  (define (ahead k) (for/list ([line (in-list rest)] [_ (in-range k)]) line))
  (line-source next void 'cell (lambda () number) ahead))

(define (refuse-language)
  (complain 'cell
            (string-append "a notebook has one language, this one; leave the line #lang out\n"
                           "  a program of another language is a file: (require \"file.rkt\")")))

;; Submodules are parts of a file.  So is `provide`, which does no harm where it is left out.
(define (check-kind form)
  (define head (head-of form))
  (when (memq head '(module module* module+))
    (complain 'cell "(~a ...) is part of a file; in a cell its forms stand by themselves" head)))

(define (head-of form) (and (pair? (syntax-e form)) (syntax->datum (car (syntax-e form)))))

;; -> "complete", "incomplete" or "invalid", as the front end asks when Return is pressed
(define (cell-completeness text)
  (with-handlers ([exn:fail:read:eof? (lambda (e) "incomplete")]
                  [exn:fail? (lambda (e) "invalid")])
    ;; a question may not load modules that a text names
    (forms-in text #:reader? #f)
    "complete"))

;; x : raised -> the text that a prompt would print
(define (told x) (error->text x "uncaught: ~e"))
