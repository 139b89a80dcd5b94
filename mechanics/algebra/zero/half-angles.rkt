#lang racket/base
;; Sines and exponentials as rational functions, so that factors are counted as often as they are.
;;
;; 1 − cos x is irreducible over sines and cosines, and yet a square: with T = tan(x/2) it is
;; 2T²/(1 + T²); cosh x − 1 is (E − 1)²/2E with E = eˣ.  Angles are sums of whole multiples of
;; *steps*: of a − b and a the steps are a/2 and b/2.

(require racket/list
         "../expression/expression.rkt" "../expression/nodes.rkt" "../expression/operation.rkt"
         "../expression/substitute.rkt"
         (only-in "../../numeric/finite-number.rkt" exact-rational?))

(provide rationalized (struct-out stand-in) exponential-stand-in?)

;; A symbol for a quotient: for the tangent of half a step, sine over cosine, or for an exponential
;; over 1
(struct stand-in (symbol over under) #:authentic)

(define (exponential-stand-in? t) (eqv? 1 (stand-in-under t)))

;; -> e in terms of symbols, and the values that they stand for
(define (rationalized e)
  (define angles (steps-of e circular-functions))
  (define growths (steps-of e exponential-functions))
  (define memo (make-memo))
  (define (walk e) (if (node? e) (memo e (lambda () (walk-node e))) e))
  (define (walk-node n)
    (or (rational-form n angles growths) (rebuild (node-head n) (map walk (node-args n)))))
  (values (walk e) (append (map half-tangent angles) (map exponential growths))))

(define (half-tangent s)
  (define half (e:* 1/2 (step-size s)))
  (stand-in (step-symbol s) (e:apply op:sin half) (e:apply op:cos half)))

(define (exponential s) (stand-in (step-symbol s) (e:apply op:exp (step-size s)) 1))

;; -> an expression in symbols, or #f
(define (rational-form n angles growths)
  (define head (node-head n))
  (cond [(memq head circular-functions)
         (define z (turned (car (node-args n)) angles))
         (and z (by-turn head z))]
        [(memq head exponential-functions)
         (define g (grown (car (node-args n)) growths))
         (and g (by-exponential head g))]
        [else #f]))

;; z : a pair of cosine and sine
(define (by-turn head z)
  (cond [(eq? head op:cos) (car z)]
        [(eq? head op:sin) (cdr z)]
        [else (e:/ (cdr z) (car z))]))

(define exponential-functions (list op:exp op:sinh op:cosh op:tanh))

(define (by-exponential head g)
  (define half-sum (e:/ (e:+ g (e:/ 1 g)) 2))
  (define half-difference (e:/ (e:- g (e:/ 1 g)) 2))
  (cond [(eq? head op:exp) g]
        [(eq? head op:cosh) half-sum]
        [(eq? head op:sinh) half-difference]
        [else (e:/ half-difference half-sum)]))

;; ---------------------------------------------------------------------------
;; Steps

;; atom : an expression, not a sum; measure : a rational of which its multiples are multiples
(struct step (atom measure symbol) #:authentic)

(define (step-size s) (e:* (step-measure s) (step-atom s)))

(define (steps-of e heads)
  (define terms
    (for*/list ([n (in-list (nodes-in e))]
                #:when (memq (node-head n) heads)
                [m (in-list (multiples (car (node-args n))))])
      m))
  (for/list ([group (in-list (group-by cdr terms))])
    (step (cdr (car group)) (apply gcd (map car group)) (string->uninterned-symbol "T"))))

;; -> ((rational . atom) ...), the sum of which is e
(define (multiples e)
  (define head (and (node? e) (node-head e)))
  (define args (if head (node-args e) '()))
  (define (scaled c e) (for/list ([m (in-list (multiples e))]) (cons (* c (car m)) (cdr m))))
  (cond [(eq? head op:+) (append-map multiples args)]
        [(eq? head op:-) (append (multiples (car args)) (scaled -1 (cadr args)))]
        [(and (eq? head op:/) (exact-rational? (cadr args))) (scaled (/ 1 (cadr args)) (car args))]
        [(and (eq? head op:*) (exact-rational? (car args)))
         (scaled (car args) (rebuild op:* (cdr args)))]
        [(exact-rational? e) (if (eqv? e 0) '() (list (cons e 1)))]
        [else (list (cons 1 e))]))

;; How often each step stands in e; #f if too often
(define (counts e steps)
  (define all
    (for/fold ([table (hash)]) ([m (in-list (multiples e))])
      (define s (findf (lambda (s) (equal? (step-atom s) (cdr m))) steps))
      (hash-update table s (lambda (k) (+ k (/ (car m) (step-measure s)))) 0)))
  (and (<= (for/sum ([k (in-hash-values all)]) (abs k)) most-steps) all))

(define most-steps 8)

;; -> cosine and sine of e, by the tangents; or #f
(define (turned e steps)
  (define all (counts e steps))
  (and all
       (for*/fold ([z (cons 1 0)]) ([(s k) (in-hash all)] [_ (in-range (abs k))])
         (rotated z (step-symbol s) (if (negative? k) -1 1)))))

(define (rotated z T sense)
  (define below (e:+ 1 (e:expt T 2)))
  (define c (e:/ (e:- 1 (e:expt T 2)) below))
  (define s (e:/ (e:* (* 2 sense) T) below))
  (cons (e:- (e:* (car z) c) (e:* (cdr z) s))
        (e:+ (e:* (cdr z) c) (e:* (car z) s))))

(define (grown e steps)
  (define all (counts e steps))
  (and all
       (for/fold ([g 1]) ([(s k) (in-hash all)]) (e:* g (e:expt (step-symbol s) k)))))
