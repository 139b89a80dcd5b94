#lang racket/base
;; Lagrange's equations of an S-expression as rows of numbers, by differences of many digits.
;;
;; At a state they are linear in the accelerations: M a + b = 0, with
;;
;;     M = ∂₂∂₂L,   b = ∂₂∂₁L v + ∂₂∂₀L − ∂₁L.
;;
;; A row (M₁ ... Mₙ, b₁) stands for each.  Two Lagrangians have the same motions if their rows
;; span the same space; a quantity is conserved if its rate, a row too, lies in that of L.

(require racket/list
         "evaluate.rkt" "fixed.rkt" "point.rkt")

(provide motion-rows rate-row same-motions? follows? consistent?)

(define A (fixed-intervals 400))
(define h (expt 2 -60))

;; State variables: t, coordinates and velocities, as symbols.

;; -> value of e at numbers with some symbols moved; raises #f where there is none
(define (moved e numbers . steps)
  (define v
    (value-at e (make-point (for/fold ([n numbers]) ([s (in-list steps)])
                              (hash-update n (car s) (lambda (x) (+ x (cdr s)))))
                            0)
              A))
  (if (value? v) (value->exact v A) (raise 'no-value)))

(define (slope e u numbers)
  (/ (- (moved e numbers (cons u h)) (moved e numbers (cons u (- h)))) (* 2 h)))

(define (second-slope e u w numbers)
  (define (corner i j) (moved e numbers (cons u (* i h)) (cons w (* j h))))
  (/ (- (+ (corner 1 1) (corner -1 -1)) (corner 1 -1) (corner -1 1)) (* 4 h h)))

;; -> rows, or #f where L has no value
(define (motion-rows L qs vs numbers)
  (rows-or-false
   (for/list ([q (in-list qs)] [v (in-list vs)])
     (append (for/list ([w (in-list vs)]) (second-slope L v w numbers))
             (list (- (+ (for/sum ([p (in-list qs)] [w (in-list vs)])
                           (* (second-slope L v p numbers) (hash-ref numbers w)))
                         (second-slope L v 't numbers))
                      (slope L q numbers)))))))

;; dQ/dt = ∂₂Q a + ∂₁Q v + ∂₀Q
(define (rate-row Q qs vs numbers)
  (rows-or-false
   (append (for/list ([w (in-list vs)]) (slope Q w numbers))
           (list (+ (for/sum ([q (in-list qs)] [w (in-list vs)])
                      (* (slope Q q numbers) (hash-ref numbers w)))
                    (slope Q 't numbers))))))

(define-syntax-rule (rows-or-false rows)
  (with-handlers ([(lambda (e) (eq? e 'no-value)) (lambda (e) #f)]) rows))

;; ---------------------------------------------------------------------------
;; Spaces of rows

(define (same-motions? rows others)
  (and (for/and ([r (in-list others)]) (follows? r rows))
       (for/and ([r (in-list rows)]) (follows? r others))))

(define (follows? row rows) (= (rank (cons row rows)) (rank rows)))

;; Are there accelerations that satisfy them?
(define (consistent? rows) (= (rank rows) (rank (map (lambda (r) (drop-right r 1)) rows))))

(define negligible 1e-9)

(define (rank rows)
  (cond [(or (null? rows) (null? (car rows))) 0]
        [else
         (define pivot (argmax (lambda (r) (abs (car r))) rows))
         (if (< (abs (car pivot)) negligible)
             (rank (map cdr rows))
             (+ 1 (rank (for/list ([r (in-list (remq pivot rows))])
                          (define factor (/ (car r) (car pivot)))
                          (for/list ([x (in-list (cdr r))] [y (in-list (cdr pivot))])
                            (- x (* factor y)))))))]))
