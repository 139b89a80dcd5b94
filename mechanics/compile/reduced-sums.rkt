#lang racket/base
;; Sums with fewer terms.
;;
;; Where sin² and cos² of one angle have the same factors beside them, one of them is left:
;;
;;     1 − cos² = sin²,   a cos² + b sin² = a + (b − a) sin² = b + (a − b) cos²,
;;
;; the form that adds numbers of one sign.  A factor that is a sum is multiplied out where most of
;; its terms cancel with others: rounded each for itself, their sum would have fewer
;; digits.

(require "flonum-coefficients.rkt" "sum-terms.rkt")

(provide reduced)

(define (reduced f s)
  (define r (with-one-square f s))
  (or (for*/or ([t (in-list r)] [id (in-list (monomial t))])
        (define factor (factor-of f id))
        (and (eq? 'sum (car factor))
             (pair? (cdr r))
             (<= (* (length r) (length (cdr factor))) most-products)
             (let ([shorter (with-one-square f (multiplied-out r t id (cdr factor)))])
               (and (< (length shorter) (length r)) (reduced f shorter)))))
      r))

;; Longer sums hardly cancel, and to try takes long.
(define most-products 60)

(define (multiplied-out s t id sum)
  (define rest (without id (monomial t)))
  (plus (remq t s)
        (for/list ([u (in-list sum)])
          (cons (* (coefficient t) (coefficient u)) (foldl with-factor rest (monomial u))))))

(define (with-one-square f s)
  (or (for*/or ([t (in-list s)] [id (in-list (monomial t))])
        (define rest (beside-square id (monomial t)))
        (define twin (and rest (twin-of f id)))
        (define other (and twin (with-factor twin (with-factor twin rest))))
        (define shorter (and twin (without-square s t rest other)))
        (and shorter (with-one-square f shorter)))
      s))

;; t : a term, of the square of a sine or cosine and the factors `rest`; other : the monomial with
;; the other one's square -> sum, or #f
(define (without-square s t rest other)
  (define-values (one square) (values (term-of s rest) (term-of s other)))
  (define a (coefficient t))
  (cond [(and one (= (coefficient one) (- a)))
         (plus-term (remq one (remq t s)) (cons (- a) other))]
        [(and square (one-sign? a (coefficient square)) (exact-difference? a (coefficient square)))
         (define b (coefficient square))
         (if (<= (abs a) (abs b))
             (plus-term (replaced (remq t s) square (- b a)) (cons a rest))
             (plus-term (replaced (remq square s) t (- a b)) (cons b rest)))]
        [else #f]))

;; The other factors of a monomial that holds the square of one, or #f
(define (beside-square id m)
  (define others (without id m))
  (and (memv id others) (without id others)))

;; -> id of the cosine of the same angle as a sine, or the other way round, if there is one; or #f
(define (twin-of f id)
  (define factor (factor-of f id))
  (define other
    (and (eq? 'operation (car factor))
         (case (cadr factor) [(sin) 'cos] [(cos) 'sin] [else #f])))
  (and other (known f (list* 'operation other (cddr factor)))))

;; Numbers of two signs cancel somewhere; they must do so wherever their sum is far from both.
(define (one-sign? a b) (or (> (* a b) 0.0) (< 1/16 (abs (/ a b)) 16)))
