#lang racket/base
;; The five binary operations on every pair of kinds.
;;
;; For data the result is written down, as an S-expression that Racket's own
;; operations evaluate at a point; for functions it follows from the values, for
;; operators from what they make of functions.  `_` marks pairs that do not
;; combine.

(require mechanics/generic/arithmetic
         mechanics/generic/describe
         mechanics/generic/elementary
         mechanics/generic/function
         mechanics/generic/up-down
         mechanics/value/matrix/matrix
         mechanics/value/operator
         mechanics/calculus/derivative
         mechanics/calculus/literal-function
         "../support/checks.rkt"
         "../support/close.rkt" "../support/numeric-value.rkt" "../support/same.rkt")

(define operations (hasheq '+ g:+ '- g:- '* g:* '/ g:/ 'expt g:expt))

(define data
  (list 3 'a (g:sin 'x) (up 'p 2) (down 'q 5) (vector 1 'r) (matrix-by-rows '(1 2) '(0 m))))

;; ---------------------------------------------------------------------------
;; Data with data: rows and columns in the order 3, a, (sin x), (up p 2),
;; (down q 5), #(1 r), the matrix of rows (1 2) and (0 m)

(define table
  '((+ 6         (+ 3 a)       (+ 3 (sin x))  _  _  _  (rows (4 2) (0 (+ 3 m)))
       (+ 3 a)   (+ a a)       (+ a (sin x))  _  _  _  (rows ((+ 1 a) 2) (0 (+ a m)))
       (+ 3 (sin x)) (+ a (sin x)) (* 2 (sin x)) _ _ _ (rows ((+ 1 (sin x)) 2) (0 (+ m (sin x))))
       _ _ _ (up (* 2 p) 4)      _                    (up (+ 1 p) (+ 2 r)) _
       _ _ _ _                   (down (* 2 q) 10)    _                    _
       _ _ _ (up (+ 1 p) (+ 2 r)) _                   (up 2 (* 2 r))       _
       (rows (4 2) (0 (+ 3 m))) (rows ((+ 1 a) 2) (0 (+ a m)))
       (rows ((+ 1 (sin x)) 2) (0 (+ m (sin x)))) _ _ _ (rows (2 4) (0 (* 2 m))))

    (- 0         (- 3 a)       (- 3 (sin x))  _  _  _  (rows (2 -2) (0 (- 3 m)))
       (- a 3)   0             (- a (sin x))  _  _  _  (rows ((- a 1) -2) (0 (- a m)))
       (- (sin x) 3) (- (sin x) a) 0          _  _  _  (rows ((- (sin x) 1) -2) (0 (- (sin x) m)))
       _ _ _ (up 0 0)            _            (up (- p 1) (- 2 r)) _
       _ _ _ _                   (down 0 0)   _                    _
       _ _ _ (up (- 1 p) (- r 2)) _           (up 0 0)             _
       (rows (-2 2) (0 (- m 3))) (rows ((- 1 a) 2) (0 (- m a)))
       (rows ((- 1 (sin x)) 2) (0 (- m (sin x)))) _ _ _ (rows (0 0) (0 0)))

    (* 9             (* 3 a)        (* 3 (sin x))
       (up (* 3 p) 6) (down (* 3 q) 15) (up 3 (* 3 r)) (rows (3 6) (0 (* 3 m)))
       (* 3 a)       (* a a)        (* a (sin x))
       (up (* a p) (* 2 a)) (down (* a q) (* 5 a)) (up a (* a r)) (rows (a (* 2 a)) (0 (* a m)))
       (* 3 (sin x)) (* a (sin x))  (* (sin x) (sin x))
       (up (* (sin x) p) (* 2 (sin x))) (down (* (sin x) q) (* 5 (sin x)))
       (up (sin x) (* (sin x) r)) (rows ((sin x) (* 2 (sin x))) (0 (* m (sin x))))
       (up (* 3 p) 6) (up (* a p) (* 2 a)) (up (* (sin x) p) (* 2 (sin x)))
       (up (up (* p p) (* 2 p)) (up (* 2 p) 4)) (+ (* p q) 10)
       (up (up p 2) (up (* p r) (* 2 r))) _
       (down (* 3 q) 15) (down (* a q) (* 5 a)) (down (* (sin x) q) (* 5 (sin x)))
       (+ (* p q) 10) (down (down (* q q) (* 5 q)) (down (* 5 q) 25))
       (+ q (* 5 r)) (down q (+ (* 2 q) (* 5 m)))
       (up 3 (* 3 r)) (up a (* a r)) (up (sin x) (* r (sin x)))
       (up (up p (* r p)) (up 2 (* 2 r))) (+ q (* 5 r)) (up (up 1 r) (up r (* r r))) _
       (rows (3 6) (0 (* 3 m))) (rows (a (* 2 a)) (0 (* a m)))
       (rows ((sin x) (* 2 (sin x))) (0 (* m (sin x))))
       (up (+ 4 p) (* 2 m)) _ (up (+ 1 (* 2 r)) (* m r)) (rows (1 (+ 2 (* 2 m))) (0 (* m m))))

    (/ 1             (/ 3 a)        (/ 3 (sin x)) _ _ _ (rows (3 (/ -6 m)) (0 (/ 3 m)))
       (/ a 3)       1              (/ a (sin x)) _ _ _ (rows (a (/ (* -2 a) m)) (0 (/ a m)))
       (/ (sin x) 3) (/ (sin x) a)  1             _ _ _
       (rows ((sin x) (/ (* -2 (sin x)) m)) (0 (/ (sin x) m)))
       (up (/ p 3) 2/3)   (up (/ p a) (/ 2 a))   (up (/ p (sin x)) (/ 2 (sin x)))   _ _ _ _
       (down (/ q 3) 5/3) (down (/ q a) (/ 5 a)) (down (/ q (sin x)) (/ 5 (sin x))) _ _ _
       (down q (/ (- 5 (* 2 q)) m))
       (up 1/3 (/ r 3))   (up (/ 1 a) (/ r a))   (up (/ 1 (sin x)) (/ r (sin x)))   _ _ _ _
       (rows (1/3 2/3) (0 (/ m 3))) (rows ((/ 1 a) (/ 2 a)) (0 (/ m a)))
       (rows ((/ 1 (sin x)) (/ 2 (sin x))) (0 (/ m (sin x)))) _ _ _ (rows (1 0) (0 1)))

    (expt 27             (expt 3 a)       (expt 3 (sin x))       _ _ _ _
          (expt a 3)       (expt a a)       (expt a (sin x))       _ _ _ _
          (expt (sin x) 3) (expt (sin x) a) (expt (sin x) (sin x)) _ _ _ _
          (up (up (up (* p p p) (* 2 p p)) (up (* 2 p p) (* 4 p)))
              (up (up (* 2 p p) (* 4 p)) (up (* 4 p) 8)))          _ _ _ _ _ _
          (down (down (down (* q q q) (* 5 q q)) (down (* 5 q q) (* 25 q)))
                (down (down (* 5 q q) (* 25 q)) (down (* 25 q) 125))) _ _ _ _ _ _
          (up (up (up 1 r) (up r (* r r)))
              (up (up r (* r r)) (up (* r r) (* r r r))))          _ _ _ _ _ _
          (rows (1 (+ 2 (* 2 m) (* 2 m m))) (0 (* m m m)))         _ _ _ _ _ _)))

;; A value, or the expectation of one, as nested lists of numbers at a point.
(define (value-at-point x point)
  (cond [(tuple? x)
         (cons (structure-orientation (adopt x))
               (for/list ([e (in-vector (structure-elements (adopt x)))])
                 (value-at-point e point)))]
        [(matrix? x)
         (cons 'rows (for/list ([row (in-vector (matrix-rows x))])
                       (for/list ([e (in-vector row)]) (value-at-point e point))))]
        [else (numeric-value x point)]))

(define (expectation-at-point d point)
  (define (at d) (expectation-at-point d point))
  (cond [(number? d) d]
        [(symbol? d) (symbol-value d point)]
        [(memq (car d) '(up down)) (cons (car d) (map at (cdr d)))]
        [(eq? (car d) 'rows) (cons 'rows (for/list ([row (cdr d)]) (map at row)))]
        [else (apply (hash-ref racket-operations (car d)) (map at (cdr d)))]))

(define racket-operations (hasheq '+ + '- - '* * '/ / 'expt expt 'sin sin))

(define (agree? v w)
  (if (and (list? v) (list? w))
      (and (= (length v) (length w)) (andmap agree? v w))
      (if (and (number? v) (number? w)) (close? v w 1e-12) (eq? v w))))

(define (inapplicable name)
  (regexp (format "^~a: cannot " (regexp-quote (symbol->string name)))))

(for ([row (in-list table)])
  (define name (car row))
  (define op (hash-ref operations name))
  (for* ([(a i) (in-indexed data)] [(b j) (in-indexed data)])
    (define expected (list-ref (cdr row) (+ (* i (length data)) j)))
    (define title (format "(~a ~a ~a)" name (value->text a) (value->text b)))
    (test-case title
      (if (eq? expected '_)
          (check-exn (inapplicable name) (lambda () (op a b)))
          (for ([point '(1 2)])
            (define got (value-at-point (op a b) point))
            (with-check-info (['got got] ['expected expected])
              (check-true (agree? got (expectation-at-point expected point)))))))))

(test-case "the table covers every pair"
  (for ([row (in-list table)])
    (check-equal? (length (cdr row)) (expt (length data) 2))))

;; ---------------------------------------------------------------------------
;; Functions: the value of the result is the result of the values

(define (cubed x) (g:* x x x))
(define functions (list cubed (literal-function 'V) (g:sin (g:* 2 cubed)) g:exp))

(define (outcome thunk)
  (with-handlers ([exn:fail:contract? (lambda (e) 'inapplicable)]) (thunk)))

(for* ([(name op) (in-hash operations)]
       [f (in-list (append functions data))]
       [g (in-list (append functions data))]
       #:when (or (memq f functions) (memq g functions)))
  (define (at x) (if (memq x functions) (x 't) x))
  (test-case (format "(~a ~a ~a) is pointwise" name (value->text f) (value->text g))
    (define h (op f g))
    (check-pred pointwise? h)
    (check-true (same? (outcome (lambda () (h 't))) (outcome (lambda () (op (at f) (at g))))))))

(test-case "functions of several arguments combine at all of them"
  (define (f x y) (g:* x y))
  (define (g x y) (g:+ x y))
  (check-equal? ((g:- f g) 3 5) 7)
  (check-equal? ((g:* 2 f) 3 5) 30)
  (check-equal? ((g:sin f) 'x 'y) (g:sin (g:* 'x 'y))))

(test-case "a combination takes the numbers of arguments that both functions take"
  (define (f x [y 0]) x)
  (define (g x y) y)
  (check-equal? (arity-mask (g:+ f g)) (arithmetic-shift 1 2))
  (check-equal? (arity-mask (g:* 2 f)) 6)
  (check-equal? (arity-mask (g:* (up f g) f)) (arithmetic-shift 1 2)))

(test-case "a tuple of functions plus a function is the function of tuples"
  (check-equal? ((g:+ (up sin cos) (lambda (t) (up t 1))) 0) (up 0 2))
  (check-equal? ((g:* (down sin cos) (lambda (t) (up t 1))) 0) 1))

;; ---------------------------------------------------------------------------
;; Operators: sums are pointwise, products compose

(define V (literal-function 'V))
(define (act o f) (if (operator? o) (o f) (g:* o f)))

(for* ([x (in-list (append functions data))] [sum? '(#t #f)])
  (define op (if sum? g:+ g:-))
  (test-case (format "(~a D ~a) acts as the two do" (if sum? '+ '-) (value->text x))
    (check-true (same? (outcome (lambda () (((op D x) V) 't)))
                       (outcome (lambda () (op ((D V) 't) ((act x V) 't))))))
    (check-true (same? (outcome (lambda () (((op x D) V) 't)))
                       (outcome (lambda () (op ((act x V) 't) ((D V) 't))))))))

(for ([x (in-list (append functions data))])
  (test-case (format "the product of D and ~a composes" (value->text x))
    (check-true (same? ((g:* D x) V) (D (act x V))))
    (check-true (same? ((g:* x D) V) (act x (D V))))))

(test-case "an operator is divided by numbers and functions, never by an operator"
  (check-true (same? (g:/ D 2) (g:* 1/2 D)))
  (check-true (same? (g:/ D g:exp) (g:* (g:/ 1 g:exp) D)))
  (check-exn (inapplicable '/) (lambda () (g:/ 2 D)))
  (check-exn (inapplicable '/) (lambda () (g:/ D D))))

(test-case "an operator has natural powers"
  (check-true (same? (g:expt D 0) I-operator))
  (check-eq? (g:expt D 1) D)
  (check-true (same? (g:expt D 3) (g:* D D D)))
  (for ([n (list -1 1/2 'n D V (up 1 2))])
    (check-exn (inapplicable 'expt) (lambda () (g:expt D n)))))

;; ---------------------------------------------------------------------------
;; No and many operands

(test-case "no operands give the neutral elements, one gives itself"
  (check-equal? (list (g:+) (g:*)) '(0 1))
  (for ([x (in-list data)] #:unless (vector? x))
    (check-true (same? (g:+ x) x))
    (check-true (same? (g:* x) x))))

(test-case "several operands associate to the left"
  (check-equal? (g:+ 1 2 3 4) 10)
  (check-equal? (g:- 10 1 2 3) 4)
  (check-equal? (g:* 1 2 3 4) 24)
  (check-equal? (g:/ 60 2 3 5) 2)
  (check-equal? (g:+ (up 1 2) (up 1 2) (up 1 2)) (up 3 6))
  (check-equal? (g:* 2 (down 1 2) (up 3 4)) 22))

(test-case "one operand is negated or inverted"
  (check-equal? (g:- 3) -3)
  (check-equal? (g:- (up 1 'a)) (up -1 (g:* -1 'a)))
  (check-equal? (g:negate (down 1 2)) (down -1 -2))
  (check-equal? (g:/ 4) 1/4)
  (check-equal? (g:invert 'a) (g:/ 1 'a))
  (check-true (same? (g:invert (matrix-by-rows '(1 2) '(3 4)))
                     (matrix-by-rows '(-2 1) '(3/2 -1/2)))))

(test-case "exactness is kept"
  (check-equal? (g:/ 4 2) 2)
  (check-equal? (g:* 1/2 (up 1 3)) (up 1/2 3/2))
  (check-equal? (g:+ 1/2 0.5) 1.0)
  (check-equal? (g:* 0 'a) 0))

(test-case "the square of a tuple is the sum of squares, at any depth"
  (check-equal? (g:square (up 3 4)) 25)
  (check-equal? (g:square (down 3 (up 1 2))) 14)
  (check-equal? (g:square (vector 3 4)) 25)
  (check-equal? (g:cube (up 1 2)) (up 5 10))
  (check-equal? (g:cube 3) 27)
  (check-equal? (list (g:square -3) (g:square 1/2) (g:square 1.5) (g:square +i)) '(9 1/4 2.25 -1)))

(test-case "a list, a string or nothing at all does not combine"
  (for* ([(name op) (in-hash operations)]
         [bad (list '(1 2) "2" #f (void) #\a)]
         [good (list 1 'a (up 1 2) g:sin D (matrix-by-rows '(1)))])
    (check-exn (inapplicable name) (lambda () (op bad good)))
    (check-exn (inapplicable name) (lambda () (op good bad)))))
