#lang racket/base
;; Are there no numbers at all for which relations hold?
;;
;; A point where they hold settles it.  Where none is found, the space of all unknowns is cut
;; into boxes.  A box in which the range of one relation leaves out its sign is empty; others
;; are halved, up to a limit.  If all are empty, the relations contradict each other; where
;; the limit comes first, nothing is known.

(require racket/list
         (only-in racket/math infinite?)
         "assumption-set.rkt" "interval.rkt" "leaf-bounds.rkt" "polynomial-range.rkt"
         "range.rkt" "reference-point.rkt"
         "../expression/expression.rkt" "../expression/pi.rkt")

(provide impossible-among)

;; relations : all in force; new : those of which one asks
;; -> the datums of relations that cannot all hold, or #f if there seem to be none
(define (impossible-among relations new)
  (define expressions (map relation-expression new))
  (define there (concerning (leaves-of expressions) relations))
  (define concerned (filter (lambda (r) (memq r there)) relations))
  (and (<= 1 (length concerned) most-relations)
       (not (find-reference expressions (assumptions concerned (hash) '() #t #f '())
                            (lambda (lookup) #t)))
       (empty? concerned)
       (fewest (map relation-datum concerned) concerned)))

(define most-relations 12)

;; The datums without those that the contradiction can do without.
(define (fewest data relations)
  (define (of kept) (filter (lambda (r) (member (relation-datum r) kept)) relations))
  (for/fold ([kept data]) ([d (in-list data)])
    (if (empty? (of (remove d kept))) (remove d kept) kept)))

;; ---------------------------------------------------------------------------
;; Boxes: tables of intervals

(define most-boxes 200)

(define (empty? relations)
  (let loop ([boxes (list (first-box relations))] [left most-boxes])
    (cond [(null? boxes) #t]
          [(or (eqv? left 0) (null? relations)) #f]
          [(excluded? (car boxes) relations) (loop (cdr boxes) (- left 1))]
          [else
           (define halves (halved (car boxes)))
           (and halves (loop (append halves (cdr boxes)) (- left 1)))])))

;; Bounds that π is part of are near it, not outside (leaf-bounds.rkt): they exclude nothing.
(define (first-box relations)
  (define table (bounds-from (filter-not speaks-of-pi? relations)))
  (for/hash ([leaf (in-hash-keys (leaves-of (map relation-expression relations)))])
    (values leaf (bounds-of table leaf))))

(define (speaks-of-pi? r) (some-leaf? pi-symbol? (relation-expression r)))

;; Does one of the relations hold nowhere in the box?
(define (excluded? box relations)
  (define (place leaf) (hash-ref box leaf))
  (or (for/or ([r (in-hash-values box)]) (> (interval-low r) (interval-high r)))
      (for/or ([r (in-list relations)])
        (define e (relation-expression r))
        (define (leaves-out? range)
          (eqv? 0 (bitwise-and (relation-signs r) (interval-signs range))))
        (or (leaves-out? (range-over e place))
            (let ([range (polynomial-range e place)]) (and range (leaves-out? range)))))))

;; The box in two, where it is widest, as seen from afar; #f if it is a point.
(define (halved box)
  (define-values (leaf width)
    (for/fold ([leaf #f] [width 1e-9]) ([(l r) (in-hash box)])
      (define w (apparent-width r))
      (if (> w width) (values l w) (values leaf width))))
  (cond [leaf
         (define r (hash-ref box leaf))
         (define m (middle r))
         (list (hash-set box leaf (interval (interval-low r) m))
               (hash-set box leaf (interval m (interval-high r))))]
        [else #f]))

;; Infinity is at the distance 1.
(define (apparent-width r)
  (define (seen x) (if (infinite? x) (if (> x 0) 1.0 -1.0) (exact->inexact (/ x (+ 1 (abs x))))))
  (- (seen (interval-high r)) (seen (interval-low r))))

(define (middle r)
  (define-values (low high) (interval-ends r))
  (cond [(and (infinite? low) (infinite? high)) 0]
        [(infinite? high) (if (< low 1) 1 (* 2 low))]
        [(infinite? low) (if (> high -1) -1 (* 2 high))]
        [else (/ (+ low high) 2)]))
