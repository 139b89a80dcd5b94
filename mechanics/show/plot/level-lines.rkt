#lang racket/base
;; The lines on which a function has a value, from its values at the nodes of a grid.
;;
;; A line crosses a side of a square of the grid where the function is above the level at one end
;; and not at the other.  A square has none, two or four such sides, and within it the line goes
;; from one to the other; of four the mean of the corners says which two are joined.  So a crossing
;; has at most two neighbours, one in each square that has this side, and a line is followed from
;; neighbour to neighbour until it ends, at the edge of the grid, or closes.

(require racket/flonum
         "picture-layer.rkt"
         "../../numeric/finite-number.rkt")

(provide level-lines)

;; bounds : of the grid
;; -> lists of points, pairs of flonums; of a closed line the last is the first
(define (level-lines f bounds)
  (define neighbours (crossing-neighbours f))
  (define point (crossing-point f bounds))
  (define (followed start)
    (let follow ([crossing start] [points '()])
      (define next (hash-ref neighbours crossing '()))
      (hash-remove! neighbours crossing)
      (define all (cons (point crossing) points))
      (define on (for/first ([n (in-list next)] #:when (hash-has-key? neighbours n)) n))
      (cond [on (follow on all)]
            [(and (memv start next) (pair? (cdr points))) (cons (point start) all)]
            [else all])))
  (define (lines-from which?)
    (for/list ([crossing (in-list (sort (hash-keys neighbours) <))]
               #:when (which? (hash-ref neighbours crossing '())))
      (followed crossing)))
  (define open-lines (lines-from (lambda (next) (and (pair? next) (null? (cdr next))))))
  (append open-lines (lines-from pair?)))

;; ---------------------------------------------------------------------------
;; Crossings are numbers: of node k twice k for the side to the right, one more for that upwards.

;; -> hash from each crossing to its neighbours, one or two
(define (crossing-neighbours f)
  (define-values (n rows level) (values (field-count f) (field-rows f) (field-level f)))
  (define neighbours (make-hasheqv))
  (define (join! a b)
    (hash-update! neighbours a (lambda (others) (cons b others)) '())
    (hash-update! neighbours b (lambda (others) (cons a others)) '()))
  (for ([lower (in-vector rows)] [upper (in-vector rows 1)] [j (in-naturals)])
    (for ([a (in-vector lower)] [b (in-vector lower 1)]
          [d (in-vector upper)] [c (in-vector upper 1)] [i (in-naturals)])
      (when (and (or (across? a b level) (across? b c level) (across? c d level))
                 (finite? a) (finite? b) (finite? c) (finite? d))
        (join-in-square! join! (+ i (* n j)) n (list a b c d) level))))
  neighbours)

;; corners : values, counterclockwise; the first is that of the node
(define (join-in-square! join! node n corners level)
  (define-values (a b c d) (apply values corners))
  (define-values (below right above left)
    (values (* 2 node) (+ 3 (* 2 node)) (* 2 (+ node n)) (+ 1 (* 2 node))))
  (define crossed
    (for/list ([side (in-list (list below right above left))]
               [p (in-list corners)] [q (in-list (list b c d a))]
               #:when (across? p q level))
      side))
  (cond [(null? (cddr crossed)) (join! (car crossed) (cadr crossed))]
        [(across? a (* 0.25 (+ a b c d)) level) (join! below left) (join! right above)]
        [else (join! below right) (join! above left)]))

(define-syntax-rule (across? a b level) (not (eq? (fl> a level) (fl> b level))))

;; -> the point of a crossing: the function is linear along a side
(define ((crossing-point f bounds) crossing)
  (define-values (n level) (values (field-count f) (field-level f)))
  (define-values (x-min x-max y-min y-max) (apply values bounds))
  (define-values (j i) (quotient/remainder (quotient crossing 2) n))
  (define-values (di dj) (if (even? crossing) (values 1 0) (values 0 1)))
  (define (value i j) (vector-ref (vector-ref (field-rows f) j) i))
  (define a (value i j))
  (define share (/ (- level a) (- (value (+ i di) (+ j dj)) a)))
  (define (place low high k) (+ low (* (- high low) (/ k (- n 1.0)))))
  (cons (place x-min x-max (+ i (* di share))) (place y-min y-max (+ j (* dj share)))))
