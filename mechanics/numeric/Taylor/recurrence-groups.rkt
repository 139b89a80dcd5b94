#lang racket/base
;; Groups of recurrences that share a loop: of one kind, with sums over the same terms, and not
;; waiting for each other.
;;
;; A recurrence waits for those before it that make rows which it reads, or that read or make the
;; row which it makes.  Its *level* is one more than the greatest of theirs.

(require racket/list
         "convolution-code.rkt" "recurrence-list.rkt")

(provide recurrence-groups recurrence-terms recurrence-last single-sum? equal-parts)

;; -> list of lists of recurrences, in an order in which they may be computed
(define (recurrence-groups rs)
  (define levels (recurrence-levels rs))
  (append*
   (for/list ([level (in-list (group-by (lambda (r) (hash-ref levels r)) rs))])
     (append-map fitting-groups (group-by loop-of level)))))

;; The list of a level's recurrences of one loop, divided as the registers want it.
(define (fitting-groups rs)
  (cond [(or (not (loop-of (car rs))) (null? (cdr rs))) (map list rs)]
        [else
         (let loop ([rs rs] [group '()] [taken 0])
           (define room (if (null? rs) 0 (registers-of (car rs))))
           (cond [(null? rs) (list (reverse group))]
                 [(or (null? group) (<= (+ taken room) most-sums))
                  (loop (cdr rs) (cons (car rs) group) (+ taken room))]
                 [else (cons (reverse group) (loop rs '() 0))]))]))

(define (registers-of r)
  (* (length (recurrence-terms r)) (if (or (single-sum? r) (eq? 'power (recurrence-kind r))) 2 1)))

;; recurrence -> level, by levels that rise
(define (recurrence-levels rs)
  (define made (make-hasheqv))
  (define read (make-hasheqv))
  (define (of rows levels)
    (for/fold ([most 0]) ([k (in-list rows)]) (max most (hash-ref levels k 0))))
  (for/hasheq ([r (in-list rs)])
    (define-values (reads makes) (values (rows-in (recurrence-operands r)) (rows-made r)))
    (define level (+ 1 (max (of reads made) (of makes made) (of makes read))))
    (for ([k (in-list makes)]) (hash-set! made k level))
    (for ([k (in-list reads)]) (hash-set! read k (max level (hash-ref read k 0))))
    (values r level)))

;; Numbers of rows
(define (rows-in x)
  (cond [(row? x) (list (row-index x))]
        [(weighed? x) (rows-in (weighed-row x))]
        [(pair? x) (append (rows-in (car x)) (rows-in (cdr x)))]
        [else '()]))

(define (rows-made r)
  (define operands (recurrence-operands r))
  (rows-in
   (case (recurrence-kind r)
     [(shared-products) (first (equal-parts (cdr operands) 2))]
     [(pair turning) (list (first operands) (third operands))]
     [else (first operands)])))

;; ---------------------------------------------------------------------------
;; Loops

;; Recurrences of which this is equal have one loop; #f for those without.
(define (loop-of r)
  (case (recurrence-kind r)
    [(products shared-products) (list 'product (single-sum? r))]
    [(squares root power reciprocal) (recurrence-kind r)]
    [(pair differential leading) (list 'first (single-sum? r) (recurrence-last r))]
    [else #f]))

;; -> list of the rows (a . b) of each sum
(define (recurrence-terms r)
  (define operands (recurrence-operands r))
  (define-values (x y) (values (first operands) (and (pair? (cdr operands)) (second operands))))
  (case (recurrence-kind r)
    [(products)
     (define-values (_ as bs) (apply values (equal-parts (cddr operands) 3)))
     (map cons as bs)]
    [(squares) (for/list ([a (in-list (second (equal-parts (cddr operands) 2)))]) (cons a a))]
    [(shared-products)
     (for/list ([a (in-list (second (equal-parts (cdr operands) 2)))]) (cons a x))]
    [(ending-product) (list (cons (fourth operands) (sixth operands)))]
    [(differential) (list (cons (fourth operands) (sixth operands)))]
    [(pair) (list (cons (fifth operands) (third operands)) (cons (fifth operands) x))]
    [(leading reciprocal power) (list (cons y x))]
    [(differential-leading) (list (cons x y))]
    [(root) (list (cons x x))]
    [else '()]))

;; Has it one sum, which takes two registers?
(define (single-sum? r) (null? (cdr (recurrence-terms r))))

(define (recurrence-last r)
  (define operands (recurrence-operands r))
  (case (recurrence-kind r)
    [(differential) (fifth operands)]
    [(pair) (sixth operands)]
    [else (third operands)]))

;; A list of the parts of things, those of all things in turn -> that many lists
(define (equal-parts things count)
  (define size (quotient (length things) count))
  (let loop ([things things])
    (if (null? things) '() (cons (take things size) (loop (drop things size))))))
