#lang racket/base
;; Contracting sums of products of sines and cosines.
;;
;; The addition formulas, read backwards, merge two terms into one:
;;
;;     X cos a cos b + X sin a sin b = X cos(a - b)      (with -: cos(a + b))
;;     X sin a cos b + X cos a sin b = X sin(a + b)      (with -: sin(a - b))
;;
;; and 2X cos²a - X = X cos 2a.  For those angles 2a that the expression had also
;; 2X sin a cos a = X sin 2a, though that makes no fewer terms.  Merged terms
;; may merge again with a third angle, so passes are made until one finds nothing.
;;
;; For this a term's monomial is packed into an integer, its key: in low bits
;; the exponents of sines and cosines, above them the number of all the rest.  So
;; a term and its partner are one subtraction and one lookup apart.

(require racket/list
         (only-in "term.rkt" in-tails)
         "../field/field.rkt"
         "../kernel/kernel.rkt"
         "../polynomial/polynomial.rkt" "../polynomial/ring.rkt" "../polynomial/term-list.rkt")

(provide contract-angles occurring-circles)

;; A circle whose functions occur in keys: their fields start at these bits and
;; these integers add one to their exponents.
(struct turn (circle sine-bit cosine-bit sine cosine) #:authentic)

;; A stage of the work.  terms : ((key . coefficient) ...)
(struct stage (terms turns) #:authentic)

;; poly : as of the ring, sines perhaps squared.
;; combine : circle circle sign -> (circle . ±1), the circle of the sum (sign 1)
;; or the difference of two angles, or of its opposite.
;; double? : circle -> is twice its angle welcome?
;; -> summands (field/field.rkt)
(define (contract-angles F p combine double?)
  (define circles (occurring-circles F p 1))
  (if (or (ormap double? circles)
          (and (pair? circles) (or (pair? (cdr circles)) (squared? F p (car circles)))))
      (contract F p circles combine double?)
      (summands F p)))

(define (contract F p circles combine double?)
  (define width (+ 1 (integer-length (ring-max-degree (field-ring F)))))
  (define turns (make-turns circles width))
  (define-values (terms rests) (encode F p turns width))
  (let loop ([s (stage terms turns)])
    (define merges (find-merges s width combine double?))
    (if (null? merges)
        (decode s rests width)
        (loop (apply-merges s merges width)))))

(define (squared? F p o)
  (define R (field-ring F))
  (or (> (poly-degree R p (kernel-index (circle-cosine o))) 1)
      (> (poly-degree R p (kernel-index (circle-sine o))) 1)))

;; The circles of this sign whose sines or cosines occur in p.
(define (occurring-circles F p sign)
  (define occurring (poly-variables (field-ring F) p))
  (define (occurs? k) (memv (kernel-index k) occurring))
  (for*/list ([k (in-vector (field-kernels F))]
              [o (in-value (kernel-relation k))]
              #:when (and (circle? o) (eqv? sign (circle-sign o))
                          (or (occurs? k) (occurs? (circle-cosine o)))))
    o))

(define (make-turns circles width)
  (for/list ([o (in-list circles)] [i (in-naturals)])
    (define bit (* 2 width i))
    (turn o bit (+ bit width) (arithmetic-shift 1 bit) (arithmetic-shift 1 (+ bit width)))))

;; ---------------------------------------------------------------------------
;; Keys

;; -> terms and the rests of their monomials, a vector by number.
(define (encode F p turns width)
  (define R (field-ring F))
  (define places (make-hasheqv))
  (for ([t (in-list turns)])
    (hash-set! places (kernel-index (circle-sine (turn-circle t))) (turn-sine t))
    (hash-set! places (kernel-index (circle-cosine (turn-circle t))) (turn-cosine t)))
  (define circular (hash-keys places))
  (define rest-of
    (monomial-part R (for/list ([i (in-range (ring-size R))] #:unless (memv i circular)) i)))
  (define numbers (make-monomial-hash R))
  (define shift (* 2 width (length turns)))
  (define terms
    (for/list ([t (in-list p)])
      (define m (term-monomial t))
      (define low
        (monomial-fold R m
                       (lambda (i e key) (+ key (* e (hash-ref places i 0))))
                       0))
      (define number (hash-ref! numbers (rest-of m) (lambda () (hash-count numbers))))
      (cons (+ (arithmetic-shift number shift) low) (term-coefficient t))))
  (define rests (make-vector (hash-count numbers)))
  (for ([(m number) (in-hash numbers)])
    (vector-set! rests number (kernel-powers F (monomial-factors R m))))
  (values terms rests))

(define (decode s rests width)
  (define turns (stage-turns s))
  (define shift (* 2 width (length turns)))
  (for/list ([t (in-list (stage-terms s))])
    (cons (cdr t)
          (append (turns->powers (factors (car t) turns width))
                  (vector-ref rests (arithmetic-shift (car t) (- shift)))))))

(define (turns->powers factors)
  (for*/list ([f (in-list factors)]
              [power (in-list (list (cons (circle-sine (turn-circle (car f))) (cadr f))
                                    (cons (circle-cosine (turn-circle (car f))) (cddr f))))]
              #:unless (eqv? 0 (cdr power)))
    power))

;; ---------------------------------------------------------------------------
;; Finding pairs

;; A merge of two terms: rest · coefficient · function of the circle.
(struct merge (keys rest coefficient function circle) #:authentic)

(define (find-merges s width combine double?)
  (define terms (stage-terms s))
  (define turns (stage-turns s))
  (define table (make-hasheqv terms))
  (define (take! m)
    (for ([k (in-list (merge-keys m))]) (hash-remove! table k))
    m)
  (for*/fold ([found '()] #:result (reverse found)) ([t (in-list terms)])
    (define key (car t))
    (define m
      (and (hash-has-key? table key)
           (let ([factors (factors key turns width)])
             (or (find-pair key (cdr t) factors table combine)
                 (find-double key (cdr t) factors table combine double?)))))
    (if m (cons (take! m) found) found)))

;; The turns that occur in a key, as (turn sine-exponent . cosine-exponent).
(define (factors key turns width)
  (define field (- (arithmetic-shift 1 width) 1))
  (for*/list ([t (in-list turns)]
              [s (in-value (bitwise-and field (arithmetic-shift key (- (turn-sine-bit t)))))]
              [c (in-value (bitwise-and field (arithmetic-shift key (- (turn-cosine-bit t)))))]
              #:unless (and (eqv? s 0) (eqv? c 0)))
    (cons t (cons s c))))

(define (find-pair key x factors table combine)
  (for*/or ([rest (in-list (in-tails factors))] [b (in-list (cdr rest))])
    (define a (car rest))
    (or (and (cosine? a) (cosine? b)
             (pair-of key x (car a) (car b) 'cosine table combine))
        (and (sine? a) (cosine? b)
             (pair-of key x (car a) (car b) 'sine table combine)))))

(define (sine? f) (not (eqv? 0 (cadr f))))
(define (cosine? f) (not (eqv? 0 (cddr f))))

;; The partner of a term in cos a cos b, or in sin a cos b, and their merge.
(define (pair-of key x a b function table combine)
  (define cosine? (eq? function 'cosine))
  (define rest (- key (if cosine? (turn-cosine a) (turn-sine a)) (turn-cosine b)))
  (define partner (+ rest (if cosine? (turn-sine a) (turn-cosine a)) (turn-sine b)))
  (define y (hash-ref table partner #f))
  (define alike (and y (= (abs x) (abs y)) (if (= x y) 1 -1)))
  (and alike
       (let ([sum (combine (turn-circle a) (turn-circle b) (if cosine? (- alike) alike))])
         (merge (list key partner) rest
                (if cosine? x (* x (cdr sum)))
                function (car sum)))))

;; Terms with the square of a function and without, or with sin a cos a if twice
;; the angle is welcome.
(define (find-double key x factors table combine double?)
  (for/or ([f (in-list factors)])
    (define t (car f))
    (or (and (> (cddr f) 1)
             (square-of key x (turn-cosine t) t table combine))
        (and (> (cadr f) 1)
             (square-of key x (turn-sine t) t table combine))
        (and (sine? f) (cosine? f)
             (double? (turn-circle t))
             (let ([sum (combine (turn-circle t) (turn-circle t) 1)])
               (merge (list key) (- key (turn-sine t) (turn-cosine t))
                      (* 1/2 x (cdr sum)) 'sine (car sum)))))))

(define (square-of key x unit t table combine)
  (define rest (- key (* 2 unit)))
  (define y (hash-ref table rest #f))
  (and y
       (= y (* -1/2 x))
       (let ([sum (combine (turn-circle t) (turn-circle t) 1)])
         (merge (list key rest) rest
                (if (eqv? unit (turn-cosine t)) (- y) y)
                'cosine (car sum)))))

;; ---------------------------------------------------------------------------
;; Making the merged terms

(define (apply-merges s merges width)
  (define known (map turn-circle (stage-turns s)))
  (define circles (remq* known (remove-duplicates (map merge-circle merges) eq?)))
  (define shift (* 2 width (length circles)))
  (define turns
    (append (make-turns circles width)
            (for/list ([t (in-list (stage-turns s))]) (raise-turn t shift))))
  (stage (merged-terms s merges turns shift) turns))

(define (raise-turn t shift)
  (turn (turn-circle t)
        (+ shift (turn-sine-bit t)) (+ shift (turn-cosine-bit t))
        (arithmetic-shift (turn-sine t) shift) (arithmetic-shift (turn-cosine t) shift)))

(define (merged-terms s merges turns shift)
  (define gone (make-hasheqv))
  (for* ([m (in-list merges)] [k (in-list (merge-keys m))]) (hash-set! gone k #t))
  (define sums (make-hasheqv))
  (define (add! key x) (hash-update! sums key (lambda (y) (+ x y)) 0))
  (for ([t (in-list (stage-terms s))] #:unless (hash-ref gone (car t) #f))
    (add! (arithmetic-shift (car t) shift) (cdr t)))
  (for ([m (in-list merges)])
    (define t (findf (lambda (t) (eq? (turn-circle t) (merge-circle m))) turns))
    (add! (+ (arithmetic-shift (merge-rest m) shift)
             (if (eq? (merge-function m) 'sine) (turn-sine t) (turn-cosine t)))
          (merge-coefficient m)))
  (sort (for/list ([(k x) (in-hash sums)] #:unless (eqv? x 0)) (cons k x)) > #:key car))
