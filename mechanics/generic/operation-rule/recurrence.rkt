#lang racket/base
;; Taylor coefficients of the value of an operation from those of its arguments.
;;
;; Let a = a₀ + a₁ε + a₂ε² + …, and r = op(a).  Every operation has a rule for
;; its derivative, r' = g(a, r) a', and to compare coefficients in it gives
;; k r_k = Σ_{j=1..k} j a_j g_{k-j}: with the coefficients of g, which only need
;; those of r below k, any operation can be done to order n.  That is how it is
;; done unless it has an equation of its own (operation-equations.rkt), without functions but
;; r and a partner: order n then costs n² multiplications and no more.
;;
;; Truncated Taylor numbers and power series run the same recurrences.  Those see
;; coefficients as functions of the index, exact 0 from a length on, which is
;; +inf.0 for an endless series.

(require "../kind.rkt" "../arithmetic.rkt" "../elementary.rkt" "operation-equations.rkt"
         "../../operation/operation-column.rkt")

(provide recurrence-of (struct-out recurrence) (struct-out rows)
         (struct-out solution) (struct-out partner)
         weighted-convolution)

;; reduce : arguments -> the value by other operations, or #f
;; length : lengths of the arguments -> length of the value
;; choose : first coefficient and length of each argument -> solution, or #f where
;;          there is no recurrence
(struct recurrence (reduce length choose) #:authentic)

;; step : of the value; partner : of the operation, or #f.  A step gives coefficient k > 0
;; from those below k of the value, and of its partner: (step k rows).
(struct solution (step partner) #:authentic)

;; start : first coefficient of the argument and of the value -> that of the partner, of
;; which (step k rows) gives the others
(struct partner (start step) #:authentic)

;; Coefficients as functions of the index, of the arguments, a and b with their lengths, of
;; the value r and its partner p; #f for a missing one.
(struct rows (a la b lb r p) #:authentic)

(define (row rs name)
  (case name [(a) (rows-a rs)] [(b) (rows-b rs)] [(r) (rows-r rs)] [else (rows-p rs)]))
(define (row-length rs name)
  (case name [(a) (rows-la rs)] [(b) (rows-lb rs)] [else +inf.0]))

;; The recurrence of the operation of this record, or #f.
(define (recurrence-of op) (hash-ref recurrences (generic-op-name op) #f))

(define (endless . lengths) +inf.0)

(define (make-recurrence choose #:reduce [reduce #f] #:length [length endless])
  (recurrence reduce length choose))

;; ---------------------------------------------------------------------------
;; Sums of products

;; Σ a_j b_{k-j} for j from `low` to `high`, where neither is known to be 0.
(define (convolution a la b lb k [low 0] [high k])
  (define from (if (< k lb) low (max low (add1 (- k lb)))))
  (define to (if (< high la) high (sub1 la)))
  (let loop ([j from] [sum 0])
    (if (> j to)
        sum
        (let ([x (a j)] [y (b (- k j))])
          (loop (add1 j)
                (if (or (eqv? x 0) (eqv? y 0)) sum (g:+ sum (g:* x y))))))))

;; Σ_{j=1..high} j a_j b_{k-j}: for high = k it is k times coefficient k of the
;; integral of a' b.
(define (weighted-convolution a la b k [high k])
  (convolution (lambda (j) (g:* j (a j))) la b +inf.0 k 1 high))

;; ---------------------------------------------------------------------------
;; Equations solved for coefficient k of an unknown, the row of that name

(define (equation->step e unknown)
  (define solve
    (if (equation-differential? e) (solve-differential e unknown) (solve-algebraic e unknown)))
  (define right-hand-side (sum-of (map term->coefficient (terms-of e))))
  (lambda (k rs) (solve (right-hand-side k rs) k rs)))

(define (terms-of e)
  (for/list ([t (in-list (equation-terms e))]) (cons (equation-differential? e) t)))

(define (sum-of parts)
  (if (null? (cdr parts))
      (car parts)
      (let ([rest (sum-of (cdr parts))])
        (lambda (k rs) (g:+ ((car parts) k rs) (rest k rs))))))

;; -> (k rows -> coefficient k of the term, k times that in a differential equation)
(define (term->coefficient pair)
  (define-values (differential? t) (values (car pair) (cdr pair)))
  (define-values (left right) (values (term-left t) (term-right t)))
  (define part
    (cond [(not left)
           (if differential?
               (lambda (k rs) (g:* k ((row rs right) k)))
               (lambda (k rs) ((row rs right) k)))]
          [differential?
           (lambda (k rs)
             (weighted-convolution (row rs right) (row-length rs right) (row rs left) k))]
          [else
           (lambda (k rs)
             (convolution (row rs left) (row-length rs left)
                          (row rs right) (row-length rs right) k))]))
  (times (term-factor t) part))

(define (times factor part)
  (case factor
    [(1) part]
    [(-1) (lambda (k rs) (g:negate (part k rs)))]
    [else (lambda (k rs) (g:* factor (part k rs)))]))

(define (solve-algebraic e unknown)
  (define l (equation-leading e))
  (cond [(not l) (lambda (x k rs) x)]
        [(eq? l unknown)
         (lambda (x k rs)
           (define r (row rs l))
           (g:/ (g:- x (convolution r +inf.0 r +inf.0 k 1 (sub1 k))) (g:* 2 (r 0))))]
        [else
         (lambda (x k rs)
           (define b (row rs l))
           (g:/ (g:- x (convolution (row rs unknown) +inf.0 b (row-length rs l) k 0 (sub1 k)))
                (b 0)))]))

(define (solve-differential e unknown)
  (define l (equation-leading e))
  (if l
      (lambda (x k rs)
        (define a (row rs l))
        (g:/ (g:- x (weighted-convolution (row rs unknown) +inf.0 a k (sub1 k)))
             (g:* k (a 0))))
      (lambda (x k rs) (g:/ x k))))

;; ---------------------------------------------------------------------------
;; Operations

;; First coefficients of the argument and of the value -> that of the partner.
(define (equation->start e)
  (define s (equation-start e))
  (cond [s (define f (generic-op-procedure (elementary-operation (start-operation s) 1)))
           (if (eq? (start-row s) 'a) (lambda (a r) (f a)) (lambda (a r) (f r)))]
        [else
         (lambda (a r)
           (define (first name) (if (eq? name 'a) a r))
           (for/fold ([sum (equation-constant e)]) ([t (in-list (equation-terms e))])
             (g:+ sum (g:* (term-factor t)
                           (g:* (first (term-left t)) (first (term-right t)))))))]))

(define (equations->solution equations)
  (define other (and (pair? (cdr equations)) (cadr equations)))
  (solution (equation->step (car equations) 'r)
            (and other (partner (equation->start other) (equation->step other 'p)))))

(define (function-recurrence name)
  (define s (equations->solution (equations-of name 1)))
  ;; of two arguments, as those of an angle, by the rule
  (make-recurrence (case-lambda [(a0 la) s] [(a0 la b0 lb) #f])))

(define (arithmetic-recurrence name length)
  (define s (equations->solution (equations-of name 2)))
  (make-recurrence (lambda (a0 la b0 lb) s) #:length length))

;; Whole powers are products, which also serves where the base begins with 0.
(define power-recurrence
  (make-recurrence
   (lambda (b0 lb n0 ln)
     (define start (comparand b0))
     (cond [(and (number? start) (zero? start)) #f]
           [(eqv? ln 1) (equations->solution (power-equations n0))]
           [(eqv? lb 1) (equations->solution (exponential-equations (g:log b0)))]
           [else #f]))
   #:reduce (lambda (b n) (power-by-products b n))))

;; A whole number written as a decimal is an exponent like others, but where the base begins with
;; 0.0 its rule would come to 0.0 times 0.0 to the power of −1.
(define (power-by-products b n)
  (cond [(exact-nonnegative-integer? n) (whole-power b n)]
        [(not (and (whole-exponent? n) (begins-with-0.0? b))) #f]
        [(= n 0.0) 1.0]
        [else (g:* 1.0 (whole-power b (inexact->exact n)))]))

(define (begins-with-0.0? b)
  (define x (comparand b))
  (and (flonum? x) (= x 0.0)))

(define (whole-power b n)
  (cond [(eqv? n 0) 1]
        [(eqv? n 1) b]
        [(even? n) (whole-power (g:* b b) (quotient n 2))]
        [else (g:* b (whole-power b (sub1 n)))]))

(define recurrences
  (for/fold ([all (hasheq '+ (arithmetic-recurrence '+ max)
                          '- (arithmetic-recurrence '- max)
                          '* (arithmetic-recurrence '* (lambda (la lb) (+ la lb -1)))
                          '/ (arithmetic-recurrence '/ (lambda (la lb) (if (eqv? lb 1) la +inf.0)))
                          'expt power-recurrence)])
            ([name (in-list (operation-names function))] #:when (equations-of name 1))
    (hash-set all name (function-recurrence name))))
