#lang racket/base
;; The solution of the equations of constrained motion, written into a program:
;;
;;     M a − Jᵀ λ = f,    J a = c.
;;
;; Where M is seen to be diagonal, with numbers that are not zero, as it mostly is in coordinates
;; that need constraints, one equation is left for each constraint, (J M⁻¹ Jᵀ) λ = c − J M⁻¹ f.
;; Elsewhere all are solved together, which M needs no inverse for: a mass that varies may vanish
;; somewhere.

(require "../compile/program-builder.rkt" "../compile/program.rkt")

(provide constrained-solution!)

;; M : i j ↦ entry; J : list of rows; f : vector; c : list -> a, a list
(define (constrained-solution! b M J f c)
  (if (diagonal? M (vector-length f))
      (solution-by-inertia! b M J f c)
      (solution-together! b M J f c)))

(define (diagonal? M n)
  (for*/and ([i (in-range n)] [j (in-range (+ i 1))])
    (define x (M i j))
    (if (= i j) (and (real? x) (not (zero? x))) (eqv? 0 x))))

(define (solution-by-inertia! b M J f c)
  (define (over-mass v) (for/vector ([x (in-vector v)] [i (in-naturals)]) (divide! b x (M i i))))
  (define free (over-mass f))
  (define pulled (map over-mass J))
  (define S
    (for/vector ([g (in-list J)] [i (in-naturals)])
      (for/vector ([x (in-list pulled)] [_ (in-range (+ i 1))]) (product! b g x))))
  (define (entry i j) (vector-ref (vector-ref S (max i j)) (min i j)))
  (define right (for/list ([g (in-list J)] [x (in-list c)]) (subtract! b x (product! b g free))))
  (define multipliers (solve-each! b entry right))
  (for/list ([a (in-vector free)] [i (in-naturals)])
    (for/fold ([a a]) ([m (in-list multipliers)] [x (in-list pulled)])
      (add! b a (multiply! b m (vector-ref x i))))))

(define (product! b v w)
  (for/fold ([sum 0]) ([x (in-vector v)] [y (in-vector w)]) (add! b sum (multiply! b x y))))

(define (solve-each! b entry right)
  (define n (length right))
  (case n
    [(0) '()]
    [(1) (list (divide! b (car right) (entry 0 0)))]
    [else (solve-with! b n entry (lambda (i) (list-ref right i)))]))

;; The multipliers with the other sign, so that the matrix is symmetric.
(define (solution-together! b M J f c)
  (define n (vector-length f))
  (define rows (list->vector J))
  (define (constraint i k) (vector-ref (vector-ref rows (- i n)) k))
  (define (entry i j)
    (cond [(and (< i n) (< j n)) (M i j)]
          [(< j n) (constraint i j)]
          [(< i n) (constraint j i)]
          [else 0]))
  (define right (append (vector->list f) c))
  (for/list ([x (in-list (solve-each! b entry right))] [_ (in-range n)]) x))
