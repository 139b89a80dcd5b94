#lang racket/base
;; Any value of ours as lines of text: expressions laid out, verdicts as their
;; reports.

(require "layout.rkt" "result-note.rkt"
         "../../generic/describe.rkt"
         "../../verdict/verdict.rkt")

(provide value->lines with-notes)

;; The text of a value; beneath it, as comments, assumptions of its simplification
;; and parts left unexpanded.
;; value->lines : value width [list-of-notes] -> string
(define (value->lines x width [notes '()])
  (with-notes (if (verdict? x)
                  (layout-report (verdict-lines x) width)
                  (layout (value->datum x) width))
              notes))

(define (with-notes text notes)
  (apply string-append text
         (for/list ([n (in-list notes)]) (string-append "\n" (note->text n)))))

;; The lines of a report, each a label and its content.
(define (layout-report report width)
  (for/fold ([text ""]) ([line (in-list report)])
    (define label (string-append (make-string (* 2 (car line)) #\space) (cadr line)))
    (string-append text
                   (if (string=? text "") "" "\n")
                   label
                   (layout-content (or (caddr line) '()) (string-length label) width))))

;; Puts parts one after the other; a part that does not fit begins a line of its own, but the first
;; is broken where it stands.  The sides of an equation stay together.
(define (layout-content parts column width)
  (define start (+ column 1))
  (let loop ([parts parts] [at column] [stays? #t] [pieces '()])
    (cond
      [(null? parts) (apply string-append (reverse pieces))]
      [(equal? (car parts) ",") (loop (cdr parts) (+ at 1) #f (cons "," pieces))]
      [else
       (define here? (or stays? (<= (+ at 1 (width-together parts)) width)))
       (define from (if here? (+ at 1) start))
       (define text (part->text (car parts) width from))
       (define lead (if here? " " (string-append "\n" (make-string start #\space))))
       (loop (cdr parts) (end-column text from) (within-equation? parts)
             (list* text lead pieces))])))

(define (part->text part width column)
  (if (string? part) part (layout part width column)))

;; Do the parts behind the first belong to the same equation?
(define (within-equation? parts)
  (or (equal? (car parts) "=") (equation-first? parts)))

(define (equation-first? parts)
  (and (pair? (cdr parts)) (equal? (cadr parts) "=")))

;; The width on one line of the first part, or of the equation that it begins, with the comma
;; that may follow.
(define (width-together parts)
  (define (flat part) (string-length (part->text part +inf.0 0)))
  (define (with-comma width rest)
    (if (and (pair? rest) (equal? (car rest) ",")) (+ width 1) width))
  (if (equation-first? parts)
      (with-comma (+ (flat (car parts)) 3 (flat (caddr parts))) (cdddr parts))
      (with-comma (flat (car parts)) (cdr parts))))

(define (end-column text from)
  (define last-line (regexp-match #rx"\n([^\n]*)$" text))
  (if last-line (string-length (cadr last-line)) (+ from (string-length text))))
