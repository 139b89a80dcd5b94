#lang racket/base
;; A value as a result is shown: simplified, unless another form was asked for, in
;; the book's notation.
;;
;; What is ours becomes text that prints as itself; what is not (strings, lists,
;; pictures) stays as it is for Racket to print, its elements simplified.

(require (only-in racket/list remove-duplicates)
         "text.rkt"
         "../algebra/expression/expression.rkt"
         "../generic/kind.rkt" "../generic/value-struct.rkt"
         "../value/simplify.rkt"
         "../verdict/verdict.rkt")

(provide simplified-result plain-result)

;; What to print in place of x; ours takes lines of at most `width` columns.
;; The elements of a list or vector are simplified though Racket prints it.
(define (simplified-result x width)
  (cond [(in-notation? x)
         (define-values (shown assumptions) (as-shown x))
         (laid-out (value->lines shown width assumptions))]
        [(and (list? x) (ormap ours? x) (textual? x)) (list-result x width)]
        [else
         (define-values (shown assumptions) (simplified-elements x width))
         (if (and (pair? assumptions) (textual? x))
             (laid-out (with-notes (format "~v" shown) assumptions))
             shown)]))

;; Each element of a list begins a line if one is told in words, as a verdict is, so that
;; nothing else would part it from the next; and if together they are too long for a line.
;; What was taken for granted is told beneath.
(define (list-result xs width)
  (define-values (row assumptions)
    (if (ormap in-words? xs) (values #f '()) (simplified-elements xs width)))
  (define text (and row (format "~v" row)))
  (cond [(or (not row) (> (string-length text) width)) (laid-out (stacked xs width))]
        [(null? assumptions) row]
        [else (laid-out (with-notes text assumptions))]))

(define (in-words? x)
  (or (verdict? x)
      (and (ours? x) (regexp-match? #rx"^[^(\"]* " (format "~v" x)))))

(define (stacked xs width)
  (define indentation "      ")
  (define (text x)
    (define result (simplified-result x (- width (string-length indentation))))
    (regexp-replace* #rx"\n" (format "~v" result) (string-append "\n" indentation)))
  (string-append
   "(list " (text (car xs))
   (apply string-append
          (for/list ([x (in-list (cdr xs))]) (string-append "\n" indentation (text x))))
   ")"))

;; Nothing that an editor would show as more than text.
(define (textual? x)
  (or (ours? x) (number? x) (string? x) (boolean? x)
      (and (list? x) (andmap textual? x))
      (and (vector? x) (andmap textual? (vector->list x)))))

;; -> the same with its elements simplified, and what that took for granted
(define (simplified-elements x width)
  (define assumptions '())
  (define (simplified-element e)
    (define-values (shown grounds)
      (cond [(unprintable? e) (values (laid-out (value->lines e width)) '())]
            [(in-notation? e) (as-shown e)]
            [else (simplified-elements e width)]))
    (set! assumptions (append assumptions grounds))
    shown)
  (define shown
    (cond [(list? x) (map simplified-element x)]
          [(vector? x) (list->vector (map simplified-element (vector->list x)))]
          [else x]))
  (values shown (remove-duplicates assumptions)))

;; The same without simplification.
(define (plain-result x width)
  (if (in-notation? x) (laid-out (value->lines x width)) x))

;; Text that prints as itself in all of Racket's modes.
(value-struct laid-out (text)
  #:text laid-out-text)

;; Is x written by us?  Numbers are not: they look the same either way.
(define (in-notation? x)
  (or (symbolic? x)
      (has-kind? x)
      (verdict? x)
      (unprintable? x)))

;; The rest of what we write, such as equilibria and trajectories, which is not simplified:
;; it prints itself, and is never a part of quoted data.
(define (ours? x)
  (or (in-notation? x)
      (and (custom-write? x) (custom-print-quotable? x)
           (eq? 'never (custom-print-quotable-accessor x)))))

;; A procedure that Racket would print as #<procedure:its-name>.
(define (unprintable? x)
  (and (procedure? x) (not (custom-write? x))))
