#lang racket/base
;; Sums of products written as instructions, each factor once, where it is first needed.
;;
;; Terms with one number are added before they are multiplied by it.  A sum begins with a positive
;; term if there is one.  Where only the opposite of a factor is wanted, x − y say, it is written as
;; y − x.

(require racket/list
         "program-builder.rkt" "program.rkt" "sum-terms.rkt")

(provide make-writer write-sum!)

;; items : id -> factor (sum-terms.rkt), or (product id id), (monomial id ...);
;; short : monomial -> one that is written in its place; written : id -> operand
(struct writer (b items short written) #:authentic)

(define (make-writer b items short) (writer b items short (make-hasheqv)))

(define (item w id) (hash-ref (writer-items w) id))

(define (write-factor! w id)
  (define written (writer-written w))
  (or (hash-ref written id #f)
      (let ([x (factor->operand w (item w id))])
        (hash-set! written id x)
        x)))

(define (factor->operand w factor)
  (define b (writer-b w))
  (case (car factor)
    [(input) (place (cadr factor))]
    [(constant) (cadr factor)]
    [(sum) (write-sum! w (cdr factor))]
    [(monomial) (write-monomial! w (cdr factor))]
    [(product) (write-factors! w (cdr factor))]
    [(inverse) (divide! b 1 (write-sum! w (cdr factor)))]
    [(component) (list-ref (write-sum! w (caddr factor)) (cadr factor))]
    [else (write-operation! b (cadr factor)
                            (for/list ([s (in-list (cddr factor))]) (write-sum! w s)))]))

;; -> operand; of a system the list of its components'
(define (write-operation! b name operands)
  (case name
    [(multiply) (multiply! b (car operands) (cadr operands))]
    [(divide) (divide! b (car operands) (cadr operands))]
    [(solve) (solve! b operands)]
    [else (apply do! b name operands)]))

(define (write-monomial! w m) (write-factors! w (factors-of w m)))

(define (factors-of w m)
  (if (or (null? m) (null? (cdr m))) m (hash-ref (writer-short w) m)))

;; Divisors come at the end; c : the number that is divided where there is nothing else
(define (write-factors! w ids [c 1])
  (define b (writer-b w))
  (define-values (divisors factors) (partition (lambda (id) (inverse? w id)) ids))
  (define product
    (for/fold ([x c]) ([id (in-list factors)])
      (define y (write-factor! w id))
      (if (eqv? x 1) y (multiply! b x y))))
  (for/fold ([x product]) ([id (in-list divisors)])
    (divide! b x (write-sum! w (cdr (item w id))))))

(define (inverse? w id) (eq? 'inverse (car (item w id))))

;; ---------------------------------------------------------------------------
;; Sums

;; Terms whose coefficients are c or −c.
(struct group (c terms) #:authentic)

(define (write-sum! w s)
  (write-opposite! w s)
  (define groups (grouped s))
  (define first (and (pair? groups) (first-of groups)))
  (if first
      (for/fold ([sum (write-group! w first (sign first))]) ([g (in-list (remq first groups))])
        (define x (write-group! w g 1.0))
        (if (positive? (sign g)) (add! (writer-b w) sum x) (subtract! (writer-b w) sum x)))
      0))

(define (sign g) (if (< (coefficient (car (group-terms g))) 0.0) -1.0 1.0))

;; In the order of their first terms.
(define (grouped s)
  (define (apart? t) (or (unit? t) (null? (monomial t))))
  (let loop ([s s])
    (cond [(null? s) '()]
          [else
           (define c (abs (coefficient (car s))))
           (define (together? t) (and (not (apart? t)) (= c (abs (coefficient t)))))
           (define-values (same others)
             (if (apart? (car s)) (values '() (cdr s)) (partition together? (cdr s))))
           (cons (group c (cons (car s) same)) (loop others))])))

;; A number takes in its sign.
(define (first-of groups)
  (or (for/first ([g (in-list groups)] #:when (positive? (sign g))) g)
      (for/first ([g (in-list groups)] #:unless (= 1.0 (group-c g))) g)
      (car groups)))

;; s : 1.0 or −1.0, a factor of the value that is not that of the group's own sign
(define (write-group! w g s)
  (define b (writer-b w))
  (define terms (group-terms g))
  (define c (* s (group-c g)))
  (define (write-term! t) (write-monomial! w (monomial t)))
  (define (opposite? t) (negative? (* (sign g) (coefficient t))))
  (define ids (factors-of w (monomial (car terms))))
  (if (and (null? (cdr terms)) (andmap (lambda (id) (inverse? w id)) ids))
      (write-factors! w ids c)
      (for/fold ([sum (write-term! (car terms))]
                 #:result (multiply! b c sum))
                ([t (in-list (cdr terms))])
        (if (opposite? t) (subtract! b sum (write-term! t)) (add! b sum (write-term! t))))))

;; A term that is −1 times a product: if one of its factors is a sum that nothing has needed so
;; far, writes the opposite of that.
(define (write-opposite! w s)
  (define m (and (pair? s) (null? (cdr s)) (= -1.0 (coefficient (car s))) (monomial (car s))))
  (define id
    (for/first ([id (in-list (if m (factors-of w m) '()))]
                #:unless (hash-ref (writer-written w) id #f)
                #:when (eq? 'sum (car (item w id)))
                #:when (opposite-as-short? (cdr (item w id))))
      id))
  (when id
    (define opposite
      (for/list ([t (in-list (cdr (item w id)))]) (cons (- (coefficient t)) (monomial t))))
    (hash-set! (writer-written w) id (negate! (writer-b w) (write-sum! w opposite)))))

(define (opposite-as-short? s)
  (define (negative-term? t) (negative? (coefficient t)))
  (or (ormap (lambda (t) (or (null? (monomial t)) (not (unit? t)))) s)
      (and (ormap negative-term? s) (not (andmap negative-term? s)))))
