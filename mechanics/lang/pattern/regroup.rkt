#lang racket/base
;; A tuple and a pattern with the same number of parts, grouped otherwise: the local tuple
;; (up t (up x y) (up vx vy)) where (up t x y vx vy) is written, or given.

(require (only-in racket/list append-map)
         "../../algebra/expression/write.rkt"
         "../../generic/describe.rkt"
         (only-in "../../generic/up-down.rkt" structure? structure-orientation structure-elements
                  up down))

(provide regrouped)

;; pattern : a datum; x : a tuple -> a sentence that shows the one in the groups of the other,
;; or #f
(define (regrouped pattern x)
  (define names (parts-of-pattern pattern))
  (define values (parts-of-tuple x))
  (cond [(not (= (length names) (length values))) #f]
        [(= (length (cdr pattern)) (vector-length (structure-elements x))) #f]
        [(flat-pattern? pattern)
         (format "~a: ~a" (what-it-has x) (datum->text (shaped-as-tuple x names)))]
        [(= (length values) (vector-length (structure-elements x)))
         (parameterize ([print-limit 60])
           (format "grouped as in the pattern it is ~a"
                   (value->text (shaped-as-pattern pattern values))))]
        [else #f]))

(define (what-it-has x)
  (define n (vector-length (structure-elements x)))
  (if (= n 3) "a local tuple has three parts" (format "the tuple has ~a parts" n)))

;; ---------------------------------------------------------------------------
;; Parts, in a row

(define (flat-pattern? pattern) (not (ormap pair? (cdr pattern))))

(define (parts-of-pattern p)
  (if (pair? p) (append-map parts-of-pattern (cdr p)) (list p)))

(define (parts-of-tuple x)
  (if (structure? x)
      (append-map parts-of-tuple (vector->list (structure-elements x)))
      (list x)))

;; ---------------------------------------------------------------------------
;; Grouped

;; As a datum, with the names in the places of the parts of x.
(define (shaped-as-tuple x names)
  (define-values (shaped rest) (take-tuple x names))
  shaped)

(define (take-tuple x names)
  (if (structure? x)
      (let-values ([(parts rest)
                    (take-each take-tuple (vector->list (structure-elements x)) names)])
        (values (cons (structure-orientation x) parts) rest))
      (values (car names) (cdr names))))

;; A tuple, with the values in the places of the names.
(define (shaped-as-pattern pattern values)
  (define-values (shaped rest) (take-pattern pattern values))
  shaped)

(define (take-pattern p xs)
  (if (pair? p)
      (let-values ([(parts rest) (take-each take-pattern (cdr p) xs)])
        (values (apply (if (eq? (car p) 'up) up down) parts) rest))
      (values (car xs) (cdr xs))))

;; take : place parts -> what takes its place, the parts that are left
(define (take-each take places parts)
  (for/fold ([taken '()] [rest parts] #:result (values (reverse taken) rest))
            ([p (in-list places)])
    (define-values (one others) (take p rest))
    (values (cons one taken) others)))
