#lang racket/base
;; A point where all hypotheses of a claim hold, so that the claim is not empty: numbers for its
;; symbols, and for its unknown functions constants; or polynomials, where they are each other's
;; derivatives.
;;
;; The numbers are between 1 and 3/2, where sines and cosines are positive; or, if none of these
;; will do, such that all angles are 0; or others.

(require racket/list racket/string
         "Coq-names.rkt" "Coq-term.rkt"
         (only-in "../algebra/assumption/reference-point.rkt" real-value)
         "../algebra/expression/expression.rkt" "../algebra/expression/nodes.rkt"
         "../algebra/expression/operation.rkt"
         "../algebra/expression/read.rkt" "../algebra/expression/size.rkt"
         "../algebra/expression/substitute.rkt"
         "../algebra/expression/symbols.rkt"
         "../value/algebra.rkt")

(provide example-values put-numbers simpler value-text)

;; relations : ((sign left right) ...); ns : names
;; -> alist: symbol -> number, or function -> expression in `argument`
(define (example-values relations ns)
  (define unknowns (append (names-symbols ns) (names-functions ns)))
  (define differentiable
    (for*/hash ([d (in-list relations)] #:when (eq? (car d) 'is-derivative) [n (in-list (cdr d))])
      (values (function-of n) (derivative-orders n))))
  (define (at k) (with-polynomials (place unknowns k) differentiable))
  (define angles (append-map angles-in (append-map cdr relations)))
  (define (found good? [tries most-tries] [change values])
    (for*/first ([k (in-range tries)]
                 [point (in-value (change (at k)))]
                 #:when (and (good? point) (all-hold? relations point)))
      point))
  (define (all-acute? values) (andmap (lambda (a) (acute? a values)) angles))
  (define (all-vanish? values)
    (for/and ([a (in-list angles)]) (let ([x (value-at a values)]) (and x (zero? x)))))
  (define (still values)
    (for/fold ([values values]) ([s (in-list (remove-duplicates (append-map symbols-in angles)))])
      (define stiller (map (lambda (v) (if (eq? s (car v)) (cons s 0) v)) values))
      (if (all-hold? relations stiller) stiller values)))
  (or (found (lambda (values)
               (and (all-acute? values)
                    (all-hold? relations values)
                    (andmap (lambda (d) (easy? d values)) relations))))
      (found all-vanish? 60 still)
      (found all-acute?)
      (found (lambda (values) #t))
      (give-up "no point was found where all its hypotheses hold")))

;; The angles of which a sine, cosine or tangent is in e, an expression or a datum
(define (angles-in e)
  (if (node? e)
      (for/list ([n (in-list (nodes-in e))]
                 #:when (memq (node-head n) (list op:sin op:cos op:tan)))
        (car (node-args n)))
      '()))

;; The relation with numbers for its sines and cosines, near 0 and near 1: where all of these hold,
;; no more need be known of them.
(define (with-waves-anyhow d)
  (for*/list ([s (in-list '(1/100 99/100))] [c (in-list '(1/100 99/100))])
    (define (put e)
      (if (node? e)
          (in-place-of (for*/list ([n (in-list (nodes-in e))]
                                   [x (in-value (wave-value (node-head n) s c))] #:when x)
                         (cons n x))
                       e)
          e))
    (cons (car d) (map put (cdr d)))))

(define (wave-value head s c)
  (cond [(eq? head op:sin) s]
        [(eq? head op:cos) c]
        [(eq? head op:tan) (/ s c)]
        [else #f]))

;; Does it hold whatever the waves are in it, or in the simpler form of its left side?
(define (easy? d values)
  (define left (cadr d))
  (or (null? (angles-in left))
      (all-hold? (with-waves-anyhow d) values)
      (let ([simple (simpler (put-numbers left values))])
        (and simple
             (all-hold? (with-waves-anyhow (list* (car d) simple (cddr d))) values)))))

;; The form that e simplifies to, if it is smaller, else #f
(define (simpler e)
  (define simple (simplify-expression e))
  (and (< (expression-size simple) (expression-size e)) simple))

(define (acute? angle values)
  (define x (value-at angle values))
  (and x (<= 0 x) (< x 3/2)))

(define most-tries 400)

(define (place unknowns k)
  (for/list ([u (in-list unknowns)] [i (in-naturals)]) (cons u (coordinate i k))))

;; Functions that are derivatives of others with polynomials as values.  With E = 1 + x + x²/2 ...,
;; which ends where it is differentiated no more, they are r E(x); and of several variables
;; r E(x + y ...) + r (2 E(x) + E(y) ...), so that neither gradients of several functions depend on
;; each other nor second derivatives of one.
;; orders : function -> how often it is differentiated by each of its variables
(define (with-polynomials values orders)
  (define (of-name f)
    (for/list ([(g ns) (in-hash orders)]
               #:when (eq? (unknown-function-name f) (unknown-function-name g)))
      (apply + ns)))
  (for/list ([v (in-list values)] [i (in-naturals)])
    (define own (hash-ref orders (car v) #f))
    (if own
        (let ([root (findf (lambda (w) (and (unknown-function? (car w))
                                            (eq? (unknown-function-name (car w))
                                                 (unknown-function-name (car v)))))
                           values)])
          (cons (car v) (polynomials (cdr root) own (apply max (of-name (car v)))
                                     (index-of values root))))
        v)))

(define (polynomials r orders last-order i)
  (define left (- last-order (apply + orders)))
  (define xs (take arguments (length orders)))
  (define own
    (for/list ([x (in-list xs)] [k (in-naturals)]
               #:when (for/and ([n (in-list orders)] [l (in-naturals)]) (or (= l k) (= n 0))))
      (polynomial (if (= 0 (modulo (+ i k) (length xs))) (* 2 r) r) left x)))
  (cond [(null? (cdr xs)) (polynomial r left (car xs))]
        [(= left 0) (apply + r own)]
        [else (make-node op:+ (cons (polynomial r left (make-node op:+ xs)) own))]))

;; The variables of all functions
(define arguments (for/list ([_ (in-range 100)]) (string->uninterned-symbol "s")))

;; r + r x + (r / 2) x² ..., up to the power n
(define (polynomial r n x)
  (for/fold ([sum r] [c r] #:result sum) ([k (in-range 1 (+ n 1))])
    (define next (/ c k))
    (values (make-node op:+ (list sum (make-node op:* (cons next (make-list k x))))) next)))

;; As a term; of a function, of what it makes of its arguments
(define (value-text u x ns)
  (cond [(not (unknown-function? u)) (format "(~a)" (term x ns))]
        [else
         (define n (unknown-function-arity u))
         (define variables
           (cond [(number? x) (make-list n "_")]
                 [(= n 1) '("s")]
                 [else (for/list ([k (in-range 1 (+ n 1))]) (format "s_~a" k))]))
         (format "(fun ~a => ~a)" (string-join variables)
                 (term x (names-called ns (for/list ([s (in-list arguments)]
                                                     [variable (in-list variables)])
                                            (cons s variable)))))]))

;; The i-th number of the k-th place
(define (coordinate i k)
  (define (pick xs) (list-ref xs (modulo (+ i (* k (+ i 1)) (quotient k (+ i 2))) (length xs))))
  (cond [(eqv? k 0) 1]
        [(< k 4) (/ (+ i 1) (expt 4 k))]
        [(< k 12) (+ 1 (/ (modulo (+ 1 (* i (+ k 1))) 8) 16))]
        [(< k 60) (pick '(1 3/2 2 3 1/2 5 1/4 4))]
        [(< k 200) (pick '(1 -1 2 1/2 -2 0 3 -1/2 1/10))]
        [else (pick '(1/10 1/2 -1/4 1 1/100 -1/2 2 10 0 -1))]))

(define (all-hold? relations values)
  (for/and ([d (in-list relations)]) (holds? d values)))

(define (holds? d values)
  (or (eq? (car d) 'is-derivative) (compare d values)))

(define (compare d values)
  (define (side x) (value-at (if (expression? x) x (datum->expression x)) values))
  (define a (side (cadr d)))
  (define b (side (caddr d)))
  (and a b
       (case (car d)
         [(>) (> a (+ b margin))]
         [(<) (< a (- b margin))]
         [(>=) (>= a (- b margin))]
         [(<=) (<= a (+ b margin))]
         [(<>) (> (abs (- a b)) margin)]
         [else (< (abs (- a b)) margin)])))

(define margin 1e-9)

(define (value-at e values) (real-value e (lambda (leaf _) (value leaf values))))

(define (value leaf values)
  (define known (assoc leaf values))
  (define x (cdr (or known (assoc (function-of leaf) values))))
  (if (number? x) x (value-at (applied x leaf) values)))

;; The polynomial x at the arguments of n
(define (applied x n)
  (in-place x (for/list ([s (in-list arguments)] [a (in-list (flat-arguments n))]) (cons s a))))

;; e with other leaves for some, nothing evaluated
(define (in-place e leaves)
  (node-fold e
             (lambda (leaf) (let ([known (assq leaf leaves)]) (if known (cdr known) leaf)))
             (lambda (n parts) (make-node (node-head n) parts))))

;; e with numbers for its symbols and for its unknown functions applied, nothing evaluated
(define (put-numbers e values)
  (node-fold e
             (lambda (leaf) (let ([known (assoc leaf values)]) (if known (cdr known) leaf)))
             (lambda (n parts)
               (if (literal-head? (node-head n))
                   (applied (cdr (assoc (function-of n) values)) (make-node (node-head n) parts))
                   (make-node (node-head n) parts)))))
