#lang racket/base
;; Recurrences of operations that have equations (generic/operation-rule/operation-equations.rkt).

(require "../flonum-functions.rkt" "jet-coefficient-rows.rkt"
         "../../generic/operation-rule/operation-equations.rkt"
         "../../numeric/Taylor/recurrence-list.rkt")

(provide emit-law! emit-integral! emit-value!)

;; id : of the value; arguments : ids; partner : the id of the partner, or #f if nothing
;; else needs it
(define (emit-law! r id name arguments partner)
  (define equations (equations-of name (length arguments)))
  (define p (and (pair? (cdr equations)) (if partner (row-of r partner) (spare-row r))))
  (define names (law r id arguments p (make-hasheq)))
  (emit-value! r id name arguments)
  (when p (emit-partner-start! names (cadr equations) p))
  (if (pair-of-equations? equations)
      (emit-pair! names equations)
      (begin
        (emit-equation! names (car equations) 'r)
        (when p (emit-equation! names (cadr equations) 'p)))))

;; arguments : ids of the operand and of the derivative there
(define (emit-integral! r id name arguments)
  (emit-value! r id name (list (car arguments)))
  (emit-differential! (law r id arguments #f (make-hasheq)) integral-equation 'r))

;; The value of the operation where the motion begins.
(define (emit-value! r id name arguments)
  (emit-start! r (apply value-recurrence (row-of r id) name
                        (for/list ([a (in-list arguments)]) (row-of r a)))))

(define (value-recurrence x name . arguments)
  (apply make-recurrence 'value x name (flonum-body name (length arguments)) arguments))

;; Meanings of the names in equations.  derivatives : of r and p, name -> row
(struct law (rows id arguments p derivatives) #:authentic)

;; The id of the argument of that name, or #f
(define (argument-named l name)
  (case name
    [(a) (car (law-arguments l))]
    [(b) (cadr (law-arguments l))]
    [else #f]))

(define (row-named l name)
  (if (eq? name 'p)
      (law-p l)
      (row-of (law-rows l) (or (argument-named l name) (law-id l)))))

(define (derivative-named l name)
  (define id (argument-named l name))
  (define (make)
    (define d (spare-row (law-rows l)))
    (emit-in! l (make-recurrence 'derivative d (row-named l name)))
    d)
  (if id (derivative-row (law-rows l) id) (hash-ref! (law-derivatives l) name make)))

(define (emit-in! l . recurrences) (apply emit! (law-rows l) (law-id l) recurrences))

;; ---------------------------------------------------------------------------

(define (emit-partner-start! l e p)
  (define s (equation-start e))
  (define (start! recurrence) (emit-start! (law-rows l) recurrence))
  (cond [s (start! (value-recurrence p (start-operation s) (row-named l (start-row s))))]
        [else
         (start! (make-recurrence 'constant p (real->double-flonum (equation-constant e))))
         (for-each start! (equation-products l e p (itself p)))]))

;; base + Σ factor left right
(define (equation-products l e r base)
  (product-recurrences
   r
   (for/list ([t (in-list (equation-terms e))])
     (product (factor-of t) (row-named l (term-left t)) (row-named l (term-right t))))
   base))

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
  (emit-in! l (pair-recurrence (row-named l 'r) (car factors) (row-named l 'p) (cadr factors)
                               (derivative-named l 'a))))

(define (emit-equation! l e unknown)
  (if (equation-differential? e)
      (emit-differential! l e unknown)
      (apply emit-in! l (equation-products l e (row-named l unknown) #f))))

;; In terms of the row d of the derivative of the unknown.
(define (emit-differential! l e unknown)
  (define d (spare-row (law-rows l)))
  (define leading (equation-leading e))
  (define (base k) (and (> k 0) (itself d)))
  (for ([t (in-list (equation-terms e))] [k (in-naturals)])
    (define right (derivative-named l (term-right t)))
    (if (term-left t)
        (emit-in! l (differential-recurrence d (factor-of t) right (row-named l (term-left t))
                                             (base k)))
        (apply emit-in! l (sum-recurrences d (list (weighed (factor-of t) right)) (base k)))))
  (when leading (emit-in! l (make-recurrence 'differential-leading d (row-named l leading))))
  (emit-in! l (make-recurrence 'integral (row-named l unknown) d))
  (hash-set! (law-derivatives l) unknown d))
