#lang racket/base
;; Programs: an expression graph as a list of flonum operations.
;;
;; A program has inputs, instructions and outputs.  An instruction or an
;; output refers to *operands*: a real number, or the place of an earlier
;; value, counted from the inputs on.  The same operation on the same operands
;; is done once, wherever in the graph it occurs (value numbering), numbers are
;; combined exactly until they meet a value, and instructions no output needs are left
;; out.

(require (only-in racket/list remove-duplicates)
         "program-builder.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/flat-graph.rkt"
         "../algebra/expression/operation.rkt" "../algebra/expression/pi.rkt"
         "../error/refusal.rkt"
         "../numeric/machine/straight-instruction.rkt")

(provide
 ;; the program
 (struct-out program) program-length instruction-at program-uses system-sizes
 (all-from-out "../numeric/machine/straight-instruction.rkt")
 ;; from expressions
 expressions->program
 ;; programs made of others
 builder->program write-expression! solve! solve-with!)

;; inputs : how many
;; instructions : vector; the value of the k-th has the place inputs + k
;; outputs : vector of operands
(struct program (inputs instructions outputs) #:prefab)

(define (program-length p) (vector-length (program-instructions p)))

;; The one whose value has the place k.
(define (instruction-at p k)
  (vector-ref (program-instructions p) (- k (program-inputs p))))

;; -> of each place, by how many operands and outputs it is used
(define (program-uses p)
  (define uses (make-vector (+ (program-inputs p) (program-length p)) 0))
  (define (use! x)
    (when (place? x)
      (vector-set! uses (place-index x) (+ 1 (vector-ref uses (place-index x))))))
  (for ([i (in-vector (program-instructions p))]) (for-each use! (instruction-operands i)))
  (for ([o (in-vector (program-outputs p))]) (use! o))
  uses)

;; -> the numbers of unknowns of its systems, each once
(define (system-sizes p)
  (remove-duplicates
   (for/list ([i (in-vector (program-instructions p))]
              #:when (eq? (instruction-operation i) 'solve))
     (system-unknowns i))
   eqv?))

;; inputs : symbols; es : expressions.  (fail e) is called, not to return, with
;; an expression that has no value: another symbol, an unknown function.
;; as-constant : real -> the constant for it in an instruction
(define (expressions->program inputs es fail #:constants [as-constant real->double-flonum])
  (define b (make-builder (length inputs) as-constant))
  (define leaves
    (for/hasheq ([s (in-list inputs)] [i (in-naturals)]) (values s (place i))))
  (define outputs (translate b (expressions->tape es) leaves fail))
  (builder->program b (length inputs) outputs))

;; The instructions written, as far as these operands need them.
(define (builder->program b inputs outputs)
  (prune (program inputs (written b) (list->vector outputs))))

;; -> the operand that an expression in the leaves, symbol -> operand, becomes
(define (write-expression! b e leaves)
  (car (translate b (expressions->tape (list e)) leaves
                  (lambda (e) (raise-argument-error 'write-expression! "no unknown" e)))))

;; ---------------------------------------------------------------------------
;; From a graph

;; All expressions on one tape: as operands of a node without meaning.
(define (expressions->tape es) (expression->tape (make-node op:up es)))

(define (translate b t leaves fail)
  (define items (tape-items t))
  (define last (- (vector-length items) 1))
  (define operands (make-vector last #f))
  (define (operands-of k)
    (for/list ([j (in-list (vector-ref (tape-operands t) k))]) (vector-ref operands j)))
  (for ([e (in-vector items 0 last)] [k (in-naturals)])
    (vector-set! operands k
                 (cond [(number? e) (real-or-fail e e fail)]
                       [(symbol? e) (or (hash-ref leaves e #f) (symbol-value! b e fail))]
                       [else (apply-head! b e (operands-of k) fail)])))
  (operands-of last))

(define (symbol-value! b e fail)
  (define m (pi-multiple e))
  (if m (pi-times! b m) (fail e)))

(define (real-or-fail x e fail) (if (real? x) x (fail e)))

(define (apply-head! b e operands fail)
  (define head (node-head e))
  (cond [(eq? head op:solution) (solve! b operands)]
        [(eq? head op:component) (list-ref (cadr operands) (car operands))]
        [(or (literal-head? head) (not (operation-numeric head))) (fail e)]
        [(andmap number? operands) (combine-numbers head operands e fail)]
        [(eq? head op:+) (fold-operands add! b operands)]
        [(eq? head op:*) (fold-operands multiply! b operands)]
        [(eq? head op:-) (subtract! b (car operands) (cadr operands))]
        [(eq? head op:/) (divide! b (car operands) (cadr operands))]
        [(eq? head op:expt) (power! b (car operands) (cadr operands))]
        [else (apply do! b (operation-name head) operands)]))

;; Operations of the algebra have no value outside their domain.
(define (combine-numbers head operands e fail)
  (define value
    (if-raised exn:fail:contract? #f
      (apply (operation-numeric head) operands)))
  (real-or-fail value e fail))

(define (fold-operands combine! b operands)
  (for/fold ([result (car operands)]) ([x (in-list (cdr operands))])
    (combine! b result x)))

;; A system of n equations is one instruction; n more read its solution, which
;; has no other place.  -> their places
(define (solve! b operands)
  (define n (integer-sqrt (length operands)))
  (define system (apply do! b 'solve operands))
  (for/list ([k (in-range n)]) (write! b (list 'component system k))))

;; entry : row column -> operand; right : row -> operand
;; -> the solution of the system of this matrix and right-hand side, a list of operands
(define (solve-with! b n entry right)
  (solve! b (for*/list ([row (in-range n)] [column (in-range (+ n 1))])
              (if (= column n) (right row) (entry row column)))))

;; ---------------------------------------------------------------------------
;; Instructions that outputs need

(define (prune p)
  (define n (program-inputs p))
  (define instructions (program-instructions p))
  (define needed (make-vector (vector-length instructions) #f))
  (define (need! operand)
    (define k (value-number operand n))
    (when k (vector-set! needed k #t)))
  (for ([o (in-vector (program-outputs p))]) (need! o))
  (for ([k (in-range (- (vector-length instructions) 1) -1 -1)]
        #:when (vector-ref needed k))
    (for-each need! (instruction-operands (vector-ref instructions k))))
  (renumber p needed))

(define (renumber p needed)
  (define n (program-inputs p))
  (define new-index (make-vector (vector-length needed) #f))
  (define kept
    (for/fold ([kept 0]) ([needed? (in-vector needed)] [k (in-naturals)] #:when needed?)
      (vector-set! new-index k (+ n kept))
      (+ kept 1)))
  (define (moved operand)
    (define k (value-number operand n))
    (if k (place (vector-ref new-index k)) operand))
  (program n
           (for/vector #:length kept
                       ([i (in-vector (program-instructions p))] [k? (in-vector needed)]
                        #:when k?)
             (moved-instruction i moved))
           (for/vector ([o (in-vector (program-outputs p))]) (moved o))))
