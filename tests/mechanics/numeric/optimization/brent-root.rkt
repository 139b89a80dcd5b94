#lang racket/base
;; Roots of one function of one variable, and of several of several.

(require racket/flonum
         mechanics/error/failure
         mechanics/numeric/optimization/newton
         mechanics/numeric/optimization/brent-root
         "../../support/checks.rkt")

;; -> root and number of evaluations
(define (root+count f low high #:jump [jump raise])
  (define-values (x error count) (bracketed-root f low high #:jump jump))
  (values x count))

(define (root f low high)
  (define-values (x error count) (bracketed-root f low high))
  x)

(define (within x low high) (* 1e-14 (max (abs x) (* 1e-2 (- high low)))))

(test-case "smooth functions, to rounding, in about ten evaluations"
  (for ([example (in-list
                  (list (list cos 1 2 (* 2 (atan 1.0)) 8)
                        (list (lambda (x) (- (* x x) 2)) 0 2 (sqrt 2.0) 10)
                        (list (lambda (x) (- (exp x) (* 3 x x))) 0 1 0.910007572488709 11)
                        (list (lambda (x) (- (exp (- x)) 1e-6)) 0 40 (* 6 (log 10.0)) 30)
                        (list (lambda (x) (- x 1e-9)) -1 1 1e-9 5)
                        (list atan -10 7 0.0 12)))])
    (define-values (f low high expected most) (apply values example))
    (define-values (x count) (root+count f low high))
    (check-= x expected (within expected low high))
    (check-true (<= count most) (format "~a evaluations for ~a" count expected))
    (define-values (y _) (root+count f high low))
    (check-= y expected (within expected low high))))

(test-case "flat and kinked functions, and steps, cost little more than bisection"
  (for ([f (in-list (list (lambda (x) (expt (- x 1/3) 9))
                          (lambda (x) (if (< x 1/3) -1 1e-9))
                          (lambda (x) (* (if (< x 1/3) -1 1) (expt (abs (- x 1/3)) 1/5)))
                          (lambda (x) (* (- x 1/3) (exp (* -10 (- x 1/3) (- x 1/3)))))))])
    (define-values (x count) (root+count f -1 2 #:jump void))
    (check-= x 1/3 1e-10)
    (check-true (< count 170) (format "~a" count))))

(test-case "a value next to 0 at an end makes no pole of a root within"
  (check-= (root (lambda (x) (+ 1e-30 (* x (- 2 (* x x))))) 0 2) (sqrt 2.0) 1e-14))

(test-case "scales of values do not matter"
  (for ([c (in-list '(1e-200 1 1e200))])
    (check-= (root (lambda (x) (* c (- (* x x x) 2))) 0 3) (expt 2.0 (/ 1.0 3.0)) 1e-15)))

(test-case "a zero at an end is the root"
  (check-equal? (root values 0 1) 0.0)
  (check-equal? (root (lambda (x) (- x 1)) 0 1) 1.0))

(test-case "what is no root is told by name"
  (check-exn #rx"^find-root: the function has the same sign at both ends of the interval"
             (lambda () (bracketed-root cos 0 1)))
  (check-exn
   #rx"^find-root: the function changes its sign at a pole or a jump, not at a zero\n  near: 1.57"
   (lambda () (bracketed-root tan 1 2)))
  (check-exn #rx"^find-root: the function changes its sign at a jump, not at a zero; bisect finds"
             (lambda () (bracketed-root (lambda (x) (if (< x 1/3) -1 1e-9)) -1 2)))
  (define failure
    (with-handlers ([exn:fail:mechanics:not-convergent? values])
      (bracketed-root cos 1 2 #:limit 3)))
  (check-regexp-match #rx"^find-root: no root found\n  evaluations: 3" (exn-message failure))
  (check-= (exn:fail:mechanics:not-convergent-value failure) 1.57 0.1)
  (check-exn #rx"a finite real number as end of the interval"
             (lambda () (bracketed-root cos 0 +inf.0)))
  (check-exn #rx"positive tolerance" (lambda () (bracketed-root cos 0 2 #:tolerance 0))))

(test-case "the evaluations are counted, and the error is bounded"
  (for ([method (list bracketed-root bisected-root)])
    (for ([tolerance '(1e-3 1e-8 1e-13)])
      (define seen 0)
      (define-values (x error count)
        (method cos 1 2 #:tolerance tolerance #:observe (lambda (x y) (set! seen (+ seen 1)))))
      (check-equal? count seen)
      (check-true (<= (abs (- x (* 2 (atan 1.0)))) (+ error 1e-15)))
      (check-true (<= error (* tolerance 1.6))))))

(test-case "bisection: a digit in three or four evaluations, to rounding, at jumps too"
  (define-values (x error count) (bisected-root cos 1 2))
  (check-= x (* 2 (atan 1.0)) 1e-15)
  (check-true (<= 48 count 56))
  (define-values (jump error* count*) (bisected-root (lambda (x) (if (< x 1/3) -1 1)) 0 1))
  (check-= jump 1/3 1e-15)
  (define-values (end error** count**) (bisected-root values 0 1))
  (check-equal? (list end error** count**) '(0.0 0.0 2))
  (check-exn #rx"^bisect: the function has the same sign at both ends"
             (lambda () (bisected-root cos 0 1))))

;; ---------------------------------------------------------------------------
;; Newton's method

(define (x i v) (flvector-ref v i))

;; Powell's badly scaled functions: 10⁴ x y = 1, e^(−x) + e^(−y) = 1.0001.
(define (powell v)
  (flvector (- (* 1e4 (x 0 v) (x 1 v)) 1.0)
            (- (+ (exp (- (x 0 v))) (exp (- (x 1 v)))) 1.0001)))
(define (powell-rows v)
  (vector (vector (* 1e4 (x 1 v)) (* 1e4 (x 0 v)))
          (vector (- (exp (- (x 0 v)))) (- (exp (- (x 1 v)))))))

(test-case "a badly scaled system, from afar"
  (define-values (v step) (newton powell powell-rows (flvector 0.0 1.0)))
  (check-= (x 0 v) 1.098159e-5 1e-11)
  (check-= (x 1 v) 9.106146739867 1e-10))

(define (circle-and-line v)
  (flvector (- (+ (expt (x 0 v) 2) (expt (x 1 v) 2)) 25.0)
            (- (x 0 v) (x 1 v) 1.0)))
(define (circle-and-line-rows v)
  (vector (vector (* 2.0 (x 0 v)) (* 2.0 (x 1 v))) (vector 1.0 -1.0)))

(test-case "each step squares the error"
  (define distances '())
  (define-values (v step)
    (newton circle-and-line circle-and-line-rows (flvector 5.0 2.0)
            #:observe (lambda (v f) (set! distances (cons (abs (- (car v) 4.0)) distances)))))
  (check-equal? (fl->exact-integer (flround (x 0 v))) 4)
  (for ([before (in-list (cdr (reverse distances)))] [after (in-list (cddr (reverse distances)))])
    (check-true (<= after (+ 1e-14 (* before before))) (format "~a" distances))))

(test-case "how the equations are scaled makes no difference"
  (define (points scale)
    (define seen '())
    (newton (lambda (v) (let ([f (powell v)]) (flvector (* scale (x 0 f)) (x 1 f))))
            (lambda (v)
              (define rows (powell-rows v))
              (vector (for/vector ([a (in-vector (vector-ref rows 0))]) (* scale a))
                      (vector-ref rows 1)))
            (flvector 0.0 1.0)
            #:observe (lambda (v f) (set! seen (cons v seen))))
    seen)
  (check-equal? (points 1.0) (points 1024.0)))

(test-case "differences are derivatives, of functions of second degree but for rounding"
  (define (f v) (flvector (* (x 0 v) (x 1 v)) (+ (expt (x 1 v) 2) (x 0 v))))
  (check-within (difference-rows f (flvector 1.0 -3.0) 1e-3)
                (vector (vector -3.0 1.0) (vector 1.0 -6.0)) 1e-11))

(test-case "without an inverse, and without a root"
  (define failure
    (with-handlers ([exn:fail:mechanics:singular? values])
      (newton circle-and-line circle-and-line-rows (flvector 1.0 -1.0))))
  (check-regexp-match #rx"^find-root: the derivatives of the functions have no inverse"
                      (exn-message failure))
  (check-equal? (exn:fail:mechanics:singular-where failure) '(1.0 -1.0))
  (check-exn #rx"^find-root: no root found: no step leads closer"
             (lambda () (newton (lambda (v) (flvector (+ 1.0 (expt (x 0 v) 2))))
                                (lambda (v) (vector (vector (* 2.0 (x 0 v)))))
                                (flvector 0.3))))
  (define (without-end limit)
    (newton (lambda (v) (flvector (exp (x 0 v)))) (lambda (v) (vector (vector (exp (x 0 v)))))
            (flvector 0.0) #:limit limit))
  (check-exn #rx"^find-root: no root found: too many steps\n.*steps: 7\n  best value: '\\(-7.0\\)"
             (lambda () (without-end 7)))
  (check-exn #rx"^find-root: the functions are not finite"
             (lambda () (newton (lambda (v) (flvector +nan.0)) void (flvector 0.0)))))
