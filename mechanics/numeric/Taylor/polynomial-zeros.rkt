#lang racket/base
;; The zeros of a polynomial between 0 and 1, none of them missed.
;;
;; By Descartes's rule in Budan's form, p has at most as many zeros in (0, 1) as the
;; coefficients of (1 + x)ⁿ p(1/(1 + x)) change their sign, and as many up to an even number:
;; with no change there is none, with one there is one.  Where there are more, the extremum
;; of p is found in the same way if there is one only, which parts two zeros however close,
;; or shows that p touches zero or stays away; otherwise the interval is halved.  A zero that
;; is known to be alone is refined by Newton's method within its bounds.

(require racket/flonum
         racket/unsafe/ops
         "../unboxed-loop.rkt")

(provide polynomial-zeros (struct-out zero) polynomial-value halved shifted)

;; at : in (0, 1]; kind : 'rising, 'falling, or 'touching if p keeps its sign
(struct zero (at kind) #:transparent)

;; p : flvector of coefficients, from order 0 on; touch : a value up to this at an
;; extremum counts as zero -> zeros, in their order.  A zero at 0 itself is none.
(define (polynomial-zeros p touch)
  (define q (without-zero-at-0 p))
  (cond [(or (< (flvector-length q) 2) (keeps-sign? q)) '()]
        [else
         (define inside (search q 0.0 1.0 touch most-halvings))
         (if (fl= (polynomial-value q 1.0) 0.0)
             (append inside (list (zero 1.0 (direction (polynomial-value (derivative q) 1.0)))))
             inside)]))

(define (without-zero-at-0 p)
  (define n (flvector-length p))
  (let loop ([k 0])
    (cond [(= k n) (flvector)]
          [(not (fl= (flvector-ref p k) 0.0)) (if (= k 0) p (flvector-copy p k n))]
          [else (loop (+ k 1))])))

;; Do the terms up to order 10 keep p from 0 in (0, 1], whatever the others are?  With x = 1/(1 + t)
;; these are at most r = Σ |c_k| in size, and r (1 + t)¹⁰ has binomial coefficients.
(define (keeps-sign? p)
  (define n (flvector-length binomials))
  (and (> (flvector-length p) n)
       (let ([rest (sizes-from p n)] [q (transformed p n)])
         (define-syntax-rule (all-beyond? sign)
           (for/and ([c (in-flvector q)] [b (in-flvector binomials)])
             (unsafe-fl> (unsafe-fl* sign c) (unsafe-fl* rest b))))
         (or (all-beyond? 1.0) (all-beyond? -1.0)))))

(define binomials (flvector 1.0 10.0 45.0 120.0 210.0 252.0 210.0 120.0 45.0 10.0 1.0))

(define (sizes-from p n)
  (let loop ([k n] [sum 0.0])
    (if (unsafe-fx= k (flvector-length p))
        (unboxed sum)
        (loop (unsafe-fx+ k 1) (unsafe-fl+ sum (unsafe-flabs (at p k)))))))

(define most-halvings 40)

(define (direction slope)
  (cond [(fl> slope 0.0) 'rising] [(fl< slope 0.0) 'falling] [else 'touching]))

;; ---------------------------------------------------------------------------

;; The zeros of p in (0, 1), which is the part of the whole from `low` on of that width.
(define (search p low width touch halvings)
  (define (only a b) (only-zero p a b low width))
  (define changes (sign-changes p))
  (cond
    [(= changes 0) '()]
    [(= changes 1) (crossing p 0.0 1.0 low width)]
    [else
     (define slope (derivative p))
     (define turns (sign-changes slope))
     (cond
       [(or (= turns 0) (= halvings 0)) (only 0.0 1.0)]
       [(= turns 1)
        (define turn (refined slope 0.0 1.0))
        (if (touches? p turn touch)
            (list (zero (fl+ low (fl* width turn)) 'touching))
            (append (only 0.0 turn) (only turn 1.0)))]
       [else (search-halves p low width touch (- halvings 1))])]))

;; The zero between a and b, if there is one, where p has no other.
(define (only-zero p a b low width) (if (opposite? p a b) (crossing p a b low width) '()))

(define (crossing p a b low width)
  (define rise (fl- (polynomial-value p b) (polynomial-value p a)))
  (list (zero (fl+ low (fl* width (refined p a b))) (direction rise))))

(define (search-halves p low width touch halvings)
  (define left (halved p))
  (define right (shifted left))
  (define half (fl* 0.5 width))
  (define middle
    (if (fl= (flvector-ref right 0) 0.0)
        (list (zero (fl+ low half) (direction (polynomial-value (derivative right) 0.0))))
        '()))
  (append (search left low half touch halvings)
          middle
          (search (without-zero-at-0 right) (fl+ low half) half touch halvings)))

;; Not by a product, which may be too small for a flonum.
(define (opposite? p a b)
  (define-values (pa pb) (values (polynomial-value p a) (polynomial-value p b)))
  (if (fl< pa 0.0) (fl> pb 0.0) (and (fl> pa 0.0) (fl< pb 0.0))))

;; Is the extremum at x zero, as far as can be told, and p of one sign on both sides?
(define (touches? p x touch)
  (and (fl<= (flabs (polynomial-value p x)) touch) (not (opposite? p 0.0 1.0))))

;; ---------------------------------------------------------------------------
;; Polynomials

(define (polynomial-value p x)
  (let loop ([k (unsafe-fx- (flvector-length p) 1)] [sum 0.0])
    (if (unsafe-fx< k 0)
        (unboxed sum)
        (loop (unsafe-fx- k 1) (unsafe-fl+ (at p k) (unsafe-fl* x sum))))))

(define (derivative p)
  (define n (flvector-length p))
  (if (= n 1)
      (flvector 0.0)
      (for/flvector #:length (- n 1) ([k (in-range 1 n)]) (fl* (->fl k) (flvector-ref p k)))))

;; p(x/2) and p(x + 1)
(define (halved p)
  (for/flvector #:length (flvector-length p) ([c (in-flvector p)] [k (in-naturals)])
    (fl* c (flexpt 0.5 (->fl k)))))

(define (shifted p)
  (define q (flvector-copy p))
  (shift! q)
  q)

(define (shift! q)
  (define n (flvector-length q))
  (let outer ([i 0])
    (when (unsafe-fx< i (unsafe-fx- n 1))
      (let loop ([k (unsafe-fx- n 2)] [above (at q (unsafe-fx- n 1))])
        (when (unsafe-fx>= k i)
          (let ([sum (unsafe-fl+ (at q k) above)])
            (put! q k sum)
            (loop (unsafe-fx- k 1) sum))))
      (outer (unsafe-fx+ i 1)))))

;; (1 + x)ⁿ p(1/(1 + x)), of the first n + 1 coefficients of p, so many
(define (transformed p count)
  (define q (make-flvector count))
  (each (k 0 count) (put! q k (at p (unsafe-fx- (unsafe-fx- count 1) k))))
  (shift! q)
  q)

(define (sign-changes p)
  (define n (flvector-length p))
  (define q (transformed p n))
  (let loop ([k 0] [count 0] [sign 0.0])
    (if (unsafe-fx= k n)
        count
        (let ([c (at q k)])
          (cond [(unsafe-fl= c 0.0) (loop (unsafe-fx+ k 1) count sign)]
                [(unsafe-fl< (unsafe-fl* sign c) 0.0)
                 (loop (unsafe-fx+ k 1) (unsafe-fx+ count 1) (unsafe-fl- 0.0 sign))]
                [else (loop (unsafe-fx+ k 1) count (if (unsafe-fl< c 0.0) -1.0 1.0))])))))

;; The zero between a and b, where p has opposite signs, by Newton's steps, or halving where
;; these lead out or are slow.
(define (refined p a b)
  (define rising? (fl< (polynomial-value p a) (polynomial-value p b)))
  (define last (unsafe-fx- (flvector-length p) 1))
  (let loop ([a a] [b b] [x (fl* 0.5 (fl+ a b))] [count 0])
    (define-values (px slope)
      (let horner ([k (unsafe-fx- last 1)] [sum (at p last)] [slope 0.0])
        (if (unsafe-fx< k 0)
            (values (unboxed sum) (unboxed slope))
            (horner (unsafe-fx- k 1)
                    (unsafe-fl+ (at p k) (unsafe-fl* x sum))
                    (unsafe-fl+ sum (unsafe-fl* x slope))))))
    (define below? (if rising? (fl< px 0.0) (fl> px 0.0)))
    (define-values (low high) (if below? (values x b) (values a x)))
    (define newton (fl- x (fl/ px slope)))
    (define middle (fl* 0.5 (fl+ low high)))
    (cond [(or (fl= px 0.0) (= count 80)) x]
          [(fl<= (flabs (fl- newton x)) (fl* 4e-16 x)) (flmax a (flmin b newton))]
          [(or (fl= middle low) (fl= middle high)) middle]
          [(and (fl< low newton) (fl< newton high) (not (= 7 (remainder count 8))))
           (loop low high newton (+ count 1))]
          [else (loop low high middle (+ count 1))])))
