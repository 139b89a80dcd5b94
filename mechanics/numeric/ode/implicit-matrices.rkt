#lang racket/base
;; The matrices of an implicit method's equations, and their solutions: c − J for a real
;; number c, and for a complex one a + ib, of which real and imaginary parts are unknowns
;; side by side.
;;
;; In mechanics half of the equations are q' = v, and one is that of the clock: rows of J that
;; hold one entry or none.  The unknowns xᵢ of such rows E follow from those of the others, K,
;;
;;     xᵢ = (bᵢ + Jᵢₗ xₗ) / c,
;;
;; and a system of K alone is left, with the matrix c − J_KK − P/c, P = J_KE J_EK, which
;; for half the unknowns takes an eighth of the time.  Where c is much less than Jᵢₗ, in steps
;; that are very long, that would lose digits, and row i stays in K.
;;
;; All are flvectors, row by row; J, of size n, holds its columns one after the other.

(require racket/fixnum
         racket/flonum
         racket/unsafe/ops
         "../record-fields.rkt" "../unboxed-loop.rkt"
         "../linear-algebra/factored-system.rkt")

(provide make-matrices matrices-J
         factor-matrices! solve-real! solve-complex!)

;; real, complex : factored once factor-matrices! has been called; product : P
;; kept     : the first `size` of them are the indices of K
;; targets  : of each index in E the l of its entry, or itself if it has none; of others -1
;; places   : of each index in K which of them it is
;; side     : room for right-hand sides
(struct matrices (n J real complex product real-exchanges complex-exchanges
                    kept targets places side
                    [size #:mutable])
  #:authentic)

(define (make-matrices n)
  (define 2n (* 2 n))
  (matrices n (make-flvector (* n n))
            (make-flvector (* n n)) (make-flvector (* 2n 2n)) (make-flvector (* n n))
            (make-fxvector n) (make-fxvector 2n)
            (make-fxvector n) (make-fxvector n) (make-fxvector n) (make-flvector 2n)
            n))

(define-syntax-rule (index v i) (unsafe-fxvector-ref v i))

;; -> have both an inverse?
(define (factor-matrices! m c a b)
  (define-fields matrices m real complex real-exchanges complex-exchanges)
  (arrange! m c)
  (multiply-parts! m)
  (define size (matrices-size m))
  (fill-real! m c)
  (fill-complex! m a b)
  (and (factor! real size real-exchanges)
       (factor! complex (* 2 size) complex-exchanges)))

;; ---------------------------------------------------------------------------
;; Which unknowns follow from others

;; c may be that much less than an entry.
(define least-pivot 1e-3)

(define (arrange! m c)
  (define-fields matrices m n J kept targets places)
  (for ([i (in-range n)]) (fxvector-set! targets i -1))
  (for ([i (in-range n)])
    (define l (only-entry J n i))
    (when (and l
               (fl<= (fl* least-pivot (flabs (flvector-ref J (+ i (* l n))))) (flabs c))
               (fx= -1 (fxvector-ref targets l))
               (not (target-of-another? targets i)))
      (fxvector-set! targets i l)))
  (set-matrices-size!
   m
   (for/fold ([size 0]) ([i (in-range n)] #:when (fx= -1 (fxvector-ref targets i)))
     (fxvector-set! kept size i)
     (fxvector-set! places i size)
     (+ size 1))))

;; The column of the only entry of row i, i itself if there is none; #f if there are more, or
;; it is on the diagonal.
(define (only-entry J n i)
  (let loop ([j 0] [found #f])
    (cond [(fx= j n) (or found i)]
          [(fl= 0.0 (at J (fx+ i (fx* j n)))) (loop (fx+ j 1) found)]
          [(or found (fx= i j)) #f]
          [else (loop (fx+ j 1) j)])))

(define (target-of-another? targets i)
  (for/or ([l (in-fxvector targets)] [k (in-naturals)]) (and (fx= l i) (not (fx= k i)))))

;; P
(define (multiply-parts! m)
  (define-fields matrices m n J product kept targets places size)
  (for ([k (in-range (* size size))]) (flvector-set! product k 0.0))
  (for ([i (in-range n)])
    (define l (fxvector-ref targets i))
    (unless (or (fx= l -1) (fx= l i))
      (define entry (flvector-ref J (+ i (* l n))))
      (define column (fxvector-ref places l))
      (for ([r (in-range size)])
        (define x (fl* entry (flvector-ref J (+ (fxvector-ref kept r) (* i n)))))
        (define place (+ (* r size) column))
        (flvector-set! product place (fl+ x (flvector-ref product place)))))))

;; ---------------------------------------------------------------------------
;; The matrices

(define (fill-real! m c)
  (define-fields matrices m n J real product kept size)
  (define 1/c (fl/ 1.0 c))
  (for* ([r (in-range size)] [s (in-range size)])
    (define k (+ (* r size) s))
    (define x (at J (fx+ (index kept r) (fx* n (index kept s)))))
    (define y (fl- (fl- 0.0 x) (fl* 1/c (at product k))))
    (flvector-set! real k (if (fx= r s) (fl+ c y) y))))

;; Of real part R = a − J − Re(1/c) P and imaginary part I = b − Im(1/c) P, the matrix
;;
;;     R  −I
;;     I   R
(define (fill-complex! m a b)
  (define-fields matrices m n J complex product kept size)
  (define width (* 2 size))
  (define square (fl+ (fl* a a) (fl* b b)))
  (define-values (re im) (values (fl/ a square) (fl/ (fl- 0.0 b) square)))
  (for* ([r (in-range size)] [s (in-range size)])
    (define p (at product (fx+ (fx* r size) s)))
    (define x (fl- (fl- 0.0 (at J (fx+ (index kept r) (fx* n (index kept s))))) (fl* re p)))
    (define y (fl- 0.0 (fl* im p)))
    (define-values (R I) (if (fx= r s) (values (fl+ a x) (fl+ b y)) (values x y)))
    (define top (+ (* r width) s))
    (define below (+ (* (+ r size) width) s))
    (flvector-set! complex top R)
    (flvector-set! complex (+ top size) (fl- 0.0 I))
    (flvector-set! complex below I)
    (flvector-set! complex (+ below size) R)))

;; ---------------------------------------------------------------------------
;; Solutions

;; c, a, b : those for which the matrices were factored

;; The right-hand side v becomes the solution.
(define (solve-real! m c v)
  (define-fields matrices m n J real real-exchanges targets side size)
  (each-eliminated (i l) targets n (flvector-set! v i (fl/ (at v i) c)))
  (gather! m v 0)
  (solve-factored! real size real-exchanges side)
  (scatter! m v 0)
  (each-eliminated (i l) targets n
    (unless (fx= i l)
      (flvector-set! v i (fl+ (at v i) (fl/ (fl* (at J (fx+ i (fx* l n))) (at v l)) c))))))

;; So do its real and imaginary parts v and w.
(define (solve-complex! m a b v w)
  (define-fields matrices m n J complex complex-exchanges targets side size)
  (define square (fl+ (fl* a a) (fl* b b)))
  (define-syntax-rule (with-quotient (x y p q) body ...)      ; p + iq = (x + iy)/(a + ib)
    (let ([p (fl/ (fl+ (fl* a x) (fl* b y)) square)]
          [q (fl/ (fl- (fl* a y) (fl* b x)) square)])
      body ...))
  (each-eliminated (i l) targets n
    (with-quotient ((at v i) (at w i) p q)
      (flvector-set! v i p)
      (flvector-set! w i q)))
  (gather! m v 0)
  (gather! m w size)
  (solve-factored! complex (* 2 size) complex-exchanges side)
  (scatter! m v 0)
  (scatter! m w size)
  (each-eliminated (i l) targets n
    (unless (fx= i l)
      (let ([entry (at J (fx+ i (fx* l n)))])
        (with-quotient ((fl* entry (at v l)) (fl* entry (at w l)) p q)
          (flvector-set! v i (fl+ (at v i) p))
          (flvector-set! w i (fl+ (at w i) q)))))))

(define-syntax-rule (each-eliminated (i l) targets n body ...)
  (let loop ([i 0])
    (when (fx< i n)
      (let ([l (index targets i)])
        (unless (fx= l -1) body ...))
      (loop (fx+ i 1)))))

;; The right-hand side of K's equations, v_K + J_KE v_E with v_E divided, from `start` on.
(define (gather! m v start)
  (define-fields matrices m n J kept targets side size)
  (for ([r (in-range size)]) (flvector-set! side (+ start r) (flvector-ref v (index kept r))))
  (each-eliminated (i l) targets n
    (let ([x (at v i)])
      (for ([r (in-range size)])
        (define place (fx+ start r))
        (flvector-set! side place
                       (fl+ (at side place) (fl* x (at J (fx+ (index kept r) (fx* i n))))))))))

(define (scatter! m v start)
  (define-fields matrices m kept side size)
  (for ([r (in-range size)]) (flvector-set! v (index kept r) (at side (fx+ start r)))))
