#lang racket/base
;; Proofs that a question has no point: boxes that fill space, on each of which it is
;; certain that something has no value or a relation does not hold.

(require "evaluate.rkt" "flonum.rkt" "interval.rkt" "point.rkt" "relation.rkt")

(provide empty?)

(define most-boxes 600)
(define least-edge 512.0)               ; beyond, exponentials are too large for flonums
(define narrowest 1e-3)

;; -> #t, or #f where it is not known
(define (empty? sides relations)
  (define all (append sides (relation-sides relations)))
  (define symbols (apply symbols-of all))
  (define edge (apply max least-edge (map (lambda (c) (* 4.0 c)) (apply constants-of all))))
  (and (<= (length symbols) 4)
       (let loop ([boxes (list (map (lambda (s) (interval (- edge) edge)) symbols))] [count 0])
         (cond [(null? boxes) #t]
               [(= count most-boxes) #f]
               [(excluded? sides relations symbols (car boxes)) (loop (cdr boxes) (+ count 1))]
               [else
                (define halves (split (car boxes)))
                (and halves (loop (append halves (cdr boxes)) (+ count 1)))]))))

(define (excluded? sides relations symbols box)
  (define where (make-point (for/hasheq ([s (in-list symbols)] [i (in-list box)]) (values s i)) 0))
  (or (for/or ([e (in-list sides)]) (part-without-value? e where))
      (broken? relations where flonum-intervals)))

;; One part may have none where that of another is not known.
(define (part-without-value? e where)
  (and (pair? e)
       (let ([v (value-at e where flonum-intervals)])
         (or (no-value? v)
             (and (too-hard? v)
                  (for/or ([a (in-list (cdr e))]) (part-without-value? a where)))))))

;; The widest side is cut, near its middle on a scale of sizes; or #f.
(define (split box)
  (define widest (if (null? box) 0.0 (apply max (map width box))))
  (and (> widest narrowest)
       (let cut ([before '()] [after box])
         (define i (car after))
         (if (= (width i) widest)
             (for/list ([half (in-list (halves i))])
               (append (reverse before) (list half) (cdr after)))
             (cut (cons i before) (cdr after))))))

(define (width i) (- (interval-high i) (interval-low i)))

(define (halves i)
  (define-values (a b) (values (interval-low i) (interval-high i)))
  (define m (middle a b))
  (list (interval a m) (interval m b)))

(define (middle a b)
  (cond [(< a 0.0 b) 0.0]
        [(and (>= a 0.0) (> b (* 16.0 (max a 0.5)))) (sqrt (* b (max a 0.25)))]
        [(<= b 0.0) (- (middle (- b) (- a)))]
        [else (* 0.5 (+ a b))]))
