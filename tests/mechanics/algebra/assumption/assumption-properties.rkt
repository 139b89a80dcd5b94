#lang racket/base
;; Random expressions under random assumptions: real values are kept wherever all
;; that the result rests on holds, and the same again when done again.

(require racket/list
         mechanics/algebra/assumption/assumption-set
         mechanics/algebra/assumption/reference-point
         mechanics/algebra/simplify/declare-relations
         mechanics/algebra/expression/expression
         mechanics/algebra/expression/operation
         mechanics/algebra/assumption/relation
         mechanics/algebra/assumption/signs
         mechanics/algebra/simplify/simplify-expression
         "../../support/checks.rkt" "../../support/close.rkt" "../../support/random.rkt"
         "../../support/evaluate.rkt")

(define (choose xs) (list-ref xs (random (length xs))))

;; ---------------------------------------------------------------------------
;; Expressions whose form depends on signs

(define symbols '(a b c x))

(define (random-signed depth)
  (define (sub) (random-signed (- depth 1)))
  (if (zero? depth)
      (choose symbols)
      (case (random 9)
        [(0) (e:+ (sub) (sub))]
        [(1) (e:* (sub) (sub))]
        [(2) (make-node op:sqrt (list (squared (sub))))]
        [(3) (make-node op:sqrt (list (e:* (squared (sub)) (choose symbols))))]
        [(4) (make-node op:abs (list (e:* (sub) (choose symbols))))]
        [(5) (make-node op:log (list (e:* (squared (sub)) (squared (choose symbols)))))]
        [(6) (make-node op:sqrt (list (e:* (choose symbols) (choose symbols))))]
        [(7) (e:/ (sub) (make-node op:sqrt (list (squared (choose symbols)))))]
        [else (make-node op:expt (list (e:expt (choose symbols) 3) (choose '(1/2 1/3 2/3))))])))

(define (squared e) (e:expt e 2))

;; ---------------------------------------------------------------------------
;; Assumptions, and points where they hold

(define (random-relations)
  (remove-duplicates
   (append
    (for/list ([s (in-list symbols)] #:when (zero? (random 2))) (list (choose '(> < >= <=)) s 0))
    (if (zero? (random 2)) (list (list (choose '(> <)) 'a 'b)) '()))))

(define (declare relations)
  (with-handlers ([exn:algebra:contradiction? (lambda (x) #f)])
    (declare-relations no-assumptions relations)))

(define (random-point)
  (for/list ([s (in-list symbols)]) (cons s (* (choose '(1 -1)) (+ 0.3 (* 2 (random)))))))

(define (holds? d point)
  (define r (read-relation d))
  (define v (evaluate-expression (relation-expression r) (point-lookup point)))
  (and (real? v) (signs-within? (number-signs v) (relation-signs r))))

;; Some points where all of these hold.
(define (points-where relations)
  (for*/list ([_ (in-range 60)] [p (in-value (random-point))]
              #:when (for/and ([d (in-list relations)]) (holds? d p)))
    p))

;; The value, perhaps complex; #f where there is none.
(define (value e point)
  (with-handlers ([exn:fail? (lambda (x) #f)])
    (define v (evaluate-expression e (point-lookup point)))
    (and (rational? (magnitude v)) (< (magnitude v) 1e9) v)))

;; Are all roots, powers and logarithms in e real at the point?
(define (real-throughout? e point)
  (for/and ([n (in-list (nodes-with-branches e))])
    (define v (value n point))
    (and v (real? v))))

(define (nodes-with-branches e)
  (define found '())
  (node-fold e void
             (lambda (n args)
               (when (memq (node-head n) (list op:sqrt op:log op:expt))
                 (set! found (cons n found)))))
  found)

;; ---------------------------------------------------------------------------
;; Properties

(define (check-values-kept e simple relations)
  (for ([p (in-list (points-where relations))])
    (define v (value e p))
    (define w (value simple p))
    (when (and v w (real-throughout? e p))
      (with-check-info (['expression e] ['simplified simple] ['relations relations] ['point p]
                        ['values (list v w)])
        (check-true (close? v w 1e-7))))))

(for ([automatic? (in-list '(#t #f))])
  (test-case (format "values are kept where the grounds hold; assuming by itself: ~a" automatic?)
    (with-seeds 300
      (let* ([A (declare (random-relations))] [e (random-signed 3)])
        (when A
          (define-values (simple grounds)
            (simplify-expression/assumptions e (with-automatic-assumptions A automatic?)))
          (unless automatic?
            (check-equal? (remove* (declared-relations A) grounds) '()))
          (check-values-kept e simple (append grounds (declared-relations A))))))))

(test-case "simplification under assumptions is idempotent where there is a value"
  (with-seeds 300
    (let* ([A (declare (random-relations))] [e (random-signed 3)])
      (when (and A (find-reference (list e) A))
        (define simple (simplify-expression e A))
        (with-check-info (['expression e] ['relations (declared-relations A)])
          (check-equal? (expression->datum (simplify-expression simple A))
                        (expression->datum simple)))))))

(test-case "relations in another order give the same result"
  (with-seeds 100
    (let* ([relations (random-relations)] [A (declare relations)] [e (random-signed 3)])
      (when A
        (define B (declare (shuffle relations)))
        (check-equal? (expression->datum (simplify-expression e A))
                      (expression->datum (simplify-expression e B)))))))
