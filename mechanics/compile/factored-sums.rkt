#lang racket/base
;; Common factors of the terms of sums: a b + a c = a (b + c).
;;
;; The factor of most terms first, then those of the rest (Horner's scheme for several
;; variables).  A term that is the factor alone gains nothing, and of two terms at least one
;; multiplication must be saved.  Values change by rounding.

(require racket/list
         "sum-terms.rkt" "sums-of-products.rkt")

(provide factor-sums)

;; outputs : sums -> id -> factor, for those that the outputs need, with factored sums; and the
;; outputs factored
(define (factor-sums f outputs)
  (define done (make-hasheq))
  (define new (make-hasheqv))
  (define (visit-sum! s)
    (or (hash-ref done s #f)
        (let ([r (factor-terms f s)])
          (hash-set! done s r)
          (for* ([t (in-list r)] [id (in-list (monomial t))]) (visit! id))
          r)))
  (define (visit! id)
    (unless (hash-ref new id #f)
      (define factor (factor-of f id))
      (hash-set! new id factor)
      (hash-set! new id (map-sums visit-sum! factor))))
  (define factored (map visit-sum! outputs))
  (values new factored))

(define (factor-terms f s)
  (define id (most-common-factor s))
  (cond [(not id) s]
        [else
         (define-values (with others) (partition (lambda (t) (memv id (monomial t))) s))
         (define quotient
           (for/list ([t (in-list with)]) (cons (coefficient t) (without id (monomial t)))))
         (define-values (c m) (split! f quotient))
         (factor-terms f (in-place-of with (cons c (with-factor id m)) s))]))

;; The sum with a term in the place of the first of some.
(define (in-place-of terms new s)
  (for/list ([t (in-list s)] #:unless (memq t (cdr terms))) (if (eq? t (car terms)) new t)))

;; -> id, or #f if there is none that saves a multiplication
(define (most-common-factor s)
  (define savings (make-hasheqv))
  (for* ([t (in-list s)]
         #:when (and (pair? (monomial t)) (pair? (cdr (monomial t))))
         [id (in-list (remove-duplicates (monomial t) eqv?))])
    (hash-update! savings id add1 0))
  (for*/fold ([best #f] [most 1] #:result best) ([t (in-list s)] [id (in-list (monomial t))])
    (define saved (hash-ref savings id 0))
    (if (> saved most) (values id saved) (values best most))))
