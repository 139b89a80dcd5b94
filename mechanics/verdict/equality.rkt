#lang racket/base
;; `=` and `zero?` as a reader asks them.
;;
;; The library compares expressions by their form, for which nothing need be loaded: sin² x and
;; 1 - cos² x differ.  To a reader they are equal.  So where forms differ the algebra is asked,
;; as by `verify-equal`, and a proof counts; what it rests on is told.  Where there is neither
;; proof nor refutation, and for functions, the answer is no more than that forms differ,
;; which is told once.

(require "prove-zero.rkt" "verdict.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/pi.rkt"
         "../error/note.rkt" "../error/words.rkt"
         "../generic/compare.rkt" "../generic/describe.rkt" "../generic/kind.rkt"
         "../generic/naming.rkt" "../generic/up-down.rkt"
         "../value/assumptions.rkt"
         "../value/linear/matrix.rkt")

(provide equal-by-proof? zero-by-proof? one-by-proof?)

(define-named equal-by-proof? =
  (case-lambda
    [(a b) (two a b)]
    [(a) #t]
    [(a b . more) (and (two a b) (apply equal-by-proof? b more))]))

(define-named zero-by-proof? zero?
  (lambda (x) (if (number? x) (zero? x) (or (g:zero? x) (vanishes? x)))))

(define-named one-by-proof? one?
  (lambda (x) (if (number? x) (= x 1) (or (g:one? x) (differently-written-equals? x 1)))))

(define (two a b)
  (if (and (number? a) (number? b))
      (= a b)
      (or (g:= a b) (differently-written-equals? a b))))

;; ---------------------------------------------------------------------------
;; What g:= and g:zero? take for different

(define (differently-written-equals? a b)
  (define x (comparand a))
  (define y (comparand b))
  (cond [(and (expression? x) (expression? y)) (equal-expressions? x y)]
        [(and (tuple? x) (tuple? y))
         (and (compatible? (adopt x) (adopt y)) (all-equal? (tuple-elements x) (tuple-elements y)))]
        [(and (matrix? x) (matrix? y))
         (and (same-size? x y)
              (for/and ([r (in-vector (matrix-rows x))] [s (in-vector (matrix-rows y))])
                (all-equal? r s)))]
        [(and (function? x) (function? y)) (note-functions) #f]
        [else #f]))

(define (all-equal? xs ys) (for/and ([x (in-vector xs)] [y (in-vector ys)]) (two x y)))

(define (same-size? x y)
  (and (= (m:num-rows x) (m:num-rows y)) (= (m:num-cols x) (m:num-cols y))))

(define (vanishes? x)
  (define c (comparand x))
  (cond [(expression? c) (equal-expressions? c 0)]
        [(tuple? c) (for/and ([e (in-vector (tuple-elements c))]) (zero-by-proof? e))]
        [(matrix? c)
         (for*/and ([row (in-vector (matrix-rows c))] [e (in-vector row)]) (zero-by-proof? e))]
        [(function? c) (note-functions) #f]
        [else #f]))

;; Operators and series are functions, too, in what is asked here.
(define (function? x) (and (procedure? x) (not (tuple? x)) (not (matrix? x))))

;; Symbols, and a symbol and a number, differ for all the algebra could say.
(define (equal-expressions? x y)
  (and (not (and (atom? x) (atom? y)))
       (let ([v (verify-equal x y)])
         (case (verdict-status v)
           [(proved) (tell-grounds x y (undeclared (verdict-assumptions v))) #t]
           [(refuted) #f]
           [else (note-undecided x y) #f]))))

(define (atom? x) (or (number? x) (and (symbol? x) (not (pi-symbol? x)))))

;; ---------------------------------------------------------------------------
;; What is told

(define (tell-grounds x y grounds)
  (unless (null? grounds)
    (note-once (format "= takes ~a and ~a for equal assuming ~a"
                       (brief x) (brief y) (joined (map value->text grounds))))))

(define (note-undecided x y)
  (note-once (format (string-append "= answers #f for ~a and ~a, which are written differently: "
                                    "whether they are equal is not known\n"
                                    "  (verify-equal a b) says why")
                     (brief x) (brief y))
             'undecided))

(define (note-functions)
  (note-once (string-append "= answers #f for two functions that are not one and the same: "
                            "their values are not compared\n"
                            "  (verify-equal f g) compares them at symbolic arguments")
             'functions))

(define (brief x)
  (define text (value->text x))
  (if (<= (string-length text) 30) text "an expression"))
