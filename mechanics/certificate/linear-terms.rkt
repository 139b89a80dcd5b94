#lang racket/base
;; Angles and exponents as linear forms over monomials, and the few of which the others are whole
;; multiples.
;;
;; A term is a rational number times a monomial, a product of whole powers of what is no sum,
;; product or quotient: ω t (a + b)⁻¹.  π is a monomial like others.

(require racket/list
         "Coq-term.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/operation.rkt"
         "../algebra/expression/order.rkt"
         "../algebra/kernel/integer-lattice.rkt")

(provide linear-terms monomial->expression basic-forms form->expression (struct-out basics))

;; -> ((number . monomial) ...), each monomial once; a monomial is ((expression . exponent) ...)
(define (linear-terms e)
  (for/fold ([terms '()] #:result (filter (lambda (t) (not (eqv? 0 (car t)))) (reverse terms)))
            ([t (in-list (terms-of e))])
    (define same (findf (lambda (u) (equal? (cdr u) (cdr t))) terms))
    (if same
        (map (lambda (u) (if (eq? u same) (cons (+ (car u) (car t)) (cdr u)) u)) terms)
        (cons t terms))))

(define (terms-of e)
  (define args (if (node? e) (node-args e) '()))
  (cond [(number? e) (list (cons (rational-constant e) '()))]
        [(headed? e op:+) (append-map terms-of args)]
        [(headed? e op:-) (append (terms-of (car args)) (times -1 (terms-of (cadr args))))]
        [(headed? e op:*) (for/fold ([ts '((1))]) ([a (in-list args)]) (products ts (terms-of a)))]
        [(headed? e op:/) (products (terms-of (car args)) (reciprocal (cadr args)))]
        [(and (node? e) (integer-power? e)) (powers (car args) (cadr args))]
        [else (list (cons 1 (list (cons e 1))))]))

(define (times c terms) (for/list ([t (in-list terms)]) (cons (* c (car t)) (cdr t))))

(define (products ts us)
  (for*/list ([t (in-list ts)] [u (in-list us)])
    (cons (* (car t) (car u)) (monomial-product (cdr t) (cdr u)))))

(define (monomial-product a b)
  (for/fold ([product a]) ([factor (in-list b)])
    (define known (assoc (car factor) product))
    (define exponent (+ (cdr factor) (if known (cdr known) 0)))
    (define others (if known (remove known product) product))
    (if (eqv? exponent 0)
        others
        (sort (cons (cons (car factor) exponent) others) expression<? #:key car))))

(define (reciprocal e)
  (define terms (terms-of e))
  (define t (car terms))
  (if (and (null? (cdr terms)) (not (eqv? 0 (car t))))
      (list (cons (/ (car t)) (for/list ([f (in-list (cdr t))]) (cons (car f) (- (cdr f))))))
      (list (cons 1 (list (cons e -1))))))

(define (powers base k)
  (cond [(negative? k) (for/fold ([ts '((1))]) ([_ (in-range (- k))])
                         (products ts (reciprocal base)))]
        [else (for/fold ([ts '((1))]) ([_ (in-range k)]) (products ts (terms-of base)))]))

(define (monomial->expression m)
  (define (part sign)
    (for/fold ([product 1]) ([f (in-list m)] #:when (positive? (* sign (cdr f))))
      (e:* product (e:expt (car f) (abs (cdr f))))))
  (e:/ (part 1) (part -1)))

;; ---------------------------------------------------------------------------
;; Forms as whole multiples of basic ones

;; expressions : of the basic forms; multiples : for each form ((place of a basic one . integer)
;; ...)
(struct basics (expressions multiples) #:authentic)

;; forms : lists of terms, most : the greatest multiple; separate? : a basic form for each monomial
(define (basic-forms forms most separate?)
  (define monomials (remove-duplicates (append-map (lambda (f) (map cdr f)) forms)))
  (define vectors
    (for/list ([f (in-list forms)])
      (sort (for/list ([t (in-list f)]) (cons (index-of monomials (cdr t)) (car t)))
            < #:key car)))
  (define-values (basis coordinates)
    ((if separate? modest-basis/atoms modest-basis) vectors most))
  (basics (for/list ([v (in-list basis)])
            (form->expression (for/list ([x (in-list v)])
                                (cons (cdr x) (list-ref monomials (car x))))))
          coordinates))

(define (form->expression terms)
  (for/fold ([sum 0]) ([t (in-list terms)])
    (e:+ sum (e:* (car t) (monomial->expression (cdr t))))))
