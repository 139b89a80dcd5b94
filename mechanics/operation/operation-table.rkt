#lang racket/base
;; The table of operations: each operation in one entry, which defines it.
;;
;;     [key (argument ...) numeric domain partial ... fact ...]
;;
;; numeric is the name of the function of numbers; of a composite operation, which heads no
;; expressions, an expression in the arguments.  domain lists, for each argument, an interval
;; on which the operation is real and smooth: there every derivative is tested.
;;
;; Each argument has a partial derivative, an expression in the arguments and in `value`, the
;; operation's value there (so that exp and sqrt share the node they are made of);
;; `(slope a b)` is the quotient a/b, or the complaint that there is no derivative where b
;; vanishes; and `(pole a)` is a, of an operation that has no value at some arguments.
;;
;; The facts are
;;
;;     (called name)     the name, where it is not the key
;;     total             it is continuous and has a value at every real argument
;;     (real how x)      it is real for arguments `from` x, `above` x, or `within` x of 0
;;     odd, even         its parity
;;     increasing        it grows with its argument
;;     positive, nonnegative  the sign of its real values
;;     meromorphic       it has no branches
;;     circular, hyperbolic, arc  its family
;;     (inverse-of f)    f takes the value back to the argument
;;     (together-with 'f) its Taylor coefficients come with those of f
;;     (equations e)     the equations of its value (generic/operation-rule/operation-equations.rkt)
;;
;; The table is data for macros: a module requires it for-syntax and makes procedures of the
;; expressions, in its own arithmetic.  Counterparts of an operation in other languages and other
;; kinds of number stand on their own floors, in columns (operation-column.rkt).

(provide entries-where find-entry entry-fact entry-name
         (struct-out entry)
         reciprocals)

(define arithmetic
  '([+ (a b) + ((-2.0 2.0) (-2.0 2.0)) 1 1
       (equations (list (algebraic #f 0 (term 1 #f 'a) (term 1 #f 'b))))]
    [- (a b) - ((-2.0 2.0) (-2.0 2.0)) 1 -1
       (equations (list (algebraic #f 0 (term 1 #f 'a) (term -1 #f 'b))))]
    [* (a b) * ((-2.0 2.0) (-2.0 2.0)) b a
       (equations (list (algebraic #f 0 (term 1 'a 'b))))]
    [/ (a b) / ((-2.0 2.0) (0.3 2.0)) (g:/ 1 b) (pole (g:negate (g:/ value b)))
       (equations (list (algebraic 'b 0 (term 1 #f 'a))))]
    [expt (b n) expt ((0.7 2.0) (-3.0 3.0)) (power-by-base b n) (power-by-exponent b n value)]))

(define functions
  '([sqrt (x) sqrt ((0.2 5.0)) (slope 1 (g:* 2 value))
          (real from 0) increasing nonnegative (inverse-of square)
          (equations (list (algebraic 'r 0 (term 1 #f 'a))))]
    [exp (x) exp ((-2.0 2.0)) value
         total increasing positive meromorphic
         (equations (list (differential #f (term 1 'r 'a))))]
    [log (x) log ((0.2 5.0)) (slope 1 x)
         (real above 0) increasing (inverse-of exp)
         (equations (list (differential 'a (term 1 #f 'a))))]

    [sin (x) sin ((-4.0 4.0)) (g:cos x)
         circular total odd meromorphic (equations (pair 1 'cos -1))]
    [cos (x) cos ((-4.0 4.0)) (g:negate (g:sin x))
         circular total even meromorphic (together-with 'sin) (equations (pair -1 'sin 1))]
    [tan (x) tan ((-1.2 1.2)) (pole (g:+ 1 (g:square value)))
         circular odd meromorphic
         (equations (list (differential #f (term 1 'p 'a)) (algebraic #f 1 (term 1 'r 'r))))]
    [asin (x) asin ((-0.9 0.9)) (slope 1 (g:sqrt (g:- 1 (g:square x))))
          arc (real within 1) odd increasing (inverse-of sin) (equations (inverse 1 'cos -1))]
    [acos (x) acos ((-0.9 0.9)) (slope -1 (g:sqrt (g:- 1 (g:square x))))
          arc (real within 1) nonnegative (inverse-of cos) (equations (inverse -1 'sin 1))]
    [atan (y) atan ((-3.0 3.0)) (slope 1 (g:+ 1 (g:square y)))
          arc odd increasing (inverse-of tan)
          (equations (list (differential 'p (term 1 #f 'a)) (algebraic #f 1 (term 1 'a 'a))))]
    [atan2 (y x) atan ((0.2 2.0) (-2.0 2.0))
           (slope x (g:+ (g:square x) (g:square y)))
           (slope (g:negate y) (g:+ (g:square x) (g:square y)))
           (called atan) arc
           (equations (list (differential 'p (term 1 'b 'a) (term -1 'a 'b))
                            (algebraic #f 0 (term 1 'a 'a) (term 1 'b 'b))))]

    [sinh (x) sinh ((-3.0 3.0)) (g:cosh x)
          hyperbolic total odd increasing meromorphic (equations (pair 1 'cosh 1))]
    [cosh (x) cosh ((-3.0 3.0)) (g:sinh x)
          hyperbolic total even positive meromorphic (together-with 'sinh)
          (equations (pair 1 'sinh 1))]
    [tanh (x) tanh ((-3.0 3.0)) (g:- 1 (g:square value))
          hyperbolic total odd increasing meromorphic
          (equations (list (differential #f (term 1 'p 'a)) (algebraic #f 1 (term -1 'r 'r))))]
    [asinh (x) asinh ((-3.0 3.0)) (slope 1 (g:sqrt (g:+ (g:square x) 1)))
           total odd increasing (inverse-of sinh) (equations (inverse 1 'cosh 1))]
    [acosh (x) acosh ((1.1 4.0)) (slope 1 (g:* (g:sqrt (g:- x 1)) (g:sqrt (g:+ x 1))))
           (real from 1) increasing (inverse-of cosh) (equations (inverse 1 'sinh 1))]
    [atanh (x) atanh ((-0.8 0.8)) (slope 1 (g:- 1 (g:square x)))
           (real within 1) odd increasing (inverse-of tanh)
           (equations (list (differential 'p (term 1 #f 'a)) (algebraic #f 1 (term -1 'a 'a))))]

    [erf (x) erf ((-2.0 2.0)) (g:* (two-over-root-pi x) (g:exp (g:negate (g:square x))))
         total odd increasing meromorphic]

    [abs (x) modulus ((-2.0 -0.1)) (slope x (real-value 'abs value x)) total even nonnegative]
    [sgn (x) sgn ((-2.0 -0.1)) (slope 0 (real-value 'sgn value x)) odd]))

(define composites
  '([square (a) (g:* a a) ((-2.0 2.0)) (g:* 2 a)]
    [cube (a) (g:* a (g:square a)) ((-2.0 2.0)) (g:* 3 (g:square a))]
    [negate (a) (g:negate a) ((-2.0 2.0)) -1 (called -)]
    [exact->inexact (x) x ((-2.0 2.0)) 1]))

;; Functions printed as quotients: name, the function it is the reciprocal of, its value at x.
(define reciprocals
  '([sec cos (g:/ 1 (g:cos x))]
    [csc sin (g:/ 1 (g:sin x))]
    [cot tan (g:/ (g:cos x) (g:sin x))]
    [sech cosh (g:/ 1 (g:cosh x))]
    [csch sinh (g:/ 1 (g:sinh x))]
    [coth tanh (g:/ (g:cosh x) (g:sinh x))]))

;; ---------------------------------------------------------------------------

;; facts : symbols and lists, with the group `arithmetic`, `function` or `composite`
(struct entry (key arguments numeric domain partials facts))

(define ((read-entry group) data)
  (define arguments (cadr data))
  (define-values (partials facts)
    (for/fold ([partials '()] [rest (list-tail data 4)] #:result (values (reverse partials) rest))
              ([_ (in-list arguments)])
      (values (cons (car rest) partials) (cdr rest))))
  (entry (car data) arguments (caddr data) (cadddr data) partials (cons group facts)))

(define entries
  (append (map (read-entry 'arithmetic) arithmetic)
          (map (read-entry 'function) functions)
          (map (read-entry 'composite) composites)))

;; name : of a fact; -> its value, #t where it has none; #f of other operations
(define (entry-fact e name)
  (define facts (entry-facts e))
  (cond [(memq name facts) #t]
        [(assq name (filter pair? facts)) => cdr]
        [else #f]))

(define (entry-name e)
  (define name (entry-fact e 'called))
  (if name (car name) (entry-key e)))

;; The entries for which all these facts hold, in the order of the table.
(define (entries-where . names)
  (for/list ([e (in-list entries)] #:when (for/and ([n (in-list names)]) (entry-fact e n))) e))

(define (find-entry key)
  (for/first ([e (in-list entries)] #:when (eq? key (entry-key e))) e))
