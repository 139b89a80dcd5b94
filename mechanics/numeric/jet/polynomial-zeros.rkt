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
         racket/unsafe/ops)

(provide polynomial-zeros (struct-out zero))

;; at : in (0, 1]; kind : 'rising, 'falling, or 'touching if p keeps its sign
(struct zero (at kind) #:transparent)

;; p : flvector of coefficients, from order 0 on; touch : what is not more than that at an
;; extremum counts as zero -> zeros, in their order.  A zero at 0 itself is none.
(define (polynomial-zeros p touch)
  (define q (without-zero-at-0 p))
  (cond [(< (flvector-length q) 2) '()]
        [else
         (define last (value q 1.0))
         (define inside (search q 0.0 1.0 touch most-halvings))
         (if (fl= last 0.0)
             (append inside (list (zero 1.0 (direction (value (derivative q) 1.0)))))
             inside)]))

(define (without-zero-at-0 p)
  (define n (flvector-length p))
  (define first (or (for/first ([c (in-flvector p)] [k (in-naturals)] #:unless (fl= c 0.0)) k) n))
  (if (= first 0) p (flvector-copy p first n)))

(define most-halvings 40)

(define (direction slope)
  (cond [(fl> slope 0.0) 'rising] [(fl< slope 0.0) 'falling] [else 'touching]))

;; ---------------------------------------------------------------------------

;; The zeros of p in (0, 1), which is the part of the whole from `low` on of that width.
(define (search p low width touch halvings)
  (define (place x) (fl+ low (fl* width x)))
  (define (crossing a b)
    (list (zero (place (refined p a b)) (direction (fl- (value p b) (value p a))))))
  (define changes (sign-changes p))
  (cond
    [(= changes 0) '()]
    [(= changes 1) (crossing 0.0 1.0)]
    [else
     (define slope (derivative p))
     (define turns (sign-changes slope))
     (cond
       [(or (= turns 0) (= halvings 0)) (if (opposite? p 0.0 1.0) (crossing 0.0 1.0) '())]
       [(= turns 1)
        (define turn (refined slope 0.0 1.0))
        (if (touches? p turn touch)
            (list (zero (place turn) 'touching))
            (append (if (opposite? p 0.0 turn) (crossing 0.0 turn) '())
                    (if (opposite? p turn 1.0) (crossing turn 1.0) '())))]
       [else (search-halves p low width touch (- halvings 1))])]))

(define (search-halves p low width touch halvings)
  (define left (halved p))
  (define right (shifted left))
  (define half (fl* 0.5 width))
  (define middle
    (if (fl= (flvector-ref right 0) 0.0)
        (list (zero (fl+ low half) (direction (value (derivative right) 0.0))))
        '()))
  (append (search left low half touch halvings)
          middle
          (search (without-zero-at-0 right) (fl+ low half) half touch halvings)))

;; Not by a product, which may be too small for a flonum.
(define (opposite? p a b)
  (define-values (pa pb) (values (value p a) (value p b)))
  (if (fl< pa 0.0) (fl> pb 0.0) (and (fl> pa 0.0) (fl< pb 0.0))))

;; Is the extremum at x zero, as far as can be told, and p of one sign on both sides?
(define (touches? p x touch)
  (and (fl<= (flabs (value p x)) touch) (not (opposite? p 0.0 1.0))))

;; ---------------------------------------------------------------------------
;; Polynomials

(define (value p x)
  (for/fold ([sum 0.0]) ([k (in-range (- (flvector-length p) 1) -1 -1)])
    (fl+ (flvector-ref p k) (fl* x sum))))

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
  (define n (flvector-length q))
  (for ([i (in-range (- n 1))])
    (let loop ([k (unsafe-fx- n 2)] [above (unsafe-flvector-ref q (unsafe-fx- n 1))])
      (when (unsafe-fx>= k i)
        (let ([sum (unsafe-fl+ (unsafe-flvector-ref q k) above)])
          (unsafe-flvector-set! q k sum)
          (loop (unsafe-fx- k 1) sum)))))
  q)

;; Of (1 + x)ⁿ p(1/(1 + x)).
(define (sign-changes p)
  (define n (flvector-length p))
  (define q
    (shifted (for/flvector #:length n ([k (in-range (- n 1) -1 -1)]) (flvector-ref p k))))
  (for/fold ([count 0] [sign 0.0] #:result count) ([c (in-flvector q)] #:unless (fl= c 0.0))
    (values (if (fl< (fl* sign c) 0.0) (+ count 1) count) (flsgn c))))

(define (flsgn x) (if (fl< x 0.0) -1.0 1.0))

;; The zero between a and b, where p has opposite signs, by Newton's steps, or halving where
;; these lead out or are slow.
(define (refined p a b)
  (define slope (derivative p))
  (define rising? (fl< (value p a) (value p b)))
  (let loop ([a a] [b b] [x (fl* 0.5 (fl+ a b))] [count 0])
    (define px (value p x))
    (define below? (if rising? (fl< px 0.0) (fl> px 0.0)))
    (define-values (low high) (if below? (values x b) (values a x)))
    (define newton (fl- x (fl/ px (value slope x))))
    (define middle (fl* 0.5 (fl+ low high)))
    (cond [(or (fl= px 0.0) (= count 80) (fl<= (flabs (fl- newton x)) (fl* 1e-16 x))) x]
          [(or (fl= middle low) (fl= middle high)) middle]
          [(and (fl< low newton) (fl< newton high) (not (= 7 (remainder count 8))))
           (loop low high newton (+ count 1))]
          [else (loop low high middle (+ count 1))])))
