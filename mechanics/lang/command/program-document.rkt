#lang racket/base
;; A program and its results as a document: the forms as they are written, the results of each,
;; and the comments between them as prose.

(require racket/file
         racket/list
         racket/path
         "run-program.rkt" "watch.rkt"
         "../program-file.rkt"
         "../../show/document/comments.rkt" "../../show/document/document-piece.rkt")

(provide program-document)

;; who : in whose name is complained; name : of the file, as it was given
;; -> document, and the message of the error that ended the program early, or #f
(define (program-document who file [name (path->string (file-name-from-path file))])
  (check-program who name file)
  (define text (program-text file))
  (define stx (read-whole-program who name file (open-input-string text)))
  (define o (run-program stx file))
  (define end (outcome-end o))
  (define pieces
    (append (form-pieces text (module-forms stx) o)
            (if (and end (not (early-end-number end))) (ending end) '())))
  (define-values (title others)
    (take-title pieces (path->string (file-name-from-path file))))
  (values (document title (language-line text) (joined-code others))
          (and end (early-end-message end))))

;; ---------------------------------------------------------------------------
;; Reading

;; With newlines as line ends: positions of syntax count any line end as one character.
(define (program-text file)
  (define text (bytes->string/utf-8 (file->bytes file)))
  (regexp-replace* #rx"\r\n?" (regexp-replace #rx"^\uFEFF" text "") "\n"))

(define (language-line text)
  (define m (regexp-match #px"(?m:^#lang[ \t]+([^\n]*?)[ \t]*$)" text))
  (if m (string-append "#lang " (cadr m)) "a module"))

;; ---------------------------------------------------------------------------
;; Pieces

(define (form-pieces text forms o)
  (define ends (for/list ([form (in-list forms)]) (form-end text form)))
  (define (gap start end first?)
    (define between (substring text (min start end) end))
    (if first? (without-language between) between))
  (append
   (append*
    (for/list ([form (in-list forms)] [end (in-list ends)] [before (in-list (cons 0 ends))]
               [number (in-naturals)])
      (define start (form-start form))
      (define above (gap before start (= number 0)))
      (append (gap->pieces above)
              (list (form-piece form (substring text (max start before) end) (blank-lines above)))
              (vector-ref (outcome-found o) number)
              (if (ended-at? o number) (ending (outcome-end o)) '()))))
   (gap->pieces (gap (if (null? ends) 0 (last ends)) (string-length text) (null? forms)))))

(define (ended-at? o number)
  (define end (outcome-end o))
  (and end (eqv? number (early-end-number end))))

(define (without-language gap) (regexp-replace #px"(?m:^#lang[^\n]*$)" gap ""))
(define (blank-lines gap) (if (regexp-match? #px"\n[ \t]*\n" gap) 1 0))

(define (form-start form) (- (syntax-position form) 1))

;; A comment behind a form on its line belongs to the form.
(define (form-end text form)
  (define end (+ (form-start form) (syntax-span form)))
  (define m (regexp-match-positions #px"^[ \t]*;[^\n]*" text end))
  (if m (cdar m) end))

(define (form-piece form text above)
  (define name (submodule-name form))
  (if name
      (folded (if (eq? name 'test) "Tests" (format "Submodule ~a" name)) text)
      (code text above)))

(define (submodule-name form)
  (syntax-case form ()
    [(keyword name . _)
     (and (memq (syntax-e #'keyword) '(module module* module+)) (syntax-e #'name))]
    [_ #f]))

;; The pieces where the program ended before its last form.
(define (ending end)
  (define message (early-end-message end))
  (define consequence
    (cond [(not message) "The program ended itself here; what follows was not run."]
          [(early-end-running? end) "The program stopped here; what follows was not run."]
          [else "The program could not be compiled; nothing of it was run."]))
  (map failure (filter values (list message consequence))))
