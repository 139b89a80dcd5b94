#lang racket/base
;; How many wrong answers a student has given to each item, so that hints come when they help.
;; It is kept in a file beside that of the student; the same answer counts once.

(require racket/file
         racket/list)

(provide count-tries)

;; file : of the student, or #f where there is none
;; wrong : ((name . answer) ...), the wrong answers of now -> hasheq, name -> how many so far
(define (count-tries file wrong)
  (define place (and file (path-replace-extension file #".tries")))
  (define before (if place (read-tries place) '()))
  (define all
    (remove-duplicates
     (append before (for/list ([w (in-list wrong)]) (list (car w) (digest (cdr w)))))))
  (when (and place (not (equal? all before))) (write-tries place all))
  (for/fold ([counts (hasheq)]) ([entry (in-list all)])
    (hash-update counts (car entry) add1 0)))

(define (digest answer) (equal-hash-code (format "~s" answer)))

(define (read-tries place)
  (define found
    (with-handlers ([exn:fail? (lambda (e) '())])
      (if (file-exists? place) (file->value place) '())))
  (if (and (list? found) (andmap entry? found)) found '()))

(define (entry? x) (and (list? x) (= 2 (length x)) (symbol? (car x)) (exact-integer? (cadr x))))

;; In a folder that cannot be written to every try is the first.
(define (write-tries place all)
  (with-handlers ([exn:fail:filesystem? void])
    (write-to-file all place #:exists 'truncate)))
