#lang racket/base
;; Any value of ours as lines of text: expressions laid out, verdicts as their
;; reports.

(require "layout.rkt"
         "../algebra/datum.rkt" "../generic/describe.rkt" "../calculus/verdict.rkt")

(provide value->lines note->text)

;; The text of a value; beneath it, as comments, what its simplification took
;; for granted and what it left unexpanded.
;; value->lines : value width [list-of-notes] -> string
(define (value->lines x width [notes '()])
  (apply string-append
         (if (verdict? x)
             (layout-report (verdict-lines x) width)
             (layout (value->datum x) width))
         (for/list ([n (in-list notes)])
           (string-append "\n" (note->text n)))))

(define (note->text n)
  (if (eq? (car n) 'left-unexpanded)
      (format "; left unexpanded: ~a" (datum->brief-text (cadr n)))
      (format "; assuming ~a" (value->text n))))

;; The lines of a report, each a label and its content.
(define (layout-report report width)
  (for/fold ([text ""]) ([line (in-list report)])
    (define label (string-append (make-string (* 2 (car line)) #\space) (cadr line)))
    (string-append text
                   (if (string=? text "") "" "\n")
                   label
                   (layout-content (or (caddr line) '()) (string-length label) width))))

;; Parts one after the other; one that does not fit begins a line of its own,
;; except the first, which is broken where it stands.
(define (layout-content parts column width)
  (define start (+ column 1))
  (let loop ([parts parts] [at column] [first? #t] [pieces '()])
    (cond
      [(null? parts) (apply string-append (reverse pieces))]
      [else
       (define comma? (equal? (car parts) ","))
       (define text
         (if (string? (car parts)) (car parts) (layout (car parts) width (if first? start at))))
       (define end (+ at 1 (string-length text)))
       (cond [comma? (loop (cdr parts) (+ at 1) #f (cons "," pieces))]
             [(or first? (<= end width))
              (loop (cdr parts) end #f (list* text " " pieces))]
             [else
              (loop (cdr parts) (+ start (string-length text)) #f
                    (list* text (make-string start #\space) "\n" pieces))])])))
