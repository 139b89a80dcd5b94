#lang racket/base
;; Words put together, for messages and reports.

(require racket/list racket/string)

(provide message message-with-fields joined counted first-line)

;; "who: " and the text, which with its parts is as `format` takes them.
(define (message who text parts)
  (format "~a: ~a" who (apply format text (map in-brief parts))))

;; "who: " and the text, then a line for each of the fields: label value label value ...
(define (message-with-fields who text fields)
  (apply string-append (format "~a: ~a" who text)
         (let loop ([fields fields])
           (if (null? fields)
               '()
               (cons (format "\n  ~a: ~e" (car fields) (cadr fields))
                     (loop (cddr fields)))))))

;; The most characters of a line of a part that are shown: a value is shown to be recognised, not
;; to be read whole.
(define longest-line 400)

(define (in-brief part)
  (if (and (string? part) (> (string-length part) longest-line))
      (joined (map line-in-brief (string-split part "\n" #:trim? #f)) "\n")
      part))

(define (line-in-brief line)
  (define more (- (string-length line) longest-line))
  (if (positive? more)
      (format "~a ...~a more characters" (substring line 0 longest-line) more)
      line))

;; "a, b, c"
(define (joined texts [separator ", "])
  (apply string-append (add-between texts separator)))

;; "1 argument", "2 arguments"
(define (counted n noun)
  (format "~a ~a~a" n noun (if (eqv? n 1) "" "s")))

(define (first-line text) (regexp-replace #rx"\n.*" text ""))
