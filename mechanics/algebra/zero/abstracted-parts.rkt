#lang racket/base
;; Proving less about more: parts of an expression taken for symbols.
;;
;; If (A + B)(A - B) - (A² - B²) is zero whatever A and B are, it is zero for the
;; long sums they stand for, which need not be expanded.  Which parts can be
;; taken for symbols is tried out modulo a prime, the whole still vanishing, from
;; the leaves up, many at once: it is guessing, and no part of the proof.  From the
;; root down a determinant, say, might become a symbol too early, and its relation to
;; its minors would be lost.
;;
;; Parts with equal residues are taken for one symbol.  That they are equal is
;; then to be proved as well; so large a part that nothing would be gained is
;; left alone.

(require racket/list
         "fingerprint.rkt"
         "../expression/expression.rkt" "../expression/flat-graph.rkt"
         "../expression/substitute.rkt")

(provide abstract)

;; -> an expression in which parts of that on the tape are symbols of their own, and
;; differences; if it and they are zero, so is the whole.  #f and '() if there is
;; nothing to gain.
(define (abstract t)
  (define cuts (choose-cuts t (candidate-classes t (tape-classes t))))
  (define general
    (and (pair? cuts)
         (expression-with-cuts t (cuts-vector t cuts))))
  (if (and general (much-shorter? general t))
      (values general
              (for*/list ([group (in-list cuts)] [k (in-list (cdr group))])
                (e:- (item t k) (item t (car group)))))
      (values #f '())))

;; Tapes this long must lose more than half of their nodes.
(define short 2000)

(define (much-shorter? e t)
  (define n (tape-length (expression->tape e)))
  (or (< n short) (< (* 2 n) (tape-length t))))

(define (item t k) (vector-ref (tape-items t) k))

;; ---------------------------------------------------------------------------
;; Candidates

;; The groups of nodes that are used more than once, inner ones first.  A group is the list of
;; the places of items of equal value, the first of which stands for all.
(define (candidate-classes t classes)
  (define n (tape-length t))
  (define sizes (subgraph-sizes t))
  (define uses (make-vector n 0))
  (for* ([ks (in-vector (tape-operands t))] [k (in-list ks)])
    (define c (vector-ref classes k))
    (when c (vector-set! uses c (+ 1 (vector-ref uses c)))))
  (define (class k) (vector-ref classes k))
  (define (worthwhile? group)
    (and (> (vector-ref uses (car group)) 1)
         (ormap (lambda (k) (node? (item t k))) group)
         (or (null? (cdr group))
             (< (* 5 (apply max (map (lambda (k) (vector-ref sizes k)) group)))
                (* 2 n)))))
  (define groups (group-by class (filter class (range n)) eqv?))
  (sort (filter worthwhile? groups) < #:key (lambda (group) (apply max group))))

;; How many items each has below it, at most: shared ones count as often as they
;; are used, up to the length of the tape.
(define (subgraph-sizes t)
  (define n (tape-length t))
  (define sizes (make-vector n 1))
  (for ([ks (in-vector (tape-operands t))] [k (in-naturals)])
    (vector-set! sizes k
                 (min n (for/fold ([size 1]) ([j (in-list ks)]) (+ size (vector-ref sizes j))))))
  sizes)

;; ---------------------------------------------------------------------------
;; Choosing

;; How many items may be evaluated altogether while choosing.
(define effort 2000000)

;; All candidates at once, else the first half and then the second.
(define (choose-cuts t candidates)
  (define left (quotient effort (tape-length t)))
  (define (vanishes? groups)
    (set! left (- left 1))
    (and (> left 0)
         (vanishes-with-cuts? t (cuts-vector t groups))))
  (let choose ([candidates candidates] [kept '()])
    (cond [(null? candidates) kept]
          [(vanishes? (append candidates kept)) (append candidates kept)]
          [(null? (cdr candidates)) kept]
          [else
           (define-values (inner outer) (split-at candidates (quotient (length candidates) 2)))
           (choose outer (choose inner kept))])))

(define (cuts-vector t groups)
  (define cuts (make-vector (tape-length t) #f))
  (for* ([group (in-list groups)] [k (in-list group)] #:when (node? (item t k)))
    (vector-set! cuts k (car group)))
  cuts)

;; ---------------------------------------------------------------------------

;; A cut node is its representative, if that is a leaf, or a symbol for that.
(define (expression-with-cuts t cuts)
  (define known (make-hasheqv))
  (define (value-of k) (hash-ref! known k (lambda () (new-value k))))
  (define (new-value k)
    (define e (item t k))
    (define cut (vector-ref cuts k))
    (cond [(and cut (not (eqv? cut k))) (value-of cut)]
          [cut (string->uninterned-symbol (format "part~a" k))]
          [(node? e) (rebuild (node-head e) (map value-of (vector-ref (tape-operands t) k)))]
          [else e]))
  (value-of (- (tape-length t) 1)))
