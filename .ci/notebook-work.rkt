#lang racket/base
;; One notebook made and judged, for notebooks.rkt:
;;
;;     racket notebook-work.rkt program|worksheet|page source notebook [cell that fails ...]
;;
;; The status is 1 where a notebook does not show what it should.

(require racket/file
         racket/list
         racket/match
         racket/path
         racket/string
         mechanics/lang/command/load-worksheet mechanics/lang/command/run-program
         mechanics/lang/program-file
         mechanics/notebook/changed-pictures mechanics/notebook/run-cells
         mechanics/show/document/document-piece
         mechanics/show/notebook/notebook-file mechanics/show/notebook/program-cells
         mechanics/teaching/worksheet/student-notebook)

(provide program-notebook page-notebook)

;; file : of a program -> its notebook, and how its results differ from the program's, or #f
(define (program-notebook file)
  (define-values (header cells) (program->cells 'notebook (file->bytes file)))
  (define-values (outputs failed)
    (parameterize ([current-directory (path-only file)]) (run-cells cells)))
  (values (notebook->bytes header cells outputs)
          (difference (program-lines file) (lines (append-map output-texts outputs)))))

;; lines -> text or #f.  A notebook shows the frames that a cell drew in, too.
(define (difference of-program of-notebook)
  (match* (of-program of-notebook)
    [('() '()) #f]
    [((cons x more) (cons x others)) (difference more others)]
    [(_ (cons (regexp #rx"^[(]frame ") others)) (difference of-program others)]
    [(_ _) (format "the program gives  ~s\n  the notebook  ~s"
                   (string-join (take-at-most of-program 3) "\n")
                   (string-join (take-at-most of-notebook 3) "\n"))]))

(define (take-at-most l n) (take l (min n (length l))))

;; ---------------------------------------------------------------------------
;; Results as lines of text

;; Notes of a session, on definitions that hide others for example, are no results.
(define (lines texts)
  (filter (lambda (l) (not (regexp-match? #rx"^; |^$" l)))
          (string-split (string-join texts "\n") "\n")))

(define (output-texts outputs)
  (for/list ([o (in-list outputs)])
    (match (hash-ref o 'output_type)
      ["stream" (hash-ref o 'text)]
      ["error" (hash-ref o 'evalue)]
      [_ (data-text (hash-ref o 'data))])))

(define (data-text data) (hash-ref data (string->symbol "text/plain")))

(define (program-lines file)
  (define name (path->string file))
  (define text (regexp-replace* #rx"\r\n?" (file->string file) "\n"))
  (define stx (read-whole-program 'notebook name file (open-input-string text)))
  (define pictures (make-changed-pictures))
  (define (shown x) (data-text (hash-ref (result-message pictures x #f) 'data)))
  (define o (run-program stx file #:shown shown))
  (define end (outcome-end o))
  (lines (append (for*/list ([items (in-vector (outcome-found o))] [x (in-list items)])
                   (if (output? x) (output-text x) (result-shown x)))
                 (if end (list (or (early-end-message end) "it ends itself")) '()))))

;; ---------------------------------------------------------------------------
;; Worksheets and pages

(define (worksheet-notebook file)
  (define failed #f)
  (define (run cells)
    (define-values (outputs why) (run-cells cells))
    (set! failed why)
    outputs)
  (values (worksheet->student-notebook (load-worksheet 'notebook file) run)
          (and failed "a cell fails")))

;; failing : numbers of the cells that are to fail
(define (page-notebook file failing)
  (define-values (header cells) (bytes->notebook 'notebook "it" (file->bytes file)))
  (define-values (outputs failed) (run-cells cells #:on? #t))
  (define wrong
    (for/list ([o (in-list outputs)] [c (in-list cells)] [k (in-naturals)]
               #:unless (eq? (and (member k failing) #t) (fails? o)))
      (format "  ~a\n  ~a" (cell-source c) (string-join (output-texts o) "\n"))))
  (values (notebook->bytes header cells outputs)
          (and (pair? wrong)
               (string-append "these cells fail, or should and do not\n"
                              (string-join wrong "\n")))))

(define (fails? outputs)
  (ormap (lambda (o) (equal? "error" (hash-ref o 'output_type))) outputs))

;; ---------------------------------------------------------------------------

(module+ main
  (define-values (kind source to failing)
    (match (vector->list (current-command-line-arguments))
      [(list kind source to failing ...)
       (values kind (string->path source) to (map string->number failing))]))
  (define-values (notebook problem)
    (case kind
      [("program") (program-notebook source)]
      [("worksheet") (worksheet-notebook source)]
      [("page") (page-notebook source failing)]))
  (call-with-output-file to #:exists 'truncate (lambda (out) (void (write-bytes notebook out))))
  (when problem
    (eprintf "~a\n" problem)
    ;; to be made again
    (file-or-directory-modify-seconds to 0)
    (exit 1)))
