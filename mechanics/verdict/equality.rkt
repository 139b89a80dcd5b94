#lang racket/base
;; `=` and `zero?` as a reader asks them.
;;
;; The library compares expressions by their form, for which nothing need be loaded: sin² x and
;; 1 - cos² x differ.  To a reader they are equal.  So where forms differ the algebra is asked,
;; as by `verify-equal`, and a proof counts; its grounds are told.  Where there is neither
;; proof nor refutation, and for functions, the answer is no more than that forms differ,
;; which is told once.

(require (only-in racket/list drop-right)
         "prove-zero.rkt" "verdict.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/pi.rkt"
         "../error/note.rkt" "../error/message-words.rkt"
         "../generic/compare.rkt" "../generic/describe.rkt" "../generic/kind.rkt"
         "../generic/naming.rkt" "../generic/up-down.rkt"
         "../value/assumptions.rkt"
         "../value/matrix/matrix.rkt")

(provide equal-by-proof? zero-by-proof? one-by-proof?)

(define-named equal-by-proof? =
  (case-lambda
    [(a b) (if (and (number? a) (number? b)) (= a b) (all-equal? (list a b)))]
    [(a) #t]
    [(a b . more)
     (define all (list* a b more))
     (if (andmap number? all) (apply = all) (all-equal? all))]))

(define-named zero-by-proof? zero?
  (lambda (x) (if (number? x) (zero? x) (proved-equal? (open-zeros x '()) x 0))))

(define-named one-by-proof? one?
  (lambda (x) (if (number? x) (= x 1) (or (g:one? x) (all-equal? (list x 1))))))

(define (all-equal? all)
  (proved-equal? (open-equalities (drop-right all 1) (cdr all) '()) (car all) (cadr all)))

;; ---------------------------------------------------------------------------
;; Values that g:= and g:zero? take for different
;;
;; All of one question is asked at once, so that assumptions on its parts hold together.

;; The pairs of expressions that would have to be equal, before those found; #f where something
;; differs whatever they are.  found : such pairs, or #f
(define (open-equalities xs ys found)
  (for/fold ([found found]) ([x xs] [y ys] #:break (not found)) (open-equality x y found)))

(define (open-equality a b found)
  (define x (comparand a))
  (define y (comparand b))
  (cond [(g:= a b) found]
        [(and (expression? x) (expression? y))
         (and (not (and (atom? x) (atom? y))) (cons (cons x y) found))]
        [(and (tuple? x) (tuple? y))
         (and (compatible? (adopt x) (adopt y))
              (open-equalities (tuple-elements x) (tuple-elements y) found))]
        [(and (matrix? x) (matrix? y))
         (and (same-size? x y)
              (for/fold ([found found]) ([r (in-vector (matrix-rows x))]
                                         [s (in-vector (matrix-rows y))])
                (open-equalities r s found)))]
        [(and (function? x) (function? y)) (note-functions) #f]
        [else #f]))

;; The same for x and zero: pairs of an expression in x and 0.
(define (open-zeros x found)
  (define c (comparand x))
  (define (all-open xs found)
    (for/fold ([found found]) ([e (in-vector xs)] #:break (not found)) (open-zeros e found)))
  (cond [(g:zero? x) found]
        [(expression? c) (and (not (atom? c)) (cons (cons c 0) found))]
        [(tuple? c) (all-open (tuple-elements c) found)]
        [(matrix? c)
         (for/fold ([found found]) ([row (in-vector (matrix-rows c))]) (all-open row found))]
        [(function? c) (note-functions) #f]
        [else #f]))

;; Operators and series are functions, too, for questions here.
(define (function? x) (and (procedure? x) (not (tuple? x)) (not (matrix? x))))

;; The algebra cannot prove equal two symbols, or a symbol and a number.
(define (atom? x) (or (number? x) (and (symbol? x) (not (pi-symbol? x)))))

;; pairs : a list or #f; a and b : the values compared, which notes name where pairs are several
(define (proved-equal? pairs a b)
  (cond [(not pairs) #f]
        [(null? pairs) #t]
        [(null? (cdr pairs)) (judged-equal? (caar pairs) (cdar pairs) (caar pairs) (cdar pairs))]
        [else (judged-equal? (tuple-of (map car pairs)) (tuple-of (map cdr pairs)) a b)]))

(define (tuple-of reversed) (vector->up (list->vector (reverse reversed))))

(define (judged-equal? x y a b)
  (define v (verify-equal x y))
  (case (verdict-status v)
    [(proved) (tell-grounds a b (undeclared (verdict-assumptions v))) #t]
    [(refuted) #f]
    [else (note-undecided a b) #f]))

;; ---------------------------------------------------------------------------
;; Notes beside the answer

(define (tell-grounds x y grounds)
  (unless (null? grounds)
    (note-once (format "= takes ~a and ~a for equal assuming ~a"
                       (brief x) (brief y) (joined (map value->text grounds)))
               (list x y grounds))))

(define (note-undecided x y)
  (note-once (format (string-append "= answers #f for ~a and ~a, which are written differently: "
                                    "whether they are equal is not known\n"
                                    "  (verify-equal a b) says why")
                     (brief x) (brief y))
             (list x y)))

(define (note-functions)
  (note-once (string-append "= answers #f for two functions that are not one and the same: "
                            "their values are not compared\n"
                            "  (verify-equal f g) compares them at symbolic arguments")
             'functions))

(define (brief x)
  (define text (value->text x))
  (if (<= (string-length text) 30) text "an expression"))
