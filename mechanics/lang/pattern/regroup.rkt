#lang racket/base
;; A tuple and a pattern with the same number of parts, grouped otherwise: the local tuple
;; (up t (up x y) (up vx vy)) where (up t x y vx vy) is written, or given.

(require (only-in racket/list append-map)
         "../../algebra/expression/write.rkt"
         "../../generic/describe.rkt"
         (only-in "../../generic/up-down.rkt" structure? structure-orientation structure-elements
                  up down))

(provide regrouped)

;; pattern : a datum; x : a tuple
;; -> a sentence that shows the names in the groups of x, or the parts of x in the groups of the
;; pattern; or #f
(define (regrouped pattern x)
  (define groups (tuple->groups x))
  (define-values (names parts) (values (leaves pattern) (leaves groups)))
  (define n (length (cdr groups)))
  (cond [(not (= (length names) (length parts))) #f]
        [(= (length (cdr pattern)) n) #f]
        [(not (ormap pair? (cdr pattern)))
         (format "~a: ~a"
                 (if (= n 3) "a local tuple has three parts" (format "the tuple has ~a parts" n))
                 (datum->text (refilled groups names cons)))]
        [(= (length parts) n)
         (define (tuple orientation parts) (apply (if (eq? orientation 'up) up down) parts))
         (parameterize ([print-limit 60])
           (format "grouped as in the pattern it is ~a"
                   (value->text (refilled pattern parts tuple))))]
        [else #f]))

;; A pattern with the parts of a tuple, each in a box, in the places of names.
(define (tuple->groups x)
  (if (structure? x)
      (cons (structure-orientation x)
            (map tuple->groups (vector->list (structure-elements x))))
      (box x)))

;; Names, or the contents of boxes, in a row.
(define (leaves p)
  (cond [(pair? p) (append-map leaves (cdr p))]
        [(box? p) (list (unbox p))]
        [else (list p)]))

;; The pattern with other leaves; make : orientation and parts -> group
(define (refilled pattern others make)
  (let fill ([p pattern])
    (cond [(pair? p) (make (car p) (for/list ([part (in-list (cdr p))]) (fill part)))]
          [else (begin0 (car others) (set! others (cdr others)))])))
