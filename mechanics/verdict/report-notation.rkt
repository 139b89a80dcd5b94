#lang racket/base
;; The lines of a report (report.rkt) as they are typeset: sides of equations stay together,
;; and commas behind what they follow.

(require "../generic/notation.rkt")

(provide report-notation)

;; lines : (depth label content), content a list of strings and data, or #f
(define (report-notation lines)
  (apply statement
         (for/list ([l (in-list lines)])
           (list* (car l) (cadr l) (parts (or (caddr l) '()))))))

(define (parts content)
  (cond [(null? content) '()]
        [(relation-first? content)
         (with-comma (tree:relation (part (car content)) (cadr content) (part (caddr content)))
                     (cdddr content))]
        [else (with-comma (part (car content)) (cdr content))]))

(define (with-comma tree rest)
  (if (and (pair? rest) (equal? "," (car rest)))
      (cons (tree:row (list tree (tree:word ","))) (parts (cdr rest)))
      (cons tree (parts rest))))

(define (relation-first? content)
  (and (pair? (cdr content)) (pair? (cddr content)) (member (cadr content) '("=" "<" ">" "≤" "≥"))))

(define (part x) (if (string? x) (tree:word x) (tree:datum x)))
