#lang racket/base
;; Structures as their scalars in a row, of numbers as flvectors; and back.  Structures of a given
;; shape: made of lists, or of symbols that stand for any values; work that is done once for all
;; of a shape.

(require racket/flonum
         (only-in "assumptions.rkt" assumptions)
         "../algebra/expression/constant-value.rkt" "../algebra/expression/expression.rkt"
         "../generic/kind.rkt" "../generic/up-down.rkt")

(provide scalars numeric? shape-length
         ;; of a given shape
         scalars->structure list->structure flvector->structure vector->structure unit-structure
         s:map/r unknowns-like symbols-like typical-object by-shape
         ;; others
         structure->flvector single-or)

;; The scalars of x, a scalar or a structure of them, from the first to the last.
(define (scalars x)
  (let walk ([x x] [rest '()])
    (if (tuple? x)
        (for/fold ([rest rest]) ([k (in-range (- (structure-length (adopt x)) 1) -1 -1)])
          (walk (vector-ref (tuple-elements x) k) rest))
        (cons x rest))))

;; Is x a number or a structure of numbers, all real?
(define (numeric? x) (andmap real? (scalars x)))

(define (shape-length x) (length (scalars x)))

;; A structure of the shape of x whose k-th scalar is (f k).
(define (scalars->structure x f)
  (define k -1)
  (let walk ([x x])
    (cond [(tuple? x) (structure-map walk (adopt x))]
          [else (set! k (+ k 1))
                (f k)])))

;; f applied to each scalar, at any depth.
(define (s:map/r f s)
  (if (tuple? s) (structure-map (lambda (e) (s:map/r f e)) (adopt s)) (f s)))

(define (flvector->structure shape v)
  (scalars->structure shape (lambda (k) (flvector-ref v k))))

(define (vector->structure shape v)
  (scalars->structure shape (lambda (k) (vector-ref v k))))

;; xs : the scalars, in order
(define (list->structure shape xs) (vector->structure shape (list->vector xs)))

;; 1 for the scalar of index k, 0 for the others
(define (unit-structure shape k) (scalars->structure shape (lambda (j) (if (= j k) 1 0))))

;; The only element of the list xs, or (make xs)
(define (single-or make xs) (if (and (pair? xs) (null? (cdr xs))) (car xs) (make xs)))

;; A structure of the shape of x, of symbols that stand in no expression; in place of a symbol is
;; one spelt like it, as it may be shown in a message.
(define (unknowns-like x)
  (s:map/r (lambda (leaf)
             (string->uninterned-symbol (if (symbol? leaf) (symbol->string leaf) "x")))
           x))

;; The same, of symbols that are numbered.
(define (symbols-like x name)
  (scalars->structure x (lambda (k) (string->uninterned-symbol (format "~a~a" name k)))))

;; As scmutils has it
(define (typical-object s) (symbols-like s "x"))

;; Calls (complain scalar) for a scalar that is not a real number; multiples of π are real numbers.
(define (structure->flvector x complain)
  (define xs (scalars x))
  (define v (make-flvector (length xs)))
  (for ([x (in-list xs)] [k (in-naturals)])
    (define r
      (cond [(other-number? x) (comparand x)]
            [(symbolic? x) (constant-value x)]
            [else x]))
    (flvector-set! v k (if (real? r) (real->double-flonum r) (complain x))))
  v)

;; ---------------------------------------------------------------------------
;; Work that is done once for all structures of a shape

;; value : (f shape); declared : the assumptions under which it was found
(struct result (value shape declared) #:authentic)

;; -> a procedure of x that gives (f x).  It calls f anew for a shape that it has not met, or if
;; other assumptions are declared than then and the value is not lasting?.  Two threads may both
;; call f.
(define (by-shape f #:lasting? [lasting? (lambda (value) #t)])
  (define known '())
  (define (holds? r)
    (or (lasting? (result-value r)) (equal? (result-declared r) (assumptions 'declared))))
  (lambda (x)
    (define r (findf (lambda (r) (same-shape? x (result-shape r))) known))
    (cond [(and r (holds? r)) (result-value r)]
          [else
           (define value (f x))
           (set! known (cons (result value x (assumptions 'declared)) (remq r known)))
           value])))
