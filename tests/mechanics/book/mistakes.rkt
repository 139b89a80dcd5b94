#lang racket/base
;; The mistakes readers make, and what they are told: one case for each.

(require mechanics
         "../support/checks.rkt" "../support/messages.rkt" "../support/session.rkt")

(define (g x y) (* x y))
(define F (literal-function 'F (-> (X Real Real) Real)))
(define V (literal-function 'V))

(test-case "D of a function of two arguments, given one tuple"
  (check-message (string-append "(D g): g takes 2 arguments; it was given one up tuple of 2.\n"
                                "  Did you mean ((D g) 'x 'y)?")
                 ((D g) (up 'x 'y)))
  (check-prints ((D g) 'x 'y) '(down y x)))

(test-case "partial with the function among its indices"
  (check-message "partial: takes only indices; the function comes next: ((partial 0) F)"
                 ((partial 0 F) 'x 'y))
  (check-prints (((partial 0) F) 'x 'y) '(((partial 0) F) x y)))

(test-case "a number, a symbol or a component applied"
  (define s (up 1 (up 2 3)))
  (check-exn #rx"the value 2 is a number; it cannot be applied" (lambda () ((ref s 1 0))))
  (check-exn #rx"3 is a number; it cannot be applied" (lambda () (let ([m 3]) (m 'x))))
  (check-exn #rx"the component 1 of [(]up 1 [(]up 2 3[)][)] is not a function" (lambda () (s 1))))

(test-case "a lost parenthesis leaves two readable values"
  (define (H s) (square (ref s 0)))
  (check-equal? (format "~a ~a" (D H) (up 'x 'y)) "(D H) (up x y)"))

(test-case "too many arguments, one of them a procedure"
  (check-message "abs: expected 1 argument, given 2: the procedure `-`, 10.3" (abs - 10.3)))

(test-case "a literal function of the wrong shape"
  (check-message
   (string-append "V: was declared (-> Real Real); slot 0 got (up x y), an up tuple of 2\n"
                  "  a signature such as (-> (UP Real Real) Real) declares a function of tuples")
   (V (up 'x 'y)))
  (check-message
   "F: was declared (-> (X Real Real) Real); slot 1 got (up x y), an up tuple of 2\n  a signature such as (-> (UP Real Real) Real) declares a function of tuples"
   (F 't (up 'x 'y))))

(test-case "a scalar added to a tuple"
  (check-message (string-append "+: cannot add a number-like expression and an up tuple of 2\n"
                                "  argument 1: the symbol a\n"
                                "  argument 2: (up 1 2), an up tuple of 2")
                 (+ 'a (up 1 2))))

(test-case "tuples that do not contract multiply as in the book; the dot product does not"
  (check-prints (* (up 1 2) (up 1 2 3)) '(up (up 1 2) (up 2 4) (up 3 6)))
  (check-message "dot-product: the tuples differ in length\n  first: (up 1 2)\n  second: (up 1 2 3)"
                 (dot-product (up 1 2) (up 1 2 3)))
  (check-prints (* (down 1 2) (up 1 2 3)) '(up (down 1 2) (down 2 4) (down 3 6)))
  (check-exn #rx"their lengths differ$"
             (lambda () (parameterize ([unequal-contraction 'error]) (* (down 1 2) (up 1 2 3))))))

(test-case "D of a number or a symbol"
  (check-message "D: needs a function; 3 is a number\n  the constant function is (lambda (x) 3)"
                 (D 3))
  (check-message "D: needs a function; 3 is a number\n  the constant function is (lambda (x) 3)"
                 ((D 3) 'x))
  (check-exn #rx"^D: needs a function; x is a number-like expression" (lambda () (D 'x))))

(test-case "an index beyond the tuple"
  (check-message "ref: index 5 is outside an up tuple of 2 (indices 0 to 1)\n  in: (up 1 2)"
                 (ref (up 1 2) 5)))

(test-case "a wrong number of arguments names the procedure"
  (check-exn #rx"^expt: " (lambda () (expt 'x)))
  (define (G x y z) x)
  (check-exn #rx"^G: arity mismatch" (lambda () ((compose G sin) 'x))))

(test-case "a list for coordinates"
  (define (L local) (square (velocity local)))
  (check-exn #rx"a list is not a tuple; use [(]up " (lambda () (+ '(1 2) (up 1 2))))
  (check-exn #rx"a list is not a tuple; use [(]up "
             (lambda () (((Lagrange-equations L) (lambda (t) (list t t))) 't)))
  (check-exn #rx"a list is not a tuple; use [(]up " (lambda () ((Lagrange-equations L) (list V V))))
  (check-exn #rx"a list is not a tuple; use [(]up " (lambda () ((D L) '(1 2)))))

(test-case "an order between symbols"
  (check-message
   (string-append
    "<: an expression that is not a number has no order; give its symbols values first\n"
    "  as an assumption, the relation is quoted: (assume '(< a b))\n"
    "  value: the symbol a")
   (< 'a 'b))
  (check-exn #rx"^max: an expression that is not a number has no order" (lambda () (max 1 'x))))

(test-case "time as Racket's form"
  (check-exn #rx"^time: .*Racket's form for timing an expression" (lambda () (time (+ 1 2))))
  (define (L (up t q v)) (* 1/2 (square v)))
  (check-exn #rx"time is the book's selector; [(]show-time expression[)] tells how long one takes"
             (lambda () (time (evolve-trajectory (Lagrangian->state-derivative L) (up 0 1 0) 1)))))

(test-case "the parameters of a Lagrangian forgotten"
  (define ((L-harmonic m k) (up t q v)) (- (* 1/2 m (square v)) (* 1/2 k (square q))))
  (check-exn
   #rx"^Lagrange-equations: a Lagrangian takes one argument, the local tuple, but L-harmonic does not"
   (lambda () (Lagrange-equations L-harmonic)))
  (check-exn
   #rx"^Lagrange-equations: a path is a function of time.*\n  [(]literal-function 'x[)] makes a path of that name"
   (lambda () ((Lagrange-equations (L-harmonic 'm 'k)) 'x))))

(test-case "a path of more coordinates than the Lagrangian's pattern takes"
  (define ((L-plane m) (up t (up x y) (up vx vy))) (* 1/2 m (+ (square vx) (square vy))))
  (check-exn
   #rx"L-plane: .* does not match the pattern .*component 1, expected an up tuple of 2, given [(]up [(]V t[)] [(]V t[)] [(]V t[)][)]"
   (lambda () (((Lagrange-equations (L-plane 'm)) (up V V V)) 't))))
