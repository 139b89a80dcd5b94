#lang racket/base
;; Expressions: numbers, symbols, and immutable nodes over them.
;;
;; A node holds a head (an operation or a literal head), its operands, and a
;; hash computed when it is made.  Code that runs on symbols builds *graphs* of
;; nodes with much sharing; written out as trees they can be exponentially
;; large.  Hence every walk is memoised on node identity, and equality is
;; decided in time of the graph.
;;
;; `+` and `*` commute: their hash does not see the order of operands and
;; equality compares them as multisets, while the operands keep the order in
;; which they were written, for reading.
;;
;; The constructors do cheap work only: they fold numbers, drop neutral
;; elements and flatten short sums and products.  Everything dearer is
;; simplification.

(require "constant-range.rkt" "operation.rkt" "short-list.rkt" "write.rkt"
         "../../error/complain.rkt")

(provide
 ;; kinds
 expression? symbolic? node? node-head node-args
 make-node with-operands headed? operands-of expression=? expression-hash
 node-mark set-node-mark!
 ;; forms that were asked for
 requested? requested-assumptions request-form
 ;; constructors
 e:+ e:- e:* e:/ e:expt e:negate e:apply
 sum? arithmetic-node? integer-power? commutative?
 ;; walks
 expression->datum make-memo node-fold some-leaf? all-leaves?)

;; ---------------------------------------------------------------------------
;; The node

;; mark : the place of the node on the tape made last, with that tape's number (flat-graph.rkt)
(struct node (head args hash [mark #:auto #:mutable])
  #:authentic
  #:property prop:custom-print-quotable 'never
  #:property prop:custom-write
  (lambda (n port mode) (write-datum (expression->datum n) port))
  #:property prop:equal+hash
  (list (lambda (a b recur) (expression=? a b))
        (lambda (n recur) (node-hash n))
        (lambda (n recur) (node-hash n))))

(define (make-node head args)
  (node head args (hash-node head args)))

;; The node with these operands; itself if they are its own.
(define (with-operands n args)
  (if (andmap eq? args (node-args n)) n (make-node (node-head n) args)))

;; A node in a form that was asked for (expanded, factored ...), with the assumptions made to find
;; it: a node like any other, but shown without being simplified again.
(struct requested node (assumptions) #:authentic)

(define (request-form e assumptions)
  (if (node? e)
      (requested (node-head e) (node-args e) (node-hash e) assumptions)
      e))

;; A value the algebra can hold.
(define (expression? x) (or (number? x) (symbolic? x)))
(define (symbolic? x) (or (symbol? x) (node? x)))

;; ---------------------------------------------------------------------------
;; Hash and equality

(define-syntax-rule (mask n) (bitwise-and n #xFFFFFFFFFFFF))

(define (expression-hash e)
  (if (node? e) (node-hash e) (mask (equal-hash-code e))))

(define (commutative? head) (or (eq? head op:+) (eq? head op:*)))

;; Mixed so that two equal operands do not just double the sum: in towers of
;; squares that would lose a bit at every level.
(define (scatter k) (bitwise-xor (* 3 k) (arithmetic-shift k -23)))

(define (hash-node head args)
  (define start (mask (head-hash head)))
  (if (commutative? head) (hash-in-any-order args start) (hash-in-order args start)))

(define (hash-in-any-order args h)
  (if (null? args)
      h
      (hash-in-any-order (cdr args) (mask (+ h (scatter (expression-hash (car args))))))))

(define (hash-in-order args h)
  (if (null? args)
      h
      (hash-in-order (cdr args) (mask (+ (* 31 h) (expression-hash (car args)))))))

;; Pairs already found equal are remembered, so that two graphs built apart are
;; compared in time proportional to their nodes.
(define (expression=? a b) (same? a b (box #f)))

;; seen : box of a table node -> nodes it is equal to, #f as long as there are none
(define (same? a b seen)
  (cond [(eq? a b) #t]
        [(and (node? a) (node? b))
         (and (= (node-hash a) (node-hash b))
              (head=? (node-head a) (node-head b))
              (or (seen? a b seen)
                  (and (same-operands? a b seen)
                       (begin (learn! a b seen) #t))))]
        [else (eqv? a b)]))

(define (seen? a b seen)
  (define table (unbox seen))
  (and table (memq b (hash-ref table a '())) #t))

(define (learn! a b seen)
  (unless (unbox seen) (set-box! seen (make-hasheq)))
  (hash-update! (unbox seen) a (lambda (bs) (cons b bs)) '()))

(define (same-operands? a b seen)
  (or (same-list? (node-args a) (node-args b) seen)
      (and (commutative? (node-head a))
           (same-multiset? (node-args a) (node-args b) seen))))

(define (same-list? as bs seen)
  (cond [(null? as) (null? bs)]
        [(null? bs) #f]
        [else (and (same? (car as) (car bs) seen) (same-list? (cdr as) (cdr bs) seen))]))

(define (same-multiset? as bs seen)
  (cond [(null? as) (null? bs)]
        [else
         (define rest (remove-one (car as) bs seen))
         (and rest (same-multiset? (cdr as) rest seen))]))

;; bs without one that is equal to a, or #f
(define (remove-one a bs seen)
  (cond [(null? bs) #f]
        [(same? a (car bs) seen) (cdr bs)]
        [else
         (define rest (remove-one a (cdr bs) seen))
         (and rest (cons (car bs) rest))]))

;; ---------------------------------------------------------------------------
;; Constructors

;; Longer operands are kept nested: flattening them again and again would make
;; n additions cost n².
(define flatten-limit 8)

(define (exact-zero? x) (eq? x 0))
(define (exact-one? x) (eq? x 1))

(define (headed? e head) (and (node? e) (eq? (node-head e) head)))

;; The operands of e if it has this head, else e alone.
(define (operands-of e head) (if (headed? e head) (node-args e) (list e)))

;; The same, if they are few.
(define (operands e head)
  (if (and (headed? e head) (short? (node-args e) flatten-limit))
      (node-args e)
      (list e)))

(define (e:+ a b)
  (cond [(and (number? a) (number? b)) (+ a b)]
        [(exact-zero? a) b]
        [(exact-zero? b) a]
        [(number? b) (e:+ b a)]
        [(number? a) (add-constant a b)]
        [else
         (define-values (m as) (split-constant a op:+ 0))
         (define-values (n bs) (split-constant b op:+ 0))
         (define c (+ m n))
         (if (sum-fits? c m n)
             (rejoin op:+ c 0 (append as bs))
             (rejoin op:+ m 0 (append as (list b))))]))

(define (add-constant m e)
  (define-values (n rest) (split-constant e op:+ 0))
  (define c (+ m n))
  (if (sum-fits? c m n)
      (rejoin op:+ c 0 rest)
      (make-node op:+ (list m e))))

(define (e:* a b)
  (cond [(and (number? a) (number? b)) (* a b)]
        [(exact-zero? a) 0]
        [(exact-zero? b) 0]
        [(exact-one? a) b]
        [(exact-one? b) a]
        [else
         (define-values (m as) (split-constant a op:* 1))
         (define-values (n bs) (split-constant b op:* 1))
         (define c (* m n))
         (cond [(product-fits? c m n) (rejoin op:* c 1 (append as bs))]
               [(number? b) (make-node op:* (list b a))]
               [else (rejoin op:* m 1 (append as (list b)))])]))

;; e as a number and its other operands under this head.
(define (split-constant e head neutral)
  (cond [(number? e) (values e '())]
        [(headed? e head)
         (define args (operands e head))
         (if (number? (car args))
             (values (car args) (cdr args))
             (values neutral args))]
        [else (values neutral (list e))]))

(define (rejoin head constant neutral args)
  (cond [(null? args) constant]
        [(and (eq? head op:*) (exact-zero? constant)) 0]
        [(eqv? constant neutral)
         (if (null? (cdr args)) (car args) (make-node head args))]
        [else (make-node head (cons constant args))]))

(define (e:- a b)
  (cond [(and (number? a) (number? b)) (- a b)]
        [(exact-zero? b) a]
        [(exact-zero? a) (e:negate b)]
        [(number? b) (e:+ (- b) a)]
        [(and (expression=? a b) (plainly-defined? a)) 0]
        [else (make-node op:- (list a b))]))

;; Has e a value wherever its symbols have values?  A root or a logarithm may have none anywhere,
;; and then a - a is not 0.  Only the first nodes of e are looked at.
(define (plainly-defined? e)
  (let look ([es (list e)] [n 0])
    (cond [(or (null? es) (eqv? n most-nodes)) #t]
          [(not (node? (car es))) (look (cdr es) n)]
          [(partial? (car es)) #f]
          [else (look (append (node-args (car es)) (cdr es)) (+ n 1))])))

(define most-nodes 40)

(define real-in-part (operations-where real))

(define (partial? n)
  (define head (node-head n))
  (or (memq head real-in-part)
      (and (eq? head op:/) (sum? (cadr (node-args n))))
      (and (eq? head op:expt)
           (let ([k (cadr (node-args n))])
             (and (number? k)
                  (or (not (integer? k)) (and (negative? k) (sum? (car (node-args n))))))))))

(define (e:negate a) (e:* -1 a))

(define (e:/ a b)
  (cond [(number? b)
         (when (exact-zero? b) (complain-of-division a))
         (define c (/ 1 b))
         (cond [(reciprocal-fits? c b) (e:* c a)]
               [(number? a) (/ a b)]
               [else (make-node op:/ (list a b))])]
        [(exact-zero? a) 0]
        [(and (expression=? a b) (not (sum? b)) (plainly-defined? b)) 1]
        [else (make-node op:/ (list a b))]))

;; Is e a sum?  Only simplification tells whether a sum is 0.
(define (sum? e) (or (headed? e op:+) (headed? e op:-)))

(define (complain-of-division a)
  (raise-division-by-zero
   '/ (format "division by zero\n  in: (/ ~a 0)" (datum->text (expression->datum a)))))

(define (e:expt b n)
  (cond [(and (number? b) (number? n)) (expt b n)]
        [(exact-zero? n) 1]
        [(exact-one? n) b]
        [(exact-one? b) 1]
        [(and (exact-zero? b) (exact-positive-integer? n)) 0]
        [(and (exact-integer? n) (headed? b op:expt)
              (exact-integer? (cadr (node-args b))))
         (e:expt (car (node-args b)) (* n (cadr (node-args b))))]
        [else (make-node op:expt (list b n))]))

;; A sum, difference, product, quotient or whole power?
(define (arithmetic-node? n)
  (or (memq (node-head n) (list op:+ op:- op:* op:/)) (integer-power? n)))

;; b^n with a whole number n?
(define (integer-power? n)
  (and (eq? (node-head n) op:expt) (exact-integer? (cadr (node-args n)))))

;; An operation on expressions; numbers are computed.
(define (e:apply op . args)
  (define numeric (operation-numeric op))
  (if (and numeric (andmap number? args))
      (apply numeric args)
      (make-node op args)))

;; ---------------------------------------------------------------------------
;; Walks

;; (make-memo) -> (node thunk -> value): thunk's value, computed once a node.
(define (make-memo)
  (define table (make-hasheq))
  (lambda (n thunk)
    (define known (hash-ref table n table))       ; faster than hash-ref!
    (cond [(eq? known table)
           (define value (thunk))
           (hash-set! table n value)
           value]
          [else known])))

;; Fold a graph from its leaves: (leaf e) for numbers and symbols, and
;; (combine node values) for a node whose operands have these values.
(define (node-fold e leaf combine)
  (define memo (make-memo))
  (let walk ([e e])
    (if (node? e)
        (memo e (lambda () (combine e (map walk (node-args e)))))
        (leaf e))))

;; Does the predicate hold of some number or symbol in e?  Of all of them?
(define (some-leaf? good? e)
  (let/ec return
    (node-fold e (lambda (x) (let ([v (good? x)]) (and v (return v)))) (lambda (n parts) #f))))
(define (all-leaves? good? e) (not (some-leaf? (lambda (x) (not (good? x))) e)))

;; The plain S-expression.  Shared nodes give shared pairs.
(define (expression->datum e)
  (node-fold e
             values
             (lambda (n args) (cons (head->datum (node-head n)) args))))
