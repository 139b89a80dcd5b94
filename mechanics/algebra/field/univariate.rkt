#lang racket/base
;; Polynomials in one kernel over the field of the others.
;;
;; A polynomial is the list of its coefficients, reduced fractions, the constant
;; one first and the last not zero.  Every operation takes the field first.

(require racket/list
         "field.rkt"
         "../polynomial/fraction.rkt" "../polynomial/polynomial.rkt")

(provide poly->univariate univariate->fraction
         u:scale u:* u:expt u:divide u:inverse)

;; The polynomial p of the field's ring, in variable i.
(define (poly->univariate F i p)
  (define R (field-ring F))
  (define slices (poly-coefficients R p i))
  (define size (if (null? slices) 0 (+ 1 (slice-degree (first slices)))))
  (for/list ([k (in-range size)])
    (define s (findf (lambda (s) (eqv? k (slice-degree s))) slices))
    (if s (fraction-from-poly R (slice-coefficient s)) (zero F))))

(define (univariate->fraction F i p)
  (define R (field-ring F))
  (fraction-sum R
    (for/list ([c (in-list p)] [k (in-naturals)])
      (fraction* R c (fraction-from-poly R (poly-variable R i k))))))

;; ---------------------------------------------------------------------------
;; Coefficients

(define (times F a b) (reduce-fraction F (fraction* (field-ring F) a b)))
(define (over F a b) (reduce-fraction F (fraction/ (field-ring F) a b)))
(define (zero F) (fraction-constant (field-ring F) 0))
(define (one F) (fraction-constant (field-ring F) 1))

;; ---------------------------------------------------------------------------
;; Arithmetic

;; The list without zeros at its end.
(define (trim cs)
  (cond [(null? cs) '()]
        [else
         (define rest (trim (cdr cs)))
         (if (and (null? rest) (fraction-zero? (car cs))) '() (cons (car cs) rest))]))

(define (u:scale F c p)
  (trim (for/list ([a (in-list p)]) (times F c a))))

(define (u:- F p q)
  (trim (add F p (for/list ([c (in-list q)]) (fraction-negate (field-ring F) c)))))

(define (u:* F p q)
  (if (or (null? p) (null? q))
      '()
      (trim (for/fold ([sum '()]) ([a (in-list (reverse p))])
              (add F (for/list ([b (in-list q)]) (times F a b)) (cons (zero F) sum))))))

(define (add F p q)
  (cond [(null? p) q]
        [(null? q) p]
        [else (cons (fraction+ (field-ring F) (car p) (car q)) (add F (cdr p) (cdr q)))]))

(define (u:expt F p k)
  (for/fold ([power (list (one F))]) ([_ (in-range k)]) (u:* F power p)))

;; -> quotient and remainder
(define (u:divide F p q)
  (define n (length q))
  (define lead (last q))
  (define (shifted k q) (append (make-list k (zero F)) q))
  (let loop ([p p] [quotient '()])
    (define k (- (length p) n))
    (cond [(< k 0) (values (trim quotient) p)]
          [else
           (define c (over F (last p) lead))
           (loop (u:- F p (shifted k (u:scale F c q)))
                 (add F quotient (shifted k (list c))))])))

;; The inverse of p modulo q, coprime to it and of positive degree, by Euclid's
;; algorithm: every remainder is a multiple of p modulo q.
(define (u:inverse F p q)
  (define-values (whole start) (u:divide F p q))
  (let loop ([a q] [s '()] [b start] [t (list (one F))])
    (cond [(null? (cdr b)) (u:scale F (over F (one F) (car b)) t)]
          [else
           (define-values (k rest) (u:divide F a b))
           (loop b t rest (u:- F s (u:* F k t)))])))
