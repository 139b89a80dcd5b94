#lang racket/base
;; The terms of a sum that was read, as one datum: a number of two parts, a quaternion
;; a + b 𝐢 + c 𝐣, the power series x ↦ a + b x + c x².

(require (only-in racket/list append-map))

(provide terms->datum unit-datum series->datum negative quotient-of)

;; terms : data, as they were read
(define (terms->datum terms)
  (cond [(ormap unit-of terms) (quaternion-datum terms)]
        [(null? (cdr terms)) (car terms)]
        [(complex-parts? terms) (apply + (reverse terms))]
        [else (cons '+ terms)]))

;; The real and the imaginary part of one number
(define (complex-parts? terms)
  (and (= 2 (length terms)) (andmap number? terms)
       (real? (car terms)) (not (real? (cadr terms)))))

(define (negative d)
  (cond [(and (number? d) (not (eqv? d 0))) (- d)]
        [(and (pair? d) (eq? (car d) '*) (eqv? (cadr d) -1)) (product-datum (cddr d))]
        [(and (pair? d) (eq? (car d) '*) (real? (cadr d))) (list* '* (- (cadr d)) (cddr d))]
        [(and (pair? d) (eq? (car d) '*)) (list* '* -1 (cdr d))]
        [else (list '* -1 d)]))

(define (quotient-of a b)
  (if (and (exact-integer? a) (exact-integer? b) (not (eqv? b 0))) (/ a b) (list '/ a b)))

;; ---------------------------------------------------------------------------
;; Quaternions

(define units
  (hash "𝐢" '(quaternion 0 1 0 0) "𝐣" '(quaternion 0 0 1 0) "𝐤" '(quaternion 0 0 0 1)))

(define (unit-datum text) (hash-ref units text))

(define (unit? d) (and (pair? d) (eq? (car d) 'quaternion)))

;; The unit that the term is a multiple of, or #f
(define (unit-of t)
  (cond [(unit? t) t]
        [(and (pair? t) (eq? (car t) '*)) (unit-of (car (reverse t)))]
        [else #f]))

(define (quaternion-datum terms)
  (define (part unit)
    (sum-datum (for/list ([t (in-list terms)] #:when (equal? (unit-of t) unit)) (without-unit t))))
  (list 'quaternion (part #f) (part (unit-datum "𝐢")) (part (unit-datum "𝐣"))
        (part (unit-datum "𝐤"))))

(define (without-unit t)
  (cond [(unit? t) 1]
        [(unit-of t) (product-datum (reverse (cdr (reverse (cdr t)))))]
        [else t]))

(define (sum-datum terms) (if (null? terms) 0 (terms->datum terms)))

(define (product-datum factors)
  (define needed (remove 1 factors))
  (cond [(null? needed) 1]
        [(null? (cdr needed)) (car needed)]
        [else (cons '* needed)]))

;; ---------------------------------------------------------------------------
;; Power series

;; #f where the body is no polynomial in x that is written term by term
(define (series->datum x body)
  (define monomials (map (lambda (t) (monomial t x)) (terms-of body)))
  (and (symbol? x)
       (andmap values monomials)
       (cons 'power-series (coefficients monomials))))

(define (coefficients monomials)
  (for/list ([k (in-range (+ 1 (apply max (map car monomials))))])
    (sum-datum (for/list ([m (in-list monomials)] #:when (= (car m) k)) (cdr m)))))

(define (terms-of d)
  (if (and (pair? d) (eq? (car d) '+)) (append-map terms-of (cdr d)) (list d)))

;; (degree . coefficient) of a term, or #f where x is elsewhere than in a power
(define (monomial t x)
  (cond [(eq? t x) (cons 1 1)]
        [(not (occurs? x t)) (cons 0 t)]
        [else (compound-monomial (car t) (cdr t) x)]))

(define (compound-monomial head parts x)
  (case head
    [(*) (product-of-monomials (map (lambda (p) (monomial p x)) parts))]
    [(/) (let ([above (monomial (car parts) x)])
           (and above (not (occurs? x (cadr parts)))
                (cons (car above) (list '/ (cdr above) (cadr parts)))))]
    [(expt) (and (eq? (car parts) x) (exact-nonnegative-integer? (cadr parts))
                 (cons (cadr parts) 1))]
    [else #f]))

(define (product-of-monomials ms)
  (and (andmap values ms)
       (cons (apply + (map car ms)) (product-datum (map cdr ms)))))

(define (occurs? x d)
  (if (pair? d) (or (occurs? x (car d)) (occurs? x (cdr d))) (eq? x d)))
