#lang racket/base
;; Tapes: an expression's graph written out once, operands before the nodes they
;; are operands of, and equal nodes once if that is asked for.
;;
;; A walk over a tape is a loop over vectors by place, without a table of nodes
;; met; so an expression to be evaluated several times is put on a tape first.

(require racket/fixnum
         "expression.rkt" "operation.rkt")

(provide (struct-out tape) expression->tape expression->plain-tape tape-length tape->expression
         graph-size)

;; items : vector of numbers, symbols and nodes, the whole expression last
;; heads : vector of the heads of nodes, #f for numbers and symbols: loops that need
;; only heads do not read the nodes from memory
;; operands : vector of lists of places, those of the operands of each node
(struct tape (items heads operands) #:authentic)

(define (tape-length t) (vector-length (tape-items t)))

;; The number of nodes, numbers and symbols of an expression
(define (graph-size e) (if (node? e) (tape-length (expression->plain-tape e)) 1))

;; Nodes with the same head and the same operands, in any order they may have, are
;; one item.
(define (expression->tape e) (make-tape e (make-merged)))

;; Equal nodes stay separate items if they were made separately: half the work, for
;; callers that use the tape once.
(define (expression->plain-tape e) (make-tape e #f))

;; Each tape has a number, which the marks of its nodes carry.  Another thread that makes
;; a tape at the same time may overwrite a mark; the node is then looked up once more.
(define numbers (box 0))

(define (next-number)
  (define n (unbox numbers))
  (if (box-cas! numbers n (fxand (fx+ n 1) most-tapes)) n (next-number)))

(define place-bits 28)
(define most-places (fx- (fxlshift 1 place-bits) 1))
(define most-tapes (fx- (fxlshift 1 31) 1))

;; A tape in the making.  leaves : number or symbol -> place; keys : of the items, where
;; equal nodes are merged; merged : table of the nodes met, or #f
(struct recorder (number leaves items heads operands keys merged) #:authentic)

(define (make-tape e merged)
  (define r
    (recorder (next-number) (make-hasheqv)
              (make-buffer) (make-buffer) (make-buffer) (make-buffer) merged))
  (place r e)
  (tape (buffer->vector (recorder-items r))
        (buffer->vector (recorder-heads r))
        (buffer->vector (recorder-operands r))))

;; -> the place of e, recorded if it was not
(define (place r e)
  (cond [(not (node? e)) (place-leaf r e)]
        [else
         (define mark (node-mark e))
         (if (and mark (fx= (recorder-number r) (fxrshift mark place-bits)))
             (fxand mark most-places)
             (place-node r e (places r (node-args e))))]))

(define (places r es)
  (if (null? es)
      '()
      (let ([k (place r (car es))])
        (cons k (places r (cdr es))))))

(define (place-leaf r e)
  (hash-ref! (recorder-leaves r) e (lambda () (record! r e '() '()))))

(define (place-node r e ks)
  (define k
    (if (recorder-merged r)
        (merged-place r e ks)
        (record! r e ks #f)))
  (set-node-mark! e (fxior (fxlshift (recorder-number r) place-bits) k))
  k)

(define (merged-place r e ks)
  (define merged (recorder-merged r))
  (define key (if (commutative? (node-head e)) (sort-places ks) ks))
  (or (merged-ref merged (recorder-items r) (recorder-keys r) e key)
      (let ([k (record! r e ks key)])
        (merged-add! merged e k)
        k)))

(define (record! r e ks key)
  (buffer-add! (recorder-operands r) ks)
  (buffer-add! (recorder-heads r) (and (node? e) (node-head e)))
  (when (recorder-merged r) (buffer-add! (recorder-keys r) key))
  (buffer-add! (recorder-items r) e))

;; An expression equal to that on the tape, in which equal nodes are the same.
(define (tape->expression t)
  (define n (tape-length t))
  (define nodes (make-vector n #f))
  (for ([e (in-vector (tape-items t))] [ks (in-vector (tape-operands t))] [k (in-naturals)])
    (define args (for/list ([j (in-list ks)]) (vector-ref nodes j)))
    (vector-set! nodes k (if (node? e) (with-operands e args) e)))
  (vector-ref nodes (- n 1)))

;; ks in ascending order; most nodes have two operands.
(define (sort-places ks)
  (cond [(or (null? ks) (null? (cdr ks))) ks]
        [(null? (cddr ks)) (if (fx<= (car ks) (cadr ks)) ks (list (cadr ks) (car ks)))]
        [else (sort ks fx<)]))

;; ---------------------------------------------------------------------------
;; Vectors that grow

(struct buffer (items count) #:mutable #:authentic)

(define (make-buffer) (buffer (make-vector 64 #f) 0))

(define (buffer-ref b k) (vector-ref (buffer-items b) k))

;; -> the place of the new item
(define (buffer-add! b x)
  (define n (buffer-count b))
  (when (fx= n (vector-length (buffer-items b)))
    (set-buffer-items! b (resized (buffer-items b) n (fx* 2 n))))
  (vector-set! (buffer-items b) n x)
  (set-buffer-count! b (fx+ n 1))
  n)

(define (buffer->vector b) (resized (buffer-items b) (buffer-count b) (buffer-count b)))

(define (resized v count size)
  (define new (make-vector size #f))
  (vector-copy! new 0 v 0 count)
  new)

;; ---------------------------------------------------------------------------
;; The items that are nodes, found by head and operands: open addressing by the
;; hash that equal nodes share.

;; A node's key is the list of its operands' places, in order if they commute.
;; places : fxvector, -1 where there is none; hashes : of the items there
(struct merged (places hashes count) #:mutable #:authentic)

(define (make-merged) (merged (make-fxvector 1024 -1) (make-fxvector 1024) 0))

;; Similar sums have neighbouring hashes; multiplication scatters them.
(define-syntax-rule (first-slot h mask)
  (let ([low (fx* (fxand (fxxor h (fxrshift h 24)) #xFFFFFFF) #x2C9277B5)])
    (fxand (fxxor low (fxrshift low 28)) mask)))

;; -> place or #f
(define (merged-ref m items keys e key)
  (define places (merged-places m))
  (define hashes (merged-hashes m))
  (define mask (fx- (fxvector-length places) 1))
  (define h (expression-hash e))
  (define (same? k)
    (and (same-places? (buffer-ref keys k) key)
         (head=? (node-head (buffer-ref items k)) (node-head e))))
  (let probe ([i (first-slot h mask)])
    (define k (fxvector-ref places i))
    (cond [(fx= k -1) #f]
          [(and (fx= h (fxvector-ref hashes i)) (same? k)) k]
          [else (probe (fxand (fx+ i 1) mask))])))

(define (same-places? ks js)
  (cond [(null? ks) (null? js)]
        [(null? js) #f]
        [else (and (fx= (car ks) (car js)) (same-places? (cdr ks) (cdr js)))]))

(define (merged-add! m e k)
  (when (fx> (fx* 2 (merged-count m)) (fxvector-length (merged-places m))) (widen! m))
  (insert! (merged-places m) (merged-hashes m) (expression-hash e) k)
  (set-merged-count! m (fx+ 1 (merged-count m))))

(define (widen! m)
  (define places (merged-places m))
  (define hashes (merged-hashes m))
  (define size (fx* 4 (fxvector-length places)))
  (set-merged-places! m (make-fxvector size -1))
  (set-merged-hashes! m (make-fxvector size))
  (for ([k (in-fxvector places)] [h (in-fxvector hashes)] #:unless (fx= k -1))
    (insert! (merged-places m) (merged-hashes m) h k)))

(define (insert! places hashes h k)
  (define mask (fx- (fxvector-length places) 1))
  (let probe ([i (first-slot h mask)])
    (cond [(fx= -1 (fxvector-ref places i))
           (fxvector-set! places i k)
           (fxvector-set! hashes i h)]
          [else (probe (fxand (fx+ i 1) mask))])))
