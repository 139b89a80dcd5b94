#lang racket/base
;; Sums and products of a graph, and their recurrences: products that only one sum is made of are
;; added up in place, products that share a factor are computed together, in one loop.

(require racket/flonum
         racket/list
         "jet-graph.rkt" "jet-nodes.rkt" "jet-coefficient-rows.rkt"
         "../../numeric/Taylor/recurrence-list.rkt")

(provide sole-uses factor-groups emit-sum! emit-product!)

;; ---------------------------------------------------------------------------
;; Products that go together

;; 'sum of products that only one sum is made of, which are added up there; else #f.
(define (sole-uses g)
  (define nodes (graph-nodes g))
  (define counts (make-vector (vector-length nodes) 0))
  (define in-sums (make-vector (vector-length nodes) 0))
  (define (count! v id) (vector-set! v id (+ 1 (vector-ref v id))))
  (for* ([n (in-vector nodes)] [id (in-list (node-operands n))])
    (count! counts id)
    (when (eq? 'linear (node-kind n)) (count! in-sums id)))
  (for ([id (in-vector (graph-outputs g))]) (count! counts id))
  (for/vector ([n (in-vector nodes)] [count (in-vector counts)] [in-sum (in-vector in-sums)])
    (and (eq? 'product (node-kind n)) (= 1 count in-sum) 'sum)))

;; First product of a group -> the factor and the others, that share it and have their other
;; factor by then.  Each id of the others -> 'done.
(define (factor-groups g degrees uses)
  (define nodes (graph-nodes g))
  (define groups (make-hasheqv))
  (define (operands id) (node-operands (vector-ref nodes id)))
  (define (free? id)
    (and (eq? 'product (node-kind (vector-ref nodes id)))
         (not (vector-ref uses id))
         (not (apply = (operands id)))
         (not (hash-ref groups id #f))
         (for/and ([x (in-list (operands id))]) (= +inf.0 (vector-ref degrees x)))))
  (for ([id (in-range (vector-length nodes))] #:when (free? id))
    (define (companions factor)
      (for/list ([k (in-range (+ id 1) (vector-length nodes))]
                 #:when (and (free? k)
                             (memv factor (operands k))
                             (< (other-factor (operands k) factor) id)))
        k))
    (define groups-here (map companions (operands id)))
    (define most (argmax length groups-here))
    (unless (null? most)
      (hash-set! groups id (cons (list-ref (operands id) (index-of groups-here most)) most))
      (for ([k (in-list most)]) (hash-set! groups k 'done))))
  groups)

(define (other-factor xs factor) (if (= (car xs) factor) (cadr xs) (car xs)))

;; ---------------------------------------------------------------------------
;; Recurrences

(define (emit-sum! r nodes id uses)
  (define n (vector-ref nodes id))
  (define x (row-of r id))
  (define constant (real->double-flonum (cadr n)))
  (define-values (products others) (partition (lambda (t) (vector-ref uses (car t))) (cddr n)))
  ;; one multiple of a row is where the first product begins
  (define (recurrences varying? base)
    (define kept
      (for/list ([t (in-list others)] #:when (or (not varying?) (> (degree r (car t)) 0)))
        (weighed (real->double-flonum (cdr t)) (row-of r (car t)))))
    (if (and (not base) (pair? products) (pair? kept) (null? (cdr kept)))
        (products-of r nodes x products (car kept))
        (let ([sums (sum-recurrences x kept base)])
          (append sums (products-of r nodes x products (if (pair? sums) (itself x) base))))))
  (unless (fl= constant 0.0) (emit-start! r (make-recurrence 'constant x constant)))
  (for ([start (in-list (recurrences #f (if (fl= constant 0.0) #f (itself x))))])
    (emit-start! r start))
  (apply emit! r id (recurrences #t #f)))

;; Recurrences of x = base + Σ c a b, squares among them.
(define (products-of r nodes x terms base)
  (define-values (squares others)
    (for/fold ([squares '()] [others '()]) ([t (in-list terms)])
      (define-values (a b) (apply values (node-operands (vector-ref nodes (car t)))))
      (define c (real->double-flonum (cdr t)))
      (if (and (= a b) (= +inf.0 (degree r a)))
          (values (cons (weighed c (row-of r a)) squares) others)
          (values squares (cons (product c (row-of r a) (row-of r b)) others)))))
  (define of-squares (square-recurrences x squares base))
  (append of-squares (product-recurrences x others (if (pair? of-squares) (itself x) base))))

(define (emit-product! r nodes id shared)
  (define group (hash-ref shared id #f))
  (define (emit-all! recurrences) (for ([x (in-list recurrences)]) (emit-always! r id x)))
  (cond [(eq? group 'done) (void)]
        [group
         (define factor (car group))
         (define targets
           (for/list ([k (in-list (cons id (cdr group)))])
             (define other (other-factor (node-operands (vector-ref nodes k)) factor))
             (target (row-of r k) (row-of r other))))
         (emit-all! (shared-product-recurrences targets (row-of r factor)))]
        [else (emit-all! (products-of r nodes (row-of r id) (list (cons id 1.0)) #f))]))
