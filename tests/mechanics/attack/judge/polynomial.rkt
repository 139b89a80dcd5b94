#lang racket/base
;; Literal functions as the judge takes them: polynomials, whose derivatives are exact.
;;
;; The name of a function and a number that says which of its stand-ins is meant give
;; the coefficients, so that a function is the same wherever it occurs.

(require racket/list)

(provide parse-head stand-in term-coefficient term-exponents)

;; coefficient · x₁^n₁ x₂^n₂ ...
(struct term (coefficient exponents))

;; ---------------------------------------------------------------------------
;; Heads: V, (D V), ((expt D 2) V), ((partial 1) V), ((* (partial 0) (partial 1)) V)

;; -> name, (order of differentiation by each argument ...)
(define (parse-head head arity)
  (if (and (pair? head) (= 2 (length head)))
      (values (cadr head) (orders (car head) arity))
      (values head (make-list arity 0))))

(define (orders how arity)
  (define (unit i) (for/list ([k (in-range arity)]) (if (eqv? k i) 1 0)))
  (cond [(eq? how 'D) (unit 0)]
        [(eq? (car how) 'partial) (unit (cadr how))]
        [(eq? (car how) 'expt) (map (lambda (n) (* n (caddr how))) (orders (cadr how) arity))]
        [else (apply map + (map (lambda (h) (orders h arity)) (cdr how)))]))

;; ---------------------------------------------------------------------------
;; Polynomials

(define (scatter key)
  (for/fold ([h 99991]) ([c (in-string (format "~s" key))])
    (modulo (+ (* 69069 (bitwise-xor h (char->integer c))) 12345) 4294967291)))

;; All exponents of so many variables up to a degree in all.
(define (exponents arity degree)
  (if (zero? arity)
      '(())
      (for*/list ([n (in-range (+ degree 1))] [rest (exponents (- arity 1) (- degree n))])
        (cons n rest))))

;; -> (listof term): the function of that name and arity, differentiated so often
;; of a degree of which three derivatives leave something.
(define degree 4)
(define (stand-in name which orders)
  (define arity (length orders))
  (for/fold ([terms (for/list ([n (in-list (exponents arity degree))])
                      (term (/ (- (modulo (scatter (list name which n)) 41) 20) 8) n))])
            ([order (in-list orders)] [i (in-naturals)])
    (for/fold ([terms terms]) ([_ (in-range order)]) (differentiate-terms terms i))))

(define (differentiate-terms terms i)
  (for/list ([t (in-list terms)] #:unless (eqv? 0 (list-ref (term-exponents t) i)))
    (define n (list-ref (term-exponents t) i))
    (term (* n (term-coefficient t)) (list-set (term-exponents t) i (- n 1)))))
