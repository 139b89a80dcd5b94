#lang racket/base
;; A value as a result is shown: simplified, unless another form was asked for, in
;; the book's notation, as an S-expression or in the style that is wanted.
;;
;; Our values become text that prints as itself, or a picture; others (strings, lists,
;; pictures) stay as they are for Racket to print, their elements simplified.

(require "picture-advice.rkt" "waiting-remark.rkt" "result-lines.rkt"
         "../../algebra/expression/expression.rkt"
         "../../generic/cyclic-data.rkt" "../../generic/irrational.rkt" "../../generic/kind.rkt"
         "../../generic/notation.rkt" "../../generic/on-demand.rkt"
         "../../generic/value-struct.rkt"
         "../../value/simplify.rkt"
         "../../verdict/verdict.rkt"
         (only-in racket/list append* remove-duplicates))

(require-on-demand ["styled-result.rkt" styled-result])

(provide simplified-result plain-result unprintable?
         ;; for documents
         shown-throughout seen-once)

;; The value to print in place of x; of ours in lines of at most `width` columns.  manner : one of
;; those of manner-here (display-style.rkt); a special (print-shown.rkt) where that is 'snip
;; Cyclic data are left to Racket.
;; see : as seen-once gives it, where others show x as well
(define (simplified-result x width [manner 'expression] [see (seen-once)])
  (cond [(cyclic? x) x]
        [(and (eq? manner 'expression) (decimal-of x))
         => (lambda (d) (laid-out (format "~v  ; ~a" (expression-result x width see) d)))]
        [(or (eq? manner 'expression) (not (formula? x))) (expression-result x width see)]
        [else (typeset-result x width manner see)]))

;; Of an exact irrational number, or an expression that is one: told beside it.
(define (decimal-of x)
  (define n (constant->number x))
  (and (irrational? n) (irrational-as-decimal n)))

(define (typeset-result x width manner see)
  (define-values (shown notes) (shown-throughout x see))
  (call-announced
   "typesetting the result ..."
   (lambda ()
     (styled-result shown notes width manner
                    (lambda () (result-text x width see))
                    laid-out))))

;; The result as an S-expression.  Racket prints a list or vector; its elements are simplified.
(define (expression-result x width see)
  (cond [(in-notation? x)
         (define s (see x))
         (laid-out (value->lines (seen-value s) width (seen-notes s)))]
        [(and (list? x) (ormap ours? x) (textual? x)) (list-result x width see)]
        [else (noted-result x width see)]))

;; Assumptions made within x are told beneath its form, if that is text.
(define (noted-result x width see)
  (define-values (shown notes) (shown-throughout x see width))
  (if (or (null? notes) (not (textual? x)))
      shown
      (laid-out (with-notes (format "~v" shown) notes))))

;; -> the text with its remarks, and without them
(define (result-text x width see)
  (define text (format "~v" (expression-result x width see)))
  (values text
          (if (in-notation? x) (value->lines (seen-value (see x)) width) text)))

;; ---------------------------------------------------------------------------
;; Simplified, each value once

(struct seen (value notes) #:authentic)

;; -> a function from a value in our notation to its `seen`, computed once
(define (seen-once)
  (define known (make-hasheq))
  (lambda (x)
    (define (look)
      (define-values (shown notes) (as-shown x))
      (seen shown notes))
    (hash-ref! known x look)))

;; -> the value with all elements simplified, and the notes of all.  Where there is a width,
;; procedures that Racket would print by their names alone are laid out.
(define (shown-throughout x [see (seen-once)] [width #f])
  (define (each xs)
    (define-values (elements notes)
      (for/lists (elements notes) ([e (in-list xs)]) (shown-throughout e see width)))
    (values elements (remove-duplicates (append* notes))))
  (cond [(and width (unprintable? x)) (values (laid-out (value->lines x width)) '())]
        [(in-notation? x)
         (define s (see x))
         (values (seen-value s) (seen-notes s))]
        [(list? x) (each x)]
        [(vector? x)
         (define-values (elements notes) (each (vector->list x)))
         (values (list->vector elements) notes)]
        [else (values x '())]))

;; Is x typeset where other styles are wanted?  What has a picture of its own is not.
(define (formula? x)
  (or (in-notation? x)
      (and (has-notation? x) (not (advice x)))
      (and (list? x) (ormap ours? x) (textual? x) (not (ormap advice x)))))

;; ---------------------------------------------------------------------------
;; Lists

;; Each element of a list begins a line if one is told in words, as a verdict is, so that
;; nothing else would part it from the next; and if together they are too long for a line.
(define (list-result xs width see)
  (define (in-a-row?)
    (define-values (row notes) (shown-throughout xs see width))
    (<= (string-length (format "~v" row)) width))
  (if (and (not (ormap in-words? xs)) (in-a-row?))
      (noted-result xs width see)
      (laid-out (stacked xs width see))))

(define (in-words? x)
  (or (verdict? x)
      (and (ours? x) (regexp-match? #rx"^[^(\"]* " (format "~v" x)))))

(define (stacked xs width see)
  (define indentation "      ")
  (define (text x)
    (define result (expression-result x (- width (string-length indentation)) see))
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

;; ---------------------------------------------------------------------------

;; The same without simplification.
(define (plain-result x width)
  (if (and (in-notation? x) (not (cyclic? x))) (laid-out (value->lines x width)) x))

;; Text that prints as itself in all of Racket's modes.
(value-struct laid-out (text)
  #:text laid-out-text)

;; Is x written by us?  Numbers are not: they look the same either way.
(define (in-notation? x)
  (or (symbolic? x)
      (has-kind? x)
      (verdict? x)
      (unprintable? x)))

;; The rest of our values, such as equilibria and trajectories, which is not simplified:
;; it prints itself, and is never a part of quoted data.
(define (ours? x)
  (or (in-notation? x)
      (and (custom-write? x) (custom-print-quotable? x)
           (eq? 'never (custom-print-quotable-accessor x)))))

;; A procedure that Racket would print as #<procedure:its-name>.
(define (unprintable? x)
  (and (procedure? x) (not (custom-write? x))))
