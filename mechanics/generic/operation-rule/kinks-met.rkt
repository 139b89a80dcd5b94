#lang racket/base
;; Points that a derivative met on its way and passes over.
;;
;; D(sgn) is 0 wherever it is defined, and says nothing of the jump at 0.  Who asks whether
;; something holds at all times wants to know: while `call-noting-kinks` runs, the rules for
;; derivatives note each operation, with its arguments, that may have a kink, a jump or no
;; value somewhere.  They do so before anything is simplified, and only where a derivative
;; is taken.  Of numbers nothing is noted: there a rule sees by itself that it has no value.

(require "../kind.rkt"
         "../../algebra/expression/expression.rkt")

(provide call-noting-kinks note-kink! (struct-out met))

;; name, arguments : of an operation, the arguments being expressions; equal? by content
(struct met (name arguments) #:transparent)

;; seen : hash, met -> #t                       list : the same, newest first
(struct notes (seen [list #:mutable]) #:authentic)

(define current-notes (make-parameter #f))

;; -> the value of (thunk), and the points met, in order
(define (call-noting-kinks thunk)
  (define found (notes (make-hash) '()))
  (define value (parameterize ([current-notes found]) (thunk)))
  (values value (reverse (notes-list found))))

;; Notes the operation unless all its arguments are numbers.
(define (note-kink! name . arguments)
  (define found (current-notes))
  (when found
    (define plain (map comparand arguments))
    (when (and (andmap expression? plain) (ormap symbolic? plain))
      (add! found (met name plain)))))

(define (add! found m)
  (unless (hash-ref (notes-seen found) m #f)
    (hash-set! (notes-seen found) m #t)
    (set-notes-list! found (cons m (notes-list found)))))
