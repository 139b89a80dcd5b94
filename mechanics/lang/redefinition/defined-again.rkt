#lang racket/base
;; Names that a program defines again: each definition holds from where it stands, which whoever
;; did not know of the first one is told, once in a session.

(require (only-in "../../error/note.rkt" note-once)
         (only-in "../../error/message-words.rkt" joined))

(provide lines-of-repeated tell-repeated)

;; defined : identifiers, each where it is defined first; repeated : those that follow
;; -> ((name line line ...) ...)
(define (lines-of-repeated defined repeated)
  (for*/list ([first-one (in-list defined)]
              [others (in-value (filter (lambda (id) (bound-identifier=? id first-one)) repeated))]
              #:when (and (pair? others) (andmap syntax-line (cons first-one others))))
    (cons (syntax-e first-one) (sort (map syntax-line (cons first-one others)) <))))

(define (tell-repeated name . lines)
  (note-once (format "~a is defined on lines ~a: each definition holds from there on"
                     name (joined (map number->string lines)))))
