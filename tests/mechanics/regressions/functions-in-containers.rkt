#lang racket/base
;; A function that carries an ε was renamed when it came as an argument, in a tuple
;; or in a list, but not in a box, a hash table, a promise, a parameter or a
;; structure: derivatives came out as 0 or too large.  Found by random programs.

(require racket/promise mechanics/generic/arithmetic mechanics/generic/elementary
         mechanics/value/structure
         mechanics/calculus/derivative
         "../support/checks.rkt")

;; h ↦ h'(3), taking its function in a container, within itself: ∂²/∂x∂y (x sin y)
(define (twice make open)
  (define slope-at-3 ((D (lambda (x) (lambda (held) ((open held) x)))) 3))
  (slope-at-3
   (make (lambda (x)
           (slope-at-3 (make (lambda (y) (g:* x (g:sin y)))))))))

(struct transparent (f) #:transparent)
(struct prefabricated (f) #:prefab)
(struct applicable (f) #:transparent #:property prop:procedure 0)

(define ways
  (list (list 'itself values values)
        (list 'list list car)
        (list 'vector vector (lambda (v) (vector-ref v 0)))
        (list 'tuple up (lambda (s) (ref s 0)))
        (list 'box box unbox)
        (list 'immutable-box box-immutable unbox)
        (list 'hash (lambda (f) (hash 'f f)) (lambda (h) (hash-ref h 'f)))
        (list 'mutable-hash
              (lambda (f) (make-hash (list (cons 'f f))))
              (lambda (h) (hash-ref h 'f)))
        (list 'promise (lambda (f) (delay f)) force)
        (list 'parameter make-parameter (lambda (p) (p)))
        (list 'thunk (lambda (f) (lambda () f)) (lambda (t) (t)))
        (list 'transparent transparent transparent-f)
        (list 'prefab prefabricated prefabricated-f)
        (list 'applicable applicable (lambda (a) a))
        (list 'applicable-field applicable applicable-f)
        (list 'box-in-list (lambda (f) (list (box f))) (lambda (l) (unbox (car l))))
        (list 'keyword (lambda (f) (lambda (#:now [now #t]) f)) (lambda (k) (k #:now #f)))))

(for ([way (in-list ways)])
  (test-case (format "a function keeps its variables apart, held in: ~a" (car way))
    (check-= (twice (cadr way) (caddr way)) (cos 3) 1e-15)))

(test-case "what is stored by the function is found outside"
  (define b (box 1))
  (define store ((D (lambda (x) (lambda (b) (set-box! b (g:* 2 (unbox b))) (g:* x (unbox b))))) 3))
  (check-equal? (store b) 2)
  (check-equal? (unbox b) 2)
  (define h (make-hash '((a . 1))))
  (define note ((D (lambda (x) (lambda (h) (hash-set! h 'b 5) (g:* x (hash-ref h 'b))))) 3))
  (check-equal? (note h) 5)
  (check-equal? (hash-ref h 'b) 5))

(test-case "a parameter stays one"
  (define p (make-parameter 2))
  (define read ((D (lambda (x) (lambda (p) (parameterize ([p 7]) (g:* x (p)))))) 3))
  (check-equal? (read p) 7)
  (check-equal? (p) 2))

(test-case "a structure that holds nothing perturbed is the same"
  (define s (transparent 1))
  (define same ((D (lambda (x) (lambda (a) (if (eq? a s) x 0)))) 3))
  (check-equal? (same s) 1))
