#lang racket/base
;; Proofs of large residuals; nothing else is proved.

(require mechanics/algebra/expression/expression
         mechanics/algebra/expression/operation
         mechanics/algebra/expression/flat-graph
         mechanics/algebra/zero/abstracted-parts
         mechanics/algebra/zero/in-exponentials
         mechanics/algebra/zero/proof
         mechanics/algebra/simplify/simplify-expression
         mechanics/algebra/zero/zero-test
         mechanics/algebra/expression/read
         "../../support/checks.rkt" "../../support/evaluate.rkt"
         "../../support/random.rkt"
         "../../support/random/expression.rkt")

(define (sum es) (for/fold ([s 0]) ([e (in-list es)]) (e:+ s e)))
(define (numbered name n)
  (for/list ([i (in-range n)]) (string->symbol (format "~a~a" name i))))
(define (status e) (zero-test-status (zero-test e)))

;; ---------------------------------------------------------------------------
;; Residuals that are zero, and those next to them

;; (A + B)(A - B) - (A² - B²) for long powers A and B.
(define (difference-of-squares)
  (define A (e:expt (sum (numbered 'a 4)) 20))
  (define B (e:expt (sum (numbered 'b 4)) 20))
  (e:- (e:* (e:+ A B) (e:- A B)) (e:- (e:* A A) (e:* B B))))

;; The end of a chain of turns by these angles.
(define (turned x y angles)
  (for/fold ([x x] [y y] #:result (e:+ x (e:* 2 y))) ([u (in-list angles)])
    (define c (e:apply op:cos u))
    (define s (e:apply op:sin u))
    (values (e:- (e:* x c) (e:* y s)) (e:+ (e:* x s) (e:* y c)))))

(define (turns n)
  (for/list ([k (in-range n)])
    (e:+ (e:* (+ 1 (modulo (* 3 k) 7)) (list-ref '(a b c) (modulo k 3)))
         (e:* (+ 1 (modulo k 5)) (list-ref '(a b c) (modulo (* 2 k) 3))))))

(define (commuting-turns [angles (turns 12)])
  (e:- (turned 'x 'y angles) (turned 'x 'y (reverse (turns 12)))))

;; Sums of fractions, one by one and over a common denominator.
(define (fractions n)
  (define fs
    (for/list ([p (in-list (numbered 'p n))] [a (in-list (numbered 'a n))])
      (cons p (e:+ (e:* 'x a) 'b))))
  (e:- (sum (for/list ([f (in-list fs)]) (e:/ (car f) (cdr f))))
       (for/fold ([p 0] [q 1] #:result (e:/ p q)) ([f (in-list fs)])
         (values (e:+ (e:* p (cdr f)) (e:* q (car f))) (e:* q (cdr f))))))

;; det(AB) - det A det B
(define (determinants n)
  (define (matrix name)
    (for/list ([i (in-range n)]) (numbered (format "~a~a" name i) n)))
  (define (minor M j)
    (for/list ([row (in-list (cdr M))])
      (for/list ([x (in-list row)] [k (in-naturals)] #:unless (= k j)) x)))
  (define (determinant M)
    (if (null? (cdr M))
        (caar M)
        (sum (for/list ([x (in-list (car M))] [j (in-naturals)])
               (e:* (if (odd? j) -1 1) (e:* x (determinant (minor M j))))))))
  (define (product A B)
    (for/list ([row (in-list A)])
      (for/list ([column (in-list (apply map list B))])
        (sum (map e:* row column)))))
  (define A (matrix 'a))
  (define B (matrix 'b))
  (e:- (determinant (product A B)) (e:* (determinant A) (determinant B))))

(define vanishing
  (list (difference-of-squares) (commuting-turns) (fractions 8) (fractions 16) (determinants 4)
        (determinants 5)))

(test-case "large residuals that vanish are proved to"
  (for ([e (in-list vanishing)])
    (define v (zero-test e))
    (check-eq? (zero-test-status v) 'proved (format "~a" e))
    (check-eqv? (zero-test-core v) 0 (format "~a" e))))

(test-case "so they are with one term more refuted"
  (for ([e (in-list vanishing)])
    (check-eq? (status (e:+ e (e:* 1/1000 'b))) 'refuted (format "~a" e))))

(test-case "no proof is found of what does not vanish"
  (for ([e (in-list (list* (commuting-turns (cons 'a (cdr (turns 12))))
                           (for/list ([e (in-list vanishing)]) (e:+ e 'z))))])
    (check-false (prove-vanishing (expression->tape e)))))

(test-case "flonums are not proved, by whatever way"
  (check-eq? (status (e:* 1.5 (e:+ (difference-of-squares) (commuting-turns)))) 'undecided))

;; ---------------------------------------------------------------------------
;; Exponentials

(test-case "circular and hyperbolic functions keep their values as exponentials"
  (define u (e:+ 'a (e:* 2 'b)))
  (for* ([f (in-list (list op:sin op:cos op:tan op:sinh op:cosh op:tanh))])
    (define e (e:+ 'c (e:apply f u)))
    (define lookup (lambda (leaf arguments) (case leaf [(a) 1/3] [(b) 1/7] [(c) 2])))
    (check-= (magnitude (- (evaluate-expression e lookup)
                           (evaluate-expression (in-exponentials e) lookup)))
             0 1e-12)
    (check-equal? (prove-vanishing (expression->tape (e:- e (in-exponentials e)))) '())))

(test-case "without such functions nothing is rewritten"
  (define e (datum->expression '(+ (expt a 2) (exp (* b (f a))))))
  (check-eq? (in-exponentials e) e))

;; ---------------------------------------------------------------------------
;; Abstraction

(test-case "long parts that need not be looked at become symbols"
  (define-values (general differences) (abstract (expression->tape (difference-of-squares))))
  (check-equal? differences '())
  (check-equal? (simplify-expression general) 0)
  (check-true (< (tape-length (expression->tape general)) 12)))

(test-case "parts that are equal in value are one symbol, and remain to be proved equal"
  (define big (for/fold ([e 'z]) ([a (in-list (numbered 'a 12))]) (e:expt (e:+ e a) 3)))
  (define-values (general differences)
    (abstract
     (expression->tape
      (e:- (e:* big (e:expt (datum->expression '(+ (expt (sin x) 2) (* 2 x) (expt (cos x) 2))) 2))
           (e:* big (e:expt (datum->expression '(+ 1 (* 2 x))) 2))))))
  (check-equal? (simplify-expression general) 0)
  (for ([d (in-list differences)]) (check-equal? (simplify-expression d) 0)))

(test-case "what vanishes only because of what its parts are is left as it is"
  (define-values (general differences)
    (abstract (expression->tape
               (datum->expression
                '(- (expt (sin (* 2 x)) 2) (* 4 (expt (sin x) 2) (expt (cos x) 2)))))))
  (check-false general))

;; ---------------------------------------------------------------------------
;; At random

(define (for-each-difference rules try)
  (with-seeds 40
    (for ([rule (in-list rules)])
      (define e (random-expression 4 '(rational trigonometric exponential)))
      (define other (with-handlers ([exn:fail:contract:divide-by-zero? (lambda (x) e)])
                      (rewrite e rule)))
      (try (e:- e other)))))

(define (zero-by-normal-form? e) (eqv? 0 (simplify-expression e)))

(test-case "every way of proving agrees with the normal form"
  (for-each-difference (append sound-rewrites unsound-rewrites)
    (lambda (e)
      (define zero? (zero-by-normal-form? e))
      (check-equal? (and (prove-vanishing (expression->tape e)) #t) zero? (format "~a" e))
      (define-values (general differences) (abstract (expression->tape e)))
      (when (and general (andmap zero-by-normal-form? (cons general differences)))
        (check-true zero? (format "~a" e)))
      (check-equal? (zero-by-normal-form? (in-exponentials e)) zero? (format "~a" e)))))

;; ---------------------------------------------------------------------------
;; Tapes

(test-case "equal nodes are one item of a tape, whatever the order of commuting operands"
  (define (built d) (datum->expression d))
  (check-equal? (tape-length (expression->tape
                              (make-node op:+
                                         (list (built '(* (+ a b) c)) (built '(* c (+ b a)))))))
                6)
  (check-equal? (tape-length (expression->tape (built '(- (f a b) (f b a))))) 5)
  (check-equal? (tape-length (expression->tape (built '(- (expt a 2) (expt 2 a))))) 5))

(test-case "an expression comes back from its tape, equal nodes being the same"
  (with-seeds 40
    (define e (random-expression 5 '(rational trigonometric exponential)))
    (define t (expression->tape e))
    (define back (tape->expression t))
    (check-equal? back e)
    (check-equal? (tape-length (expression->tape back)) (tape-length t))))

(test-case "tapes of one expression made by several threads are the same"
  (define e (commuting-turns))
  (define expected (tape-operands (expression->tape e)))
  (define results (make-vector 4 #f))
  (define threads
    (for/list ([i (in-range 4)])
      (thread (lambda ()
                (vector-set! results i
                             (for/and ([_ (in-range 60)])
                               (define ks (tape-operands (expression->tape e)))
                               (sleep 0)
                               (equal? ks expected)))))))
  (for-each thread-wait threads)
  (check-equal? results (make-vector 4 #t)))

;; ---------------------------------------------------------------------------
;; Roots

(test-case "roots are not taken of complex exponentials"
  (define (vanishes? d) (prove-vanishing (expression->tape (datum->expression d))))
  (check-equal? (vanishes? '(- (sqrt (expt (cos u) 2)) (cos u))) '((>= (cos u) 0)))
  (check-false (vanishes? '(- (sqrt (expt (+ (expt (cos u) 2) (expt (sin v) 2)) 2)) (cos u))))
  (check-true (single-valued? (datum->expression '(+ (cos u) (expt (exp v) -2) (f (sinh u) t)))))
  (for ([d (in-list '((sqrt (cos u)) (abs u) (log (exp u)) (expt u 1/2)
                      (expt u n) (asin (sin u))))])
    (check-false (single-valued? (datum->expression d)))))
