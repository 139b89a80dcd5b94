#lang racket/base
;; Roots of generic functions.

(require racket/list
         mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/generic/up-down
         mechanics/error/failure
         (only-in mechanics/value/structure ref)
         mechanics/calculus/derivative
         mechanics/calculus/gradient
         mechanics/search/find-root
         "../support/checks.rkt")

(test-case "between two numbers"
  (check-= (find-root (g:- g:cos values) 0 1) 0.7390851332151607 1e-12)
  (check-= (find-root (g:- g:cos values) 0 1 #:tolerance 1e-15) 0.7390851332151607 1e-15)
  (check-= (find-root (g:- g:square 2) 0 2) (sqrt 2.0) 1e-12)
  (check-= (find-root g:cos 0 ':pi) (* 2 (atan 1.0)) 1e-12)
  (check-exn #rx"the same sign" (lambda () (find-root g:cos 0 1))))

(test-case "near a number"
  (check-= (find-root (g:- g:cos values) 1) 0.7390851332151607 1e-15)
  (check-equal? (find-root (g:- g:square 9/4) 1) 1.5))

;; Two equations for a number and a pair, given in another shape.
(define (f s)
  (define x (ref s 0))
  (define y (ref s 1 0))
  (define z (ref s 1 1))
  (down (up (g:- (g:* x y z) 6) (g:- (g:+ x y z) 6)) (g:- (g:* x y) 2)))

(test-case "near a structure of any shape, by exact derivatives"
  (define root (find-root f (up 0.9 (up 2.2 3.3))))
  (check-= (ref root 0) 1 1e-10)
  (check-= (ref root 1 0) 2 1e-10)
  (check-= (ref root 1 1) 3 1e-10))

(test-case "a function that cannot be differentiated, by differences"
  (define (f x) (- (exp (if (flonum? x) x (raise-argument-error 'f "flonum?" x))) 2.0))
  (check-= (find-root f 1) (log 2.0) 1e-12))

(test-case "what a function says by error is said"
  (define (f x) (- (exp (if (flonum? x) x (error 'f "a number, please"))) 2.0))
  (check-exn #rx"^f: a number, please$" (lambda () (find-root f 1))))

(test-case "arguments are observed in their shape, and failures carry it"
  (define seen '())
  (find-root f (up 1 (up 2 3.5)) #:observe (lambda (x y) (set! seen (cons x seen))))
  (check-equal? (last seen) (up 1.0 (up 2.0 3.5)))
  (define failure
    (with-handlers ([exn:fail:mechanics:not-convergent? values])
      (find-root (lambda (x) (g:+ 1 (g:square x))) 1/3)))
  (check-true (real? (exn:fail:mechanics:not-convergent-value failure)))
  (check-equal? (exn:fail:mechanics:singular-where
                 (with-handlers ([exn:fail:mechanics:singular? values])
                   (find-root (lambda (s) (up (ref s 0) (g:* 2 (ref s 0)))) (up 1 1))))
                (up 1.0 1.0)))

(test-case "a list to start from is no tuple, and the message says so"
  (check-exn #rx"^find-root: expected a real number\n  given: .*a list is not a tuple; use .up x y"
             (lambda () (find-root (lambda (s) s) (list 0 0)))))

(test-case "what is no question is refused"
  (check-exn #rx"^find-root: expected a function of one variable"
             (lambda () (find-root 3 1)))
  (check-exn #rx"^find-root: expected a real number\n  given: the symbol a"
             (lambda () (find-root g:square 'a)))
  (check-exn #rx"^find-root: expected a real number\n  given: .*a"
             (lambda () (find-root (g:* 'a values) 1)))
  (check-exn
   #rx"^find-root: the function must give as many numbers as it takes\n  given: 1\n  expected: 2"
   (lambda () (find-root (lambda (s) (ref s 0)) (up 1 1))))
  (check-exn #rx"positive tolerance" (lambda () (find-root g:square 1 #:tolerance -1))))

(test-case "more equations than unknowns"
  (check-exn
   #rx"^find-root: the function must give as many numbers as it takes\n  given: 3\n  expected: 2"
   (lambda () (find-root (lambda (s) (up (ref s 0) (ref s 1) 0)) (up 1 1)))))

;; ---------------------------------------------------------------------------
;; Other ways to ask

(define golden (/ (+ 1 (sqrt 5.0)) 2))
(define (f-golden x) (g:- (g:square x) x 1))

(test-case "by bisection, by Newton's method, and as a list"
  (check-= (bisect f-golden 1 2) golden 1e-15)
  (check-= (bisect f-golden 1 2 1e-4) golden 1e-4)
  (check-= (newton-search f-golden 1) golden 1e-15)
  (define-values (found? x count) (apply values (zbrent f-golden 1 2)))
  (check-true found?)
  (check-= x golden 1e-15)
  (check-true (<= count 12))
  (check-true (< (caddr (zbrent f-golden 1 2 1e-2)) (caddr (zbrent f-golden 1 2 1e-14))))
  (define-values (found?* best limit) (apply values (zbrent f-golden 1 2 1e-15 4)))
  (check-false found?*)
  (check-= best golden 1e-1)
  (check-equal? limit 4))

(test-case "the report: root, error, evaluations"
  (define ((honest? most) x error count)
    (check-= x golden (+ 1e-15 error))
    (check-true (<= 4 count most) (format "~a" count)))
  (with-called ([between (honest? 12)] [near (honest? 16)] [halved (honest? 56)])
    (find-root f-golden 1 2 #:report between)
    (find-root f-golden 1 #:report near)
    (bisect f-golden 1 2 #:report halved))
  (check-equal? (newton-search f-golden 1 #:report (lambda (x error count) x))
                (find-root f-golden 1)))

(test-case "each says its own name"
  (for ([ask (list (lambda () (bisect g:cos 0 1)) (lambda () (zbrent g:cos 0 1)))]
        [name '("bisect" "zbrent")])
    (check-exn (regexp (format "^~a: the function has the same sign" name)) ask))
  (check-exn #rx"^newton-search: no root found"
             (lambda () (newton-search (lambda (x) (g:+ 1 (g:square x))) 1/3)))
  (check-exn #rx"^bisect: expected a real number\n  given: the symbol a"
             (lambda () (bisect g:cos 'a 1)))
  (check-exn #rx"^bisect: expected a function of one variable"
             (lambda () (bisect 3 0 1)))
  (check-exn #rx"^bisect: the function is not finite\n  at: 1.0"
             (lambda () (bisect (lambda (x) (if (= x 1) +nan.0 (- x 1.1))) 0 2)))
  (check-exn #rx"^find-root: expected a real number\n  given: .*up tuple of 2"
             (lambda () (find-root (lambda (x) (up x x)) 0 1))))

;; ---------------------------------------------------------------------------
;; Derivatives of roots, by the implicit function theorem

;; Kepler's equation E − e sin E = M
(define ((Kepler e M) E) (g:- E (g:* e (g:sin E)) M))
(define (anomaly e M) (find-root (Kepler e M) 0 3))
(define (anomaly-near e M) (find-root (Kepler e M) 1))

(test-case "the derivative of a root by what the function depends on"
  (define E (anomaly 0.3 1.0))
  (define bottom (- 1 (* 0.3 (cos E))))
  (for ([root (list anomaly anomaly-near)])
    (check-= (((partial 1) root) 0.3 1.0) (/ bottom) 1e-12)
    (check-= (((partial 0) root) 0.3 1.0) (/ (sin E) bottom) 1e-12)
    (define slopes ((gradient (lambda (v) (root (ref v 0) (ref v 1)))) (up 0.3 1.0)))
    (check-= (ref slopes 0) (/ (sin E) bottom) 1e-12)
    (check-= (ref slopes 1) (/ bottom) 1e-12)))

(test-case "higher derivatives, nested or not"
  ;; x = a^(1/3)
  (define (cube-root a) (find-root (lambda (x) (g:- (g:expt x 3) a)) 0 10))
  (for ([n '(1 2 3 4)] [coefficient '(1/3 -2/9 10/27 -80/81)])
    (define expected (* coefficient (expt 2.0 (- 1/3 n))))
    (check-= (((g:expt D n) cube-root) 2) expected 1e-11)
    (check-= ((for/fold ([f cube-root]) ([_ n]) (D f)) 2) expected 1e-11))
  (check-= (((partial 0) ((partial 1) anomaly)) 0.3 1.0)
           (((partial 1) ((partial 0) anomaly)) 0.3 1.0) 1e-12))

(test-case "of a root with several components"
  (define (crossing r)
    (find-root (lambda (v) (up (g:- (g:+ (g:square (ref v 0)) (g:square (ref v 1))) (g:square r))
                               (g:- (ref v 1) (g:* 2 (ref v 0)))))
               (up 1 1)))
  (define slope ((D crossing) 5))
  (check-= (ref slope 0) (/ (sqrt 5.0)) 1e-12)
  (check-= (ref slope 1) (/ 2 (sqrt 5.0)) 1e-12))

(test-case "of a root of a function that cannot be differentiated by its argument"
  (define (tabulated x) (if (flonum? x) (exp x) (raise-argument-error 'tabulated "a flonum" x)))
  (check-= ((D (lambda (a) (find-root (lambda (x) (g:- (tabulated x) a)) 0 3))) 2) 1/2 1e-8))

(test-case "where the root does not move smoothly there is no derivative"
  (check-exn
   #rx"^find-root: the root has no derivative: those of the function have no inverse there\n  at: 0.0"
   (lambda () ((D (lambda (a) (find-root (lambda (x) (g:- (g:expt x 3) (g:* a a))) -1 1))) 0))))

;; Of slope 1 to the right of 1 and 1/10 to the left, or the other way round
(test-case "nor where the function has a kink, on whichever side it is flatter"
  (for ([side '(1 -1)])
    (define (kinked x) (g:+ (g:* 0.55 (g:- x 1)) (g:* 0.45 side (g:abs (g:- x 1)))))
    (check-exn
     #rx"^find-root: the root has no derivative: those of the function have no inverse there\n  at: 1"
     (lambda () ((D (lambda (a) (find-root (lambda (x) (g:- (kinked x) a)) (+ 1 side)))) 0)))))
