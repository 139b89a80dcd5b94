#lang racket/base
;; Kernels of operations that have equations (generic/operation-equations.rkt).

(require racket/flonum
         "../flonum-functions.rkt" "jet-rows.rkt"
         "../../generic/operation-equations.rkt"
         "../../numeric/Taylor/kernels.rkt" "../../numeric/Taylor/pair-kernel.rkt")

(provide emit-law! emit-integral!)

;; id : of the value; arguments : ids; partner : the id of the partner, or #f if nothing
;; else needs it
(define (emit-law! r id name arguments partner)
  (define equations (equations-of name (length arguments)))
  (define p (and (pair? (cdr equations)) (if partner (row r partner) (spare-row r))))
  (define names (law r id arguments p (make-hasheq)))
  (define body (flonum-body name (length arguments)))
  (define x (row r id))
  (emit-start! r
    (case (length arguments)
      [(1) (define a (row-named names 'a))
           (lambda () (flvector-set! x 0 (body (flvector-ref a 0))))]
      [else (define-values (a b) (values (row-named names 'a) (row-named names 'b)))
            (lambda () (flvector-set! x 0 (body (flvector-ref a 0) (flvector-ref b 0))))]))
  (when p (emit-partner-start! names (cadr equations) p))
  (if (pair-of-equations? equations)
      (emit-pair! names equations)
      (begin
        (emit-equation! names (car equations) 'r)
        (when p (emit-equation! names (cadr equations) 'p)))))

;; arguments : ids of the operand and of the derivative there
(define (emit-integral! r id name arguments)
  (define names (law r id arguments #f (make-hasheq)))
  (define-values (x a) (values (row r id) (row-named names 'a)))
  (define body (flonum-body name 1))
  (emit-start! r (lambda () (flvector-set! x 0 (body (flvector-ref a 0)))))
  (emit-differential! names integral-equation 'r))

;; What the names in equations stand for.  derivatives : of r and p, name -> row
(struct law (rows id arguments p derivatives) #:authentic)

(define (row-named l name)
  (case name
    [(a) (row (law-rows l) (car (law-arguments l)))]
    [(b) (row (law-rows l) (cadr (law-arguments l)))]
    [(r) (row (law-rows l) (law-id l))]
    [else (law-p l)]))

(define (degree-named l name)
  (case name
    [(a) (degree (law-rows l) (car (law-arguments l)))]
    [(b) (degree (law-rows l) (cadr (law-arguments l)))]
    [else +inf.0]))

(define (derivative-named l name)
  (case name
    [(a) (derivative-row (law-rows l) (car (law-arguments l)))]
    [(b) (derivative-row (law-rows l) (cadr (law-arguments l)))]
    [else
     (hash-ref! (law-derivatives l) name
                (lambda ()
                  (define d (spare-row (law-rows l)))
                  (emit-in! l (derivative-kernel d (row-named l name)))
                  d))]))

(define (emit-in! l kernel) (emit! (law-rows l) (law-id l) kernel))

;; ---------------------------------------------------------------------------

(define (emit-partner-start! l e p)
  (define s (equation-start e))
  (define thunk
    (cond [s
           (define f (flonum-body (start-operation s) 1))
           (define x (row-named l (start-row s)))
           (lambda () (flvector-set! p 0 (f (flvector-ref x 0))))]
          [else
           (define (first name) (flvector-ref (row-named l name) 0))
           (lambda ()
             (define value
               (for/fold ([sum (real->double-flonum (equation-constant e))])
                         ([t (in-list (equation-terms e))])
                 (fl+ sum (fl* (factor-of t)
                               (fl* (first (term-left t)) (first (term-right t)))))))
             (flvector-set! p 0 value))]))
  (emit-start! (law-rows l) thunk))

(define (factor-of t) (real->double-flonum (term-factor t)))

;; r' = ± p a' and p' = ± r a', as of sin and cos
(define (pair-of-equations? equations)
  (and (pair? (cdr equations))
       (for/and ([e (in-list equations)] [left (in-list '(p r))])
         (and (equation-differential? e)
              (not (equation-leading e))
              (null? (cdr (equation-terms e)))
              (eq? left (term-left (car (equation-terms e))))
              (eq? 'a (term-right (car (equation-terms e))))))))

(define (emit-pair! l equations)
  (define factors (for/list ([e (in-list equations)]) (factor-of (car (equation-terms e)))))
  (emit-in! l (pair-kernel (row-named l 'r) (car factors) (row-named l 'p) (cadr factors)
                           (derivative-named l 'a) (degree-named l 'a))))

(define (emit-equation! l e unknown)
  (if (equation-differential? e)
      (emit-differential! l e unknown)
      (for ([kernel (in-list (product-kernels
                              (row-named l unknown)
                              (for/list ([t (in-list (equation-terms e))])
                                (product (factor-of t)
                                         (row-named l (term-left t))
                                         (degree-named l (term-left t))
                                         (row-named l (term-right t))
                                         (degree-named l (term-right t))))
                              #f))])
        (emit-in! l kernel))))

;; In terms of the row d of the derivative of the unknown.
(define (emit-differential! l e unknown)
  (define d (spare-row (law-rows l)))
  (define leading (equation-leading e))
  (define (base k) (and (> k 0) (itself d)))
  (for ([t (in-list (equation-terms e))] [k (in-naturals)])
    (define right (derivative-named l (term-right t)))
    (if (term-left t)
        (emit-in! l (differential-kernel d (factor-of t) right (degree-named l (term-right t))
                                         (row-named l (term-left t)) (base k)))
        (for ([kernel (in-list (sum-kernels d (list (weighed (factor-of t) right)) (base k)))])
          (emit-in! l kernel))))
  (when leading (emit-in! l (differential-leading-kernel d (row-named l leading))))
  (emit-in! l (integral-kernel (row-named l unknown) d))
  (hash-set! (law-derivatives l) unknown d))
