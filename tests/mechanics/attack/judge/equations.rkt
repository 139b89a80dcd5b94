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
         "fault.rkt" "number.rkt" "point.rkt" "trials.rkt")

(provide judge-motions)

(define h (expt 2 -60))

;; The value of e with some symbols moved; raises 'no-value where there is none.
(define (moved e numbers . steps)
  (define v (number-at e (shifted numbers steps)))
  (if (rational? v) v (raise 'no-value)))

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

;; ---------------------------------------------------------------------------
;; Verdicts

;; Parameters are small numbers, states are generic ones.
(define ((draw-state state) symbols)
  (for/fold ([n (small-numbers symbols)]) ([s (in-list state)])
    (hash-set n s (/ (+ 1 (random 40)) (+ 7 (random 20))))))

(define (judge-motions question parts status assumed witness)
  (define-values (L other qs vs) (apply values parts))
  (define state (cons 't (append qs vs)))
  (define symbols (symbols-of L other (cons '+ state)))
  ;; -> are the same, or is conserved; 'open
  (define (holds? numbers)
    (define rows (motion-rows L qs vs numbers))
    (define others
      (if (eq? question 'equivalent)
          (motion-rows other qs vs numbers)
          (rate-row other qs vs numbers)))
    (cond [(not (and rows others)) 'open]
          [(eq? question 'equivalent)
           (if (ormap consistent? (list rows others)) (same-motions? rows others) 'open)]
          [(consistent? rows) (follows? others rows)]
          [else 'open]))
  (define ((judge wanted kind) numbers)
    (define v (holds? numbers))
    (cond [(eq? v 'open) #f]
          [(eq? v wanted) #t]
          [else (fault kind numbers #f #f)]))
  (define draw (draw-state state))
  (if (eq? status 'proved)
      (judged-at-points symbols assumed draw 30 (judge #t 'motions-differ))
      (judged-at-witness symbols witness draw (judge #f 'no-difference-at-witness))))
