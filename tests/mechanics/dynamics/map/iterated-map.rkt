#lang racket/base
;; Maps done again and again: by calls, or compiled.

(require racket/flonum
         (only-in racket/math nan?)
         mechanics
         "../../support/checks.rkt" "../../support/close.rkt")

(define ((standard-map K) theta I return failure)
  (let ((nI (+ I (* K (sin theta)))))
    (return ((principal-value :2pi) (+ theta nI)) ((principal-value :2pi) nI))))

(define ((standard-map-inverse K) theta I return failure)
  (let ((ntheta (- theta I)))
    (return ((principal-value :2pi) ntheta)
            ((principal-value :2pi) (- I (* K (sin ntheta)))))))

(define (fail) 'no-image)

(test-case "the standard map from (1, 1), to fourteen digits (SICM 3.9)"
  (define (after n K) ((iterated-map (standard-map K) n) 1 1 list fail))
  (check-close (after 1 0.6) '(2.50488259088474 1.50488259088474) 1e-14)
  (check-close (after 10 0.6) '(2.02201816481268 1.33373402711283) 2e-14)
  (check-close (after 1 1.4) '(3.17805937873106 2.17805937873106) 1e-14)
  (check-close (after 10 1.4) '(5.41581380396213 1.7744615690744) 2e-13))

(test-case "compiled or not, the motion is the same"
  (define there (iterated-map (standard-map 0.6) 20000))
  (define one (standard-map 0.6))
  (define-values (x y)
    (for/fold ([x 1] [y 1]) ([_ (in-range 20000)]) (one x y values fail)))
  (check-close (there 1 1 list fail) (list x y) 1e-8))

(test-case "exact numbers stay exact where the map keeps them so, however often it is done"
  (define (turn x y return fail) (return (- y) (+ x 1/2)))
  (for ([n '(10 9999 10000 20000)])
    (check-equal? ((iterated-map turn n) 0 1/3 list fail)
                  (case (remainder n 4)
                    [(0) '(0 1/3)]
                    [(2) '(-1/2 1/6)]
                    [(3) '(-1/6 0)]))))

(test-case "twenty thousand times there and back"
  (define back
    ((iterated-map (standard-map 0.6) 20000) 1 1
     (lambda (x y) ((iterated-map (standard-map-inverse 0.6) 20000) x y list fail))
     fail))
  (check-close back '(1 1) 1e-7))

(test-case "not at all, and for symbols"
  (check-equal? ((iterated-map (standard-map 0.6) 0) 1 2 list fail) '(1 2))
  (define (shear x y return fail) (return (+ x y) y))
  (check-equal? (map expression (map simplify ((iterated-map shear 3) 'x 'y list fail)))
                '((+ x (* 3 y)) y)))

(test-case "where there is no image, the failure is told, whenever it comes"
  (define (downwards x y return fail) (if (> y 0) (return x (- y 1)) (fail)))
  (check-equal? ((iterated-map downwards 3) 0 5 list fail) '(0 2))
  (check-equal? ((iterated-map downwards 30000) 0 5 list fail) 'no-image)
  (check-equal? ((iterated-map downwards 30000) 0 30000.5 list fail) '(0 0.5))
  (define (nowhere x y return fail) (fail))
  (check-equal? ((iterated-map nowhere 30000) 0.5 5 list fail) 'no-image))

(test-case "where numbers stop being real the map is called, as it would be a few times"
  (define (roots x y return fail) (return (sqrt (- x 1)) y))
  (define (after n) ((iterated-map roots n) 2.0 0.0 list fail))
  (check-equal? (after 20000)
                (for/fold ([p '(2.0 0.0)]) ([_ (in-range 20000)])
                  (roots (car p) (cadr p) list fail))))

(test-case "angles are wrapped by compiled code exactly as by the function"
  (for ([cut (list :pi :2pi 0.7)])
    (define wrap (principal-value cut))
    (define compiled (compile-function wrap 1.0))
    (check-false (compiled-function-reason compiled))
    (for ([x (list 0.0 -0.0 1.0 cut (- cut :2pi) (- cut 1e-15) -1e-300 -1e-17 (- -1e-15 :2pi)
                   1e15 -1e15 100.0 -100.0)])
      (check-equal? (flvector-ref (compiled (flvector x)) 0) (wrap x)))
    (check-true (nan? (flvector-ref (compiled (flvector +nan.0)) 0)))))

(test-case "mistakes"
  (check-exn #rx"iterated-map: expected a map, a procedure of two coordinates and of two procedures"
             (lambda () (iterated-map 3 1)))
  (check-exn #rx"its image goes to the third argument"
             (lambda () (iterated-map (lambda (x y) (list x y)) 1)))
  (check-exn #rx"how many times, a natural number" (lambda () (iterated-map (standard-map 1) -1)))
  (check-equal? (format "~a" (iterated-map (standard-map 1) 2))
                "(iterated-map standard-map 2)"))
