#lang racket/base
;; The lines by which the process of a submission tells its answers to the teacher's:
;;
;;   (name answer datum)   (name text 72 101 ...)   (name failed 72 101 ...)   (name unanswered)
;;
;; They hold only names, numbers and parentheses; a text is the numbers of its characters.  Their
;; writer may wish us ill: so they are inspected before they are read, for syntax of the reader and
;; for numbers that would take forever to be made.

(require "../worksheet/answer-data.rkt" "../worksheet/read-untrusted.rkt")

(provide write-line-of read-answer-lines ready-line)

;; The first line, once the process has loaded the library.
(define ready-line #"(*ready* unanswered)\n")

;; d : an answer as answer->datum gives it
(define (write-line-of name d out)
  (write (list* name (car d)
                (if (memq (car d) '(text failed)) (text->codes (cadr d)) (cdr d)))
         out)
  (newline out))

(define (text->codes text)
  (for/list ([c (in-string text)] [_ (in-range longest-text)]) (char->integer c)))

;; text -> hasheq of answers by their names; the first line of each counts
(define (read-answer-lines text)
  (for*/fold ([found (hasheq)])
             ([line (in-list (regexp-split #rx"\n" text))]
              [entry (in-value (read-line-safely line))]
              #:when (and entry (not (hash-has-key? found (car entry)))))
    (hash-set found (car entry) (cdr entry))))

;; -> (name . answer), or #f if the line is no answer
(define (read-line-safely line)
  (define d (if (plain-line? line) (read-datum line) (refused-line line)))
  (and (list? d) (>= (length d) 2) (symbol? (car d)) (symbol? (cadr d))
       (cons (car d) (checked (cadr d) (cddr d)))))

(define (plain-line? line)
  (not (or (regexp-match? #rx"[]#\"|\\`',@;{}[]" line)
           (regexp-match? #px"[0-9.][a-zA-Z][+-]?[0-9]{4,}" line)
           (many-digits? line))))

;; A failure under the name of the line, if the line has one.
(define (refused-line line)
  (define m (regexp-match #px"^\\(([a-zA-Z][\\w*+/<=>!?:$%&~^.-]{0,60}) answer " line))
  (and m (list* (string->symbol (cadr m)) 'failed
                (text->codes "there is a name or a number in it that is none"))))

(define (read-datum line)
  (with-handlers ([exn:fail? (lambda (e) #f)]) (read-untrusted line)))

(define (checked sort parts)
  (case sort
    [(unanswered) '(unanswered)]
    [(answer) (if (= 1 (length parts)) (cons 'answer parts) '(failed "it is no expression"))]
    [(text failed) (list sort (codes->text parts))]
    [else '(failed "it is no answer")]))

(define (codes->text codes)
  (list->string
   (for/list ([c (in-list codes)] [_ (in-range longest-text)])
     (if (and (exact-nonnegative-integer? c) (or (< c #xD800) (< #xDFFF c #x110000)))
         (integer->char c)
         #\?))))
