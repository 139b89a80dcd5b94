#lang racket/base
;; Which S-expressions are taken for answers.
;;
;; An answer comes from a program that may wish us ill.  (expt 9 (expt 9 9)) is short, and the
;; number does not fit into any memory; so before anything is calculated its size is
;; estimated: a bound on the digits of the numbers, and on the degrees of the polynomials,
;; that it may come to.

(require "../../algebra/expression/exact-numbers.rkt"
         "../../numeric/finite-number.rkt")

(provide why-not-an-answer)

(define most-parts 20000)
(define most-weight 40000)
(define longest-symbol 60)
(define deepest 500)

;; Says in words why the datum is refused, or gives #f.
(define (why-not-an-answer d)
  (let/ec return
    (check-parts d return)
    (and (> (weight d) most-weight) "it comes to more than can be calculated with")))

;; ---------------------------------------------------------------------------

(define (check-parts d reject)
  (define count 0)
  (let walk ([d d] [depth 0])
    (set! count (+ count 1))
    (when (> count most-parts) (reject (format "it has more than ~a parts" most-parts)))
    (when (> depth deepest) (reject "its parts are nested too deeply"))
    (cond [(list? d) (for ([part (in-list d)]) (walk part (+ depth 1)))]
          [(symbol? d) (check-symbol d reject)]
          [(number? d) (unless (exact-constant? d) (reject (format "~a in it is no number" d)))]
          [else (reject "it is no expression")])))

(define (check-symbol s reject)
  (define text (symbol->string s))
  (when (regexp-match? #rx"[*][*]" text)
    (reject (format "~a in it is one name; powers are (expt x 2), or in a text \"x^2\"" text)))
  (unless (and (<= 1 (string-length text) longest-symbol)
               (for/and ([c (in-string text)]) (and (char-graphic? c) (not (memv c odd)))))
    (reject "a name in it is no name of a quantity")))

(define odd (string->list "\"'`,;|\\()[]{}&#"))

;; An estimate of the digits, or terms, that d may come to.
(define (weight d)
  (cond [(exact-rational? d) (+ 1 (integer-length (numerator d)) (integer-length (denominator d)))]
        [(or (not (pair? d)) (null? d)) 1]
        [(eq? (car d) 'square) (* 2 (weights (cdr d)))]
        [(eq? (car d) 'cube) (* 3 (weights (cdr d)))]
        [(and (eq? (car d) 'expt) (= 3 (length d))) (* (times (caddr d)) (weight (cadr d)))]
        [(pair? (car d)) (+ (weight (car d)) (weights (cdr d)))]
        [else (+ 1 (weights (cdr d)))]))

(define (weights ds) (for/sum ([d (in-list ds)]) (weight d)))

;; The factor by which a power multiplies the weight of its base.
(define (times exponent)
  (cond [(exact-rational? exponent)
         (+ 1 (abs (numerator exponent)) (abs (denominator exponent)))]
        [(number? exponent) 1]
        [(numeric? exponent) (expt 2 (min 64 (weight exponent)))]
        [else (weight exponent)]))

;; Does d hold no symbol?  Then it may be a large number.
(define (numeric? d)
  (if (pair? d) (andmap numeric? (cdr d)) (number? d)))
