#lang racket/base
;; The value of an integral of an S-expression in x at given numbers, to thirty digits.
;;
;; The path is cut wherever a part of the integrand that may divide, or stand under a root, a
;; logarithm, a modulus or a tangent, changes sign.  Each piece is summed with the substitution
;;
;;     x = p + (q - p) y,   y = 1/(1 + exp(π sinh u)),   dy = -π cosh u · y (1 - y) du
;;
;; (Takahasi and Mori 1974), which crowds points towards the ends, so that singularities there
;; do little harm.

(require racket/list
         "number.rkt")

(provide integral-value)

;; -> an exact number; 'none where the integrand has no value on a part of the path, or there is
;; no path, 'infinite where it has no integral, #f where that is not known
(define (integral-value e low high numbers)
  (define-values (p q) (values (number-at low numbers) (number-at high numbers)))
  (define (at x) (number-at e (hash-set numbers 'x x)))
  (cond [(not (and (rational? p) (rational? q) (not (= p q)))) 'none]
        [else
         (define places (append (list p) (cuts e p q numbers) (list q)))
         (for/fold ([sum 0]) ([a (in-list places)] [b (in-list (cdr places))])
           (define v (and (rational? sum) (piece at a b)))
           (if (rational? v) (+ sum v) (if (rational? sum) v sum)))]))

(define (piece at p q)
  (define inner (for/list ([r (in-list '(1/7 2/5 3/5 6/7))]) (at (+ p (* r (- q p))))))
  (cond [(not (andmap rational? inner)) (and (memq 'none inner) 'none)]
        [(or (not-integrable? at p (- q p)) (not-integrable? at q (- p q))) 'infinite]
        [else (converged at p q)]))

;; Does |e| grow as 1/distance, or faster, on approach to the end?
(define (not-integrable? at end width)
  (define (size h) (let ([v (at (+ end (* h width)))]) (if (rational? v) (abs (* h v)) 0)))
  (define-values (far near) (values (size (expt 2 -30)) (size (expt 2 -60))))
  (and (> near 1e-30) (> near (/ far 4))))

;; ---------------------------------------------------------------------------
;; Cuts

(define samples 40)
(define halvings 240)

;; In order from p to q.
(define (cuts e p q numbers)
  (define found
    (for*/list ([u (in-list (delicate-parts e))]
                [c (in-list (sign-changes
                             (lambda (x) (number-at u (hash-set numbers 'x x))) p q))])
      c))
  (for/fold ([kept '()] #:result (reverse kept)) ([c (in-list (sort found (if (< p q) < >)))])
    (if (and (pair? kept) (< (abs (- c (car kept))) (expt 2 -100))) kept (cons c kept))))

(define (sign-changes f p q)
  (define (place k) (+ p (* (- q p) (/ (+ k 1/3) samples))))
  (define (sign x) (let ([v (f x)]) (and (rational? v) (not (zero? v)) (positive? v) 1)))
  (for/list ([k (in-range (- samples 1))] #:unless (eqv? (sign (place k)) (sign (place (+ k 1)))))
    (define s (sign (place k)))
    (for/fold ([a (place k)] [b (place (+ k 1))] #:result (/ (+ a b) 2)) ([_ (in-range halvings)])
      (define m (/ (+ a b) 2))
      (if (eqv? s (sign m)) (values m b) (values a m)))))

;; All that stands within arguments that must not be zero or negative, and for each wave there
;; the other one, whose zeros are the places where 1 ± sin v touches zero.
(define (delicate-parts e)
  (define (inside e) (if (pair? e) (append (list e) (turned e) (append-map inside (cdr e))) '(x)))
  (define (turned e)
    (case (car e)
      [(sin tan) (list `(cos ,(cadr e)))]
      [(cos) (list `(sin ,(cadr e)))]
      [(asin acos acosh atanh) (list `(- 1 ,(cadr e)) `(+ 1 ,(cadr e)))]
      [else '()]))
  (let walk ([e e])
    (cond [(not (pair? e)) '()]
          [(or (memq (car e) '(/ sqrt abs sgn log tan atan asin acos acosh atanh))
               (and (eq? 'expt (car e)) (not (exact-nonnegative-integer? (caddr e)))))
           (remove-duplicates (append (turned e) (append-map inside (cdr e))))]
          [else (remove-duplicates (append-map walk (cdr e)))])))

;; ---------------------------------------------------------------------------
;; Sums

(define farthest 9/2)                   ; of u: there y is 2^-204

;; h -> ((y . weight) ...) for u = 0, h, 2h ... ; the other half mirrors it
(define nodes
  (let ([known (make-hasheqv)])
    (lambda (h)
      (or (hash-ref known h #f)
          (let ([all (for/list ([u (in-range 0 farthest h)]) (node u h))])
            (hash-set! known h all)
            all)))))

(define (node u h)
  (define y (number-at `(/ 1 (+ 1 (exp (* :pi (sinh ,u))))) (hasheq)))
  (cons y (* h (number-at `(* :pi (cosh ,u) ,y (- 1 ,y)) (hasheq)))))

;; -> a number or #f
(define (sum-at at p q h)
  (let/ec return
    (define (value x y)
      (define v (at x))
      (cond [(rational? v) v] [(< y (expt 2 -120)) 0] [else (return #f)]))
    (* (- q p)
       (for/sum ([n (in-list (nodes h))])
         (define-values (y weight) (values (car n) (cdr n)))
         (* weight
            (if (= y 1/2)
                (value (/ (+ p q) 2) y)
                (+ (value (+ p (* y (- q p))) y) (value (- q (* y (- q p))) y))))))))

;; Steps are halved until two sums agree; then the finer one is right to twice as many digits.
(define (converged at p q)
  (let loop ([h 1/8] [coarse #f])
    (define fine (and (>= h 1/32) (sum-at at p q h)))
    (cond [(not fine) #f]
          [(and coarse (< (abs (- fine coarse)) (* 1e-14 (+ 1 (abs fine))))) (rounded fine)]
          [else (loop (/ h 2) fine)])))

(define (rounded q) (/ (round (* q (expt 2 160))) (expt 2 160)))
