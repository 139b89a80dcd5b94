#lang racket/base
;; A quick verdict on zero, modulo primes.
;;
;; The graph is put on a tape and evaluated in GF(p), symbols and applications
;; of literal functions having random residues; equal functions of arguments
;; with equal residues are equal.  A function that vanishes has the residue 0; another
;; has it, by the theorem of Schwartz and Zippel, with a probability of
;; about its degree over p.
;;
;; Sines and exponentials are homomorphisms from sums to products, and stay so:
;; if q divides p - 1 and g has the order q in GF(p)*, then
;;
;;     exp u = g^(u mod q),  sinh u = (exp u - exp(-u))/2, ...
;;
;; where u is evaluated in GF(q), at residues of its own; and if r divides p + 1
;; and the point (c, s) has the order r on the circle c² + s² = 1 over GF(p),
;;
;;     cos u + i sin u = (c + i s)^(u mod r).
;;
;; So all laws for sums and rational multiples of arguments hold, and those are
;; compared as functions, not as they are written.  Functions within functions
;; take a *chain* of primes.  Since p ≡ 3 (mod 4), just one root of a square is a
;; square itself; it is the root, and √(uv) = √u √v.
;;
;; For rational operations, sines and exponentials a residue other than 0
;; therefore *proves* that e is not zero: exponentials are algebraically
;; independent where their exponents are linearly independent.  Roots have
;; signs of their own, and logarithms and the like are taken for unknown
;; functions; there a residue other than 0 only suggests.  So it does where there is π, some
;; residue here: that its sine is 0 is not seen.

(require racket/fixnum
         "residues.rkt"
         "../expression/flat-graph.rkt" "../expression/operation.rkt" "../expression/pi.rkt")

(provide fingerprint tape-fingerprint fingerprint-points
         tape-classes vanishes-with-cuts?)

;; Level 0 is where the value is sought.  Arguments of exponentials at level k
;; are evaluated at level 2k + 1, angles at level 2k + 2; at the last levels
;; functions are unknown ones.
(define chains
  '#(#(1073612039 536806019 8946767 38343287 8946767 4473383 186391)
     #(1072962959 536481479 4470679 1213759 4470679 248371 111767)
     #(1044152519 522076259 8701271 23730739 8701271 870127 120851)))
(define level-count 7)

;; At how many points, modulo a prime each, 'zero was found.
(define fingerprint-points (vector-length chains))

;; Points where something is divided by 0, or has no root, are replaced so often.
(define attempts 32)

;; -> 'zero : e is 0 at a point modulo each prime, 'nonzero : e is not zero,
;;    'nonzero? : very probably it is not, 'unknown : no point was found.
(define (fingerprint e) (tape-fingerprint (expression->plain-tape e)))

(define (tape-fingerprint t)
  (define-values (plan sure?) (make-plan t))
  (let loop ([chain 0])
    (define value (and plan (< chain fingerprint-points) (value-at-some-point plan chain)))
    (cond [(or (not plan) (and (not value) (< chain fingerprint-points))) 'unknown]
          [(not value) 'zero]
          [(eqv? value 0) (loop (+ chain 1))]
          [else (if sure? 'nonzero 'nonzero?)])))

;; ---------------------------------------------------------------------------
;; Parts that are equal

;; A vector by place: #f, or the first place on the tape at which the item has the
;; same residues modulo two primes.
(define (tape-classes t)
  (define-values (plan sure?) (make-plan t))
  (define n (vector-length (tape-items t)))
  (define classes (make-vector n #f))
  (define sites (and plan (for/list ([chain 2]) (site-at-some-point plan chain))))
  (when (and sites (andmap values sites))
    (define first-places (make-hash))
    (define-values (a b) (apply values (map site-values sites)))
    (for ([k (in-range n)] #:when (fxbit-set? (fxvector-ref (plan-levels plan) k) 0))
      (define key (+ (* (fxvector-ref a k) 1073741824) (fxvector-ref b k)))
      (vector-set! classes k (hash-ref! first-places key k))))
  classes)

;; Does the whole still vanish, at one point, if items are replaced by others or by
;; symbols of their own?
(define (vanishes-with-cuts? t cuts)
  (define-values (plan sure?) (make-plan t cuts))
  (eqv? 0 (value-at-some-point plan 0)))

;; ---------------------------------------------------------------------------
;; Plans: at which levels which items are needed

;; levels : fxvector of sets of levels, as bits; heads : numbers of literal heads
;; cuts : #f, or vector by place: #f, or the place of a node or leaf whose value
;; is taken; if that is a node, as if it were a symbol
(struct plan (tape levels heads cuts) #:authentic)

;; -> a plan, or #f if there are numbers that have no residue; is a residue
;; other than 0 a proof?
(define (make-plan t [cuts #f])
  (define items (tape-items t))
  (define heads (tape-heads t))
  (define n (vector-length items))
  (define levels (make-fxvector n 0))
  (fxvector-set! levels (- n 1) 1)
  (define sure?
    (for/fold ([sure? #t]) ([k (in-range (- n 1) -1 -1)])
      (define head (vector-ref heads k))
      (define cut (and cuts (vector-ref cuts k)))
      (cond [cut
             (fxvector-set! levels cut
                            (fxior (fxvector-ref levels cut) (fxvector-ref levels k)))
             sure?]
            [head
             (and (spread-levels! levels k head (vector-ref (tape-operands t) k) items) sure?)]
            [else (and sure? (not (pi-symbol? (vector-ref items k))))])))
  (values (and (for/and ([e (in-vector items)]) (or (not (number? e)) (rational? e)))
               (plan t levels (number-heads heads) cuts))
          sure?))

;; Marks the operands of item k at the levels it needs; -> is it sure?
(define (spread-levels! levels k op operands items)
  (define here (fxvector-ref levels k))
  (define (exponent) (vector-ref items (cadr operands)))
  (define (mark! j there) (fxvector-set! levels j (fxior there (fxvector-ref levels j))))
  (define (mark-all! there) (for ([j (in-list operands)]) (mark! j there)))
  (cond [(or (literal-head? op) (memq op rational)) (mark-all! here) #t]
        [(memq op exponential) (mark-all! (exponent-levels here)) (deep-enough? here)]
        [(memq op circular-functions) (mark-all! (angle-levels here)) (deep-enough? here)]
        [(and (eq? op op:expt) (not (number? (exponent))))
         (mark! (car operands) here)
         (mark! (cadr operands) (exponent-levels here))
         #f]
        [else (mark-all! here) (and (eq? op op:expt) (integer? (exponent)))]))

(define rational (list op:+ op:* op:- op:/ op:up op:down))

;; Bits 0, 1, 2 to bits 1, 3, 5 or 2, 4, 6; the last levels have none below.
(define last-levels #b1111000)
(define (deep-enough? bits) (fx= 0 (fxand bits last-levels)))
(define (exponent-levels bits) (levels-below bits 1))
(define (angle-levels bits) (levels-below bits 2))
(define (levels-below bits k)
  (for/fold ([below (fxand bits last-levels)]) ([level (in-range 3)])
    (fxior below (fxlshift (fxand bits (fxlshift 1 level)) (fx+ level k)))))

;; Equal literal heads have equal numbers.
(define (number-heads heads)
  (define table (make-hash))
  (define numbers (make-hasheq))
  (for ([head (in-vector heads)] #:when (literal-head? head))
    (unless (hash-ref numbers head #f)
      (define key (cons (literal-head-name head) (literal-head-index head)))
      (hash-set! numbers head (hash-ref! table key (lambda () (+ 100 (hash-count table)))))))
  numbers)

;; ---------------------------------------------------------------------------
;; Evaluation

;; The residue of the whole, or #f.
(define (value-at-some-point plan chain)
  (define s (site-at-some-point plan chain))
  (and s (fxvector-ref (site-values s) (- (fxvector-length (site-values s)) 1))))

;; Level 0 at a point where all has a value, or #f.
(define (site-at-some-point plan chain)
  (for/or ([seed (in-range attempts)])
    (site-at plan (vector-ref chains chain) (+ seed (* chain attempts)))))

(define (site-at plan primes seed)
  (define levels (plan-levels plan))
  (define used (for/fold ([bits 0]) ([b (in-fxvector levels)]) (fxior bits b)))
  (define n (fxvector-length levels))
  (define sites (make-vector level-count #f))
  (let loop ([level (- level-count 1)])
    (cond [(< level 0) (vector-ref sites 0)]
          [(not (fxbit-set? used level)) (loop (- level 1))]
          [else
           (vector-set! sites level (make-level-site primes level seed sites n))
           (and (fill-site! plan level (vector-ref sites level))
                (loop (- level 1)))])))

(define (fxbit-set? bits k) (fx= 1 (fxand 1 (fxrshift bits k))))

(define (make-level-site primes level seed sites n)
  (define (below k)
    (define s (and (< k level-count) (vector-ref sites k)))
    (values (and s (vector-ref primes k)) (and s (site-values s))))
  (define-values (q exponents) (below (+ (* 2 level) 1)))
  (define-values (r angles) (below (+ (* 2 level) 2)))
  (make-site (vector-ref primes level) (mix (mix 1 seed) level) (even? seed)
             n q exponents r angles))

;; -> did all go well?
(define (fill-site! plan level s)
  (define items (tape-items (plan-tape plan)))
  (define heads (tape-heads (plan-tape plan)))
  (define operands (tape-operands (plan-tape plan)))
  (define levels (plan-levels plan))
  (define residues (site-values s))
  (define n (vector-length items))
  (let loop ([k 0])
    (cond [(fx= k n) #t]
          [(not (fxbit-set? (fxvector-ref levels k) level)) (loop (fx+ k 1))]
          [else
           (define x (item-residue plan s k (vector-ref heads k) items (vector-ref operands k)))
           (and x
                (begin (fxvector-set! residues k x)
                       (loop (fx+ k 1))))])))

(define (item-residue plan s k head items operands)
  (define cuts (plan-cuts plan))
  (define cut (and cuts (vector-ref cuts k)))
  (cond [cut (if (fx= cut k) (site-symbol s k) (fxvector-ref (site-values s) cut))]
        [(operation? head) (site-operation s head items operands)]
        [head (site-application s (hash-ref (plan-heads plan) head) operands)]
        [else
         (define leaf (vector-ref items k))
         (cond [(pi-multiple leaf) => (lambda (m) (site-pi s m))]
               [(symbol? leaf) (site-symbol s k)]
               [else (site-number s leaf)])]))
