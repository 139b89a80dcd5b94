#lang racket/base
;; The local tuple at which a question about all states is asked: its scalars are symbols,
;; each of which may be any number.

(require "local-tuple.rkt" "total-derivative.rkt"
         "../algebra/expression/symbols.rkt"
         "../error/complain.rkt"
         "../generic/describe.rkt"
         "../value/shape.rkt" "../value/structure.rkt")

(provide check-generic-state check-generic-states check-symbols check-parameters lengthened)

(define (check-generic-state who local [least-length 3])
  (check-local-tuple who local least-length)
  (check-symbols who local "local tuple"))

;; what : the state's name
(define (check-symbols who local what)
  (define names (scalars local))
  (define other
    (for/first ([x (in-list names)] [i (in-naturals)]
                #:unless (and (free-symbol? x) (not (memq x (list-tail names (add1 i))))))
      x))
  (when other
    (complain who
              (string-append "the ~a must be made of symbols, each there once, "
                             "to stand for any state"
                             "\n  given: ~a"
                             "\n  ~a: ~a")
              what (value->text local) (if (free-symbol? other) "more than once" "no symbol")
              (value->text other))))

;; fs : functions of (t, q, v), or #f; no symbol of the local tuple may be a parameter of one
(define (check-generic-states who local . fs)
  (check-generic-state who local)
  (define state ((clip-state 3) local))
  (for ([f (in-list fs)] #:when f)
    (with-handlers ([exn:fail:contract? (lambda (e) (check-grouped f local) (raise e))])
      (check-parameters who f state))))

;; Coordinates and velocities all in a row, (up t x y vx vy), look like (up t q v ...): the value
;; of f at the whole shows how they are grouped.
(define (check-grouped f local)
  (when (> (s:length local) 3) (f (unknowns-like local))))

;; A symbol that is a parameter of f could not stand for any state as well: f is asked
;; for its value at other symbols, where those of the local tuple must not occur.
(define (check-parameters who f local [what "local tuple"])
  (for* ([e (in-list (scalars (f (unknowns-like local))))]
         [name (in-list (scalars local))]
         #:when (occurs? name e))
    (complain who
              (string-append "the symbol ~a is a parameter of ~a, and stands in the ~a, too"
                             "\n  ~a: ~a"
                             "\n  give one of them another name")
              name (value->text f) what what (value->text local))))

;; The local tuple with derivatives up to `length` components in all; new ones are
;; named after the coordinates: xddot, xdddot, and so on.
(define (lengthened local length)
  (define q (coordinate local))
  (list->up
   (append (structure->list local)
           (for/list ([k (in-range (- (s:length local) 1) (- length 1))])
             (s:map/r (lambda (name) (derivative-name name k)) q)))))

;; x and 2 -> xddot; q^0 and 2 -> qddot^0
(define (derivative-name name order)
  (define parts (regexp-match #rx"^([^_^]+)(.*)$" (symbol->string name)))
  (define dots (string-append (make-string order #\d) "ot"))
  (string->symbol
   (if parts
       (string-append (cadr parts) dots (caddr parts))
       (string-append (symbol->string name) dots))))
