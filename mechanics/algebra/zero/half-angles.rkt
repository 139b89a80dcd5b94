#lang racket/base
;; Sines and exponentials as rational functions, so that factors are counted as often as they are.
;;
;; 1 − cos x is irreducible over sines and cosines, and yet a square: with T = tan(x/2) it is
;; 2T²/(1 + T²); cosh x − 1 is (E − 1)²/2E with E = eˣ.  Angles are sums of whole multiples of
;; *steps*: of a − b and a the steps are a/2 and b/2.

(require racket/list
         "../expression/expression.rkt" "../expression/operation.rkt"
         "../expression/substitute.rkt")

(provide rationalized)

;; -> e with a symbol of its own for the tangent of half of each step, and for each exponential;
;; and ((symbol sine cosine) ...) or ((symbol exponential 1) ...): what they are quotients of
(define (rationalized e)
  (define circular (steps-of e circular-functions))
  (define exponential (steps-of e exponential-functions))
  (define (rational n)
    (define head (node-head n))
    (define (turn) (turned (car (node-args n)) circular))
    (define (growth) (grown (car (node-args n)) exponential))
    (cond [(memq head circular-functions)
           (define z (turn))
           (and z
                (cond [(eq? head op:cos) (car z)]
                      [(eq? head op:sin) (cdr z)]
                      [else (e:/ (cdr z) (car z))]))]
          [(memq head exponential-functions)
           (define g (growth))
           (and g (by-exponential head g))]
          [else #f]))
  (define memo (make-memo))
  (values (let walk ([e e])
            (if (node? e)
                (memo e (lambda ()
                          (or (rational e) (rebuild (node-head e) (map walk (node-args e))))))
                e))
          (append (for/list ([s (in-list circular)])
                    (define h (e:* 1/2 (step-size s)))
                    (list (step-symbol s) (e:apply op:sin h) (e:apply op:cos h)))
                  (for/list ([s (in-list exponential)])
                    (list (step-symbol s) (e:apply op:exp (step-size s)) 1)))))

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
  (define found (make-hash))            ; atom -> measure
  (define order '())
  (define (note! term)
    (unless (hash-has-key? found (cdr term)) (set! order (cons (cdr term) order)))
    (hash-update! found (cdr term) (lambda (m) (gcd m (car term))) 0))
  (node-fold e void
             (lambda (n _)
               (when (memq (node-head n) heads) (for-each note! (multiples (car (node-args n)))))))
  (for/list ([atom (in-list (reverse order))])
    (step atom (hash-ref found atom) (string->uninterned-symbol "T"))))

;; -> ((rational . atom) ...), the sum of which is e
(define (multiples e)
  (define head (and (node? e) (node-head e)))
  (define args (if head (node-args e) '()))
  (define (scaled c e) (for/list ([m (in-list (multiples e))]) (cons (* c (car m)) (cdr m))))
  (cond [(eq? head op:+) (append-map multiples args)]
        [(eq? head op:-) (append (multiples (car args)) (scaled -1 (cadr args)))]
        [(and (eq? head op:/) (exact-number? (cadr args))) (scaled (/ 1 (cadr args)) (car args))]
        [(and (eq? head op:*) (exact-number? (car args)))
         (scaled (car args) (rebuild op:* (cdr args)))]
        [(exact-number? e) (if (eqv? e 0) '() (list (cons e 1)))]
        [else (list (cons 1 e))]))

(define (exact-number? x) (and (rational? x) (exact? x)))

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
