#lang racket/base
;; Literal functions: application, derivatives, every form of signature.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/value/compose
         mechanics/value/signature
         mechanics/value/series/series mechanics/value/series/series-access
         mechanics/value/structure
         mechanics/calculus/derivative
         mechanics/calculus/literal-function
         "../support/checks.rkt"
         "../support/close.rkt" "../support/messages.rkt" "../support/numeric-value.rkt"
         "../support/same.rkt")

(define (text x) (format "~a" x))
(define x (literal-function 'x))
(define F (literal-function 'F (-> (X Real Real) Real)))
(define G (literal-function 'G (-> (UP Real Real) Real)))
(define H (literal-function 'H (Hamiltonian 2)))

;; ---------------------------------------------------------------------------
;; The book's forms

(test-case "values and derivatives print as in the book"
  (check-equal? (text (x 't)) "(x t)")
  (check-equal? (text ((D x) 't)) "((D x) t)")
  (check-equal? (text (((g:expt D 2) x) 't)) "(((expt D 2) x) t)")
  (check-equal? (text ((D (D (D x))) 't)) "(((expt D 3) x) t)")
  (check-equal? (text (F 'x 'y)) "(F x y)")
  (check-equal? (text (((partial 1) F) 'x 'y)) "(((partial 1) F) x y)")
  (check-equal? (text (((partial 0) ((partial 1) F)) 'x 'y))
                "(((* (partial 0) (partial 1)) F) x y)")
  (check-equal? (text (((g:* (partial 1) (g:square (partial 0))) F) 'x 'y))
                "(((* (expt (partial 0) 2) (partial 1)) F) x y)")
  (check-equal? (text (G (up 'x 'y))) "(G (up x y))")
  (check-equal? (text (((partial 1) G) (up 'x 'y))) "(((partial 1) G) (up x y))")
  (check-equal? (text (((partial 1 0) H) (up 't (up 'x 'y) (down 'px 'py))))
                "(((partial 1 0) H) (up t (up x y) (down px py)))"))

(test-case "the function itself prints by its name, differentiated or not, in all three modes"
  (for ([f (list x (D x) ((g:expt D 2) x) F ((partial 0) F) (D F))]
        [t '("x" "(D x)" "((expt D 2) x)" "F" "((partial 0) F)" "(D F)")])
    (for ([mode '("~a" "~s" "~v")])
      (check-equal? (format mode f) t))))

(test-case "the derivative by a tuple argument, and by several arguments"
  (check-equal? (text ((D G) (up 'a 'b)))
                "(down (((partial 0) G) (up a b)) (((partial 1) G) (up a b)))")
  (check-equal? (text ((D F) 'a 'b)) "(down (((partial 0) F) a b) (((partial 1) F) a b))")
  (check-equal? (text (((partial 2) H) (up 't (up 'x 'y) (down 'p 'q))))
                (string-append "(up (((partial 2 0) H) (up t (up x y) (down p q)))"
                               " (((partial 2 1) H) (up t (up x y) (down p q))))")))

(test-case "of a power series, the Taylor series about its first term"
  (define s (x (power-series 'a 'b)))
  (check-equal? (text (series:ref s 0)) "(x a)")
  (check-equal? (text (series:ref s 1)) "(* ((D x) a) b)"))

(test-case "a signature quoted is the same signature"
  (for ([d '((-> Real Real) (-> (X Real Real) Real) (-> (UP Real (UP Real Real)) Real))]
        [u (list (-> Real Real) (-> (X Real Real) Real) (-> (UP Real (UP Real Real)) Real))])
    (check-equal? d u)
    (check-equal? (literal-function 'f d) (literal-function 'f u))))

;; One argument of every shape the book uses, and the values that fit it.
(define forms
  (list (list '(-> Real Real) '(t))
        (list '(-> (X Real Real) Real) '(x y))
        (list '(-> (X* Real 3) Real) '(x y z))
        (list '(-> (X Real (UP Real Real)) Real) (list 't (up 'x 'y)))
        (list '(-> (UP Real Real) Real) (list (up 'x 'y)))
        (list '(-> (UP* Real 3) Real) (list (up 'x 'y 'z)))
        (list '(-> (DOWN Real Real) Real) (list (down 'x 'y)))
        (list '(-> (DOWN* Real 2) Real) (list (down 'x 'y)))
        (list '(-> (UP Real (UP Real Real) (UP Real Real)) Real)
              (list (up 't (up 'x 'y) (up 'vx 'vy))))
        (list (Lagrangian) (list (up 't 'q 'v)))
        (list (Lagrangian 2) (list (up 't (up 'x 'y) (up 'vx 'vy))))
        (list (Hamiltonian 2) (list (up 't (up 'x 'y) (down 'px 'py))))
        (list '(-> (UP Real (UP* (UP Real Real) 2)) Real)
              (list (up 't (up (up 'x1 'y1) (up 'x2 'y2)))))
        (list '(-> Any Real) (list (up 'x (down 'y 'z))))))

(test-case "every form of domain takes what fits and prints what it was given"
  (for ([form (in-list forms)])
    (define f (literal-function 'f (car form)))
    (with-check-info (['signature (car form)])
      (check-equal? (format "~s" (apply f (cadr form)))
                    (format "~s" (cons 'f (cadr form)))))))

(test-case "every form of domain has derivatives by all its scalars that obey the chain rule"
  ;; along a curve through the arguments; compared with central differences
  (for ([form (in-list forms)] [seed (in-naturals)])
    (define f (literal-function 'f (car form)))
    (define (arguments-at s)                   ; each scalar a different function of s
      (define n 0)
      (for/list ([a (in-list (cadr form))])
        (s:map/r (lambda (_) (set! n (add1 n)) (g:+ (g:sin (g:* n s)) (g:/ s (add1 n)))) a)))
    (define (along s) (apply f (arguments-at s)))
    (define (number s) (numeric-value (along s) seed))
    (define h 1e-3)
    (define s 0.37)
    (define difference
      (/ (- (* 8 (- (number (+ s h)) (number (- s h)))) (- (number (+ s h h)) (number (- s h h))))
         (* 12 h)))
    (with-check-info (['signature (car form)])
      (check-true (close? (numeric-value ((D along) s) seed) difference 1e-8))
      (check-true (close? (numeric-value (((g:expt D 2) along) s) seed)
                          (/ (- (numeric-value ((D along) (+ s h)) seed)
                                (numeric-value ((D along) (- s h)) seed))
                             (* 2 h))
                          1e-4)))))

(test-case "ranges: a structure of literal functions, named by orientation and index"
  (check-equal? (text (literal-function 'q (-> Real (UP Real Real)))) "(up q^0 q^1)")
  (check-equal? (text ((literal-function 'q (-> Real (UP Real Real))) 't)) "(up (q^0 t) (q^1 t))")
  (check-equal? (text ((D (literal-function 'q (-> Real (UP Real Real)))) 't))
                "(up ((D q^0) t) ((D q^1) t))")
  (check-equal? (text ((literal-function 'p (-> Real (DOWN* Real 2))) 't)) "(down (p_0 t) (p_1 t))")
  (check-equal? (text ((literal-function 'C (-> (UP Real (UP Real Real) (DOWN Real Real))
                                                (UP Real (UP Real Real) (DOWN Real Real))))
                       (up 't (up 'x 'y) (down 'p 'q))))
                (string-append "(up (C^0 (up t (up x y) (down p q)))"
                               " (up (C^1^0 (up t (up x y) (down p q))) (C^1^1 (up t (up x y) (down p q))))"
                               " (down (C^2_0 (up t (up x y) (down p q))) (C^2_1 (up t (up x y) (down p q)))))")))

(test-case "literal tuples and numbers"
  (check-equal? (literal-up 'x 3) (up 'x^0 'x^1 'x^2))
  (check-equal? (literal-down 'p 2) (down 'p_0 'p_1))
  (check-equal? (literal-number 'm) 'm))

;; ---------------------------------------------------------------------------
;; Derivatives

(test-case "the chain rule for compositions with known functions"
  (check-true (same? ((D (compose x g:sin)) 't) (g:* ((D x) (g:sin 't)) (g:cos 't))))
  (check-true (same? ((D (lambda (t) (F (x t) (g:square t)))) 't)
                     (g:+ (g:* (((partial 0) F) (x 't) (g:square 't)) ((D x) 't))
                          (g:* 2 't (((partial 1) F) (x 't) (g:square 't)))))))

(test-case "the order of mixed derivatives does not matter, in the head itself"
  (define a (((g:* (partial 1 0) (partial 2 1) (partial 0)) H) (up 't (up 'x 'y) (down 'p 'q))))
  (define b (((g:* (partial 0) (partial 2 1) (partial 1 0)) H) (up 't (up 'x 'y) (down 'p 'q))))
  (check-equal? a b))

(test-case "equality of literal functions and of their values"
  (check-equal? x (literal-function 'x))
  (check-not-equal? x (literal-function 'y))
  (check-equal? ((D x) 't) ((D (literal-function 'x)) 't))
  (check-not-equal? (x 't) ((D x) 't))
  (check-not-equal? (x 't) (x 's))
  (check-true (literal-function? x))
  (check-false (literal-function? sin)))

(test-case "numbers inside are kept as they are"
  (check-equal? (text (x 0)) "(x 0)")
  (check-equal? (text (x 1/2)) "(x 1/2)")
  (check-equal? (text ((D x) 2.5)) "((D x) 2.5)"))

;; ---------------------------------------------------------------------------
;; Errors

(test-case "an argument that does not fit is named, with its slot"
  (check-message
   (string-append "x: was declared (-> Real Real); slot 0 got (up a b), an up tuple of 2\n"
                  "  a signature such as (-> (UP Real Real) Real) declares a function of tuples")
   (x (up 'a 'b)))
  (check-message (string-append "x: was declared (-> Real Real); slot 0 got (a b), a list\n"
                                "  a list is not a tuple; use (up x y ...)")
                 (x '(a b)))
  (check-message
   "F: was declared (-> (X Real Real) Real); slot 1 got x, a literal function (-> Real Real)"
   (F 't x))
  (check-message
   "G: was declared (-> (UP Real Real) Real); slot 0 got (down a b), a down tuple of 2"
   (G (down 'a 'b)))
  (check-message "G: was declared (-> (UP Real Real) Real); slot 0 got (up a b c), an up tuple of 3"
                 (G (up 'a 'b 'c)))
  (check-message (string-append "x: was declared (-> Real Real); slot 0 got the procedure `sin`\n"
                                "  what takes it of the values of a function is (compose x sin)")
                 (x sin))
  (check-message "G: was declared (-> (UP Real Real) Real); slot 0 got the symbol a"
                 (G 'a)))

(test-case "a wrong number of arguments is counted"
  (check-message "F: was declared (-> (X Real Real) Real), which takes 2 arguments; given 1: (a)"
                 (F 'a))
  (check-message "x: was declared (-> Real Real), which takes 1 argument; given 2: (a b)" (x 'a 'b))
  (check-message "x: was declared (-> Real Real), which takes 1 argument; given 0: ()" (x)))

(test-case "the derivative complains like the function"
  (check-message
   "F: was declared (-> (X Real Real) Real); slot 1 got (up 1 2), an up tuple of 2\n  a signature such as (-> (UP Real Real) Real) declares a function of tuples"
   (((partial 0) F) 't (up 1 2))))

(test-case "a literal needs a name"
  (check-exn
   #rx"^literal-function: expected a quoted name, such as 'f\n  given: the number 3"
   (lambda () (literal-function 3)))
  (check-exn #rx"^literal-function: .*given: the procedure `sin`"
             (lambda () (literal-function sin)))
  (check-exn #rx"^literal-up: .*a quoted name" (lambda () (literal-up "x" 2)))
  (check-exn #rx"^literal-down: .*a number of components" (lambda () (literal-down 'x -1)))
  (check-exn #rx"^literal-number: .*a quoted name" (lambda () (literal-number 3))))
