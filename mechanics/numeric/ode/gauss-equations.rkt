#lang racket/base
;; The equations of a Gauss–Legendre step (gauss-legendre.rkt), solved but for rounding:
;;
;;     kᵢ = f(y + h Σⱼ aᵢⱼ kⱼ).
;;
;; Repetition, from the slopes of the step before, takes nothing but evaluations of f, and
;; converges where h times the derivatives J of f is small.  Where it does not, or slowly, the
;; system is stiff for this step, and stays so: from then on Newton's method solves
;;
;;     Δkᵢ − h Σⱼ aᵢⱼ Jⱼ Δkⱼ = f(y + h Σⱼ aᵢⱼ kⱼ) − kᵢ,
;;
;; with one J of an earlier state for all Jⱼ while that serves, so that one factored matrix does
;; for many steps.  Where the stiff part turns, as a spring does, that fails even with the J at y;
;; then each Jⱼ is that at its own place, in every iteration.  All of them end where changes are
;; rounding only; none decides the solution.

(require racket/fixnum
         racket/flonum
         "rates-with-jacobian.rkt" "vector-formulas.rkt"
         (only-in "../constants.rkt" rounding) "../record-fields.rkt" "../flvector.rkt"
         "../linear-algebra/factored-system.rkt")

(provide make-equations solve-equations! add-slopes!)

;; y      : the present state; A : rows of coefficients; ks : the slopes, as they are found
;; newton : the state of Newton's method, or #f while repetition does
(struct equations (f! n y A ks w new change [newton #:mutable]) #:authentic)

;; J        : columns, one after the other; matrix : of all slopes side by side, factored
;; residual : of the equations, then the changes of the slopes
;; step     : the length for which the matrix was made, or #f if J is to be taken anew
;; turning? : has a J at y failed?
(struct newton (jacobian! J matrix exchanges residual [step #:mutable] [turning? #:mutable])
  #:authentic)

(define (make-equations f! y A)
  (define n (flvector-length y))
  (define-vectors n w new change)
  (define ks (for/list ([_ (in-list A)]) (make-flvector n)))
  (for ([k (in-list ks)]) (f! y k))
  (equations f! n y A ks w new change #f))

;; -> were they solved for a step of length h?
(define (solve-equations! q h)
  (or (and (not (equations-newton q)) (repeat! q h))
      (begin
        (unless (equations-newton q) (begin-newton! q))
        (solve-by-newton! q h))))

;; out = y + h (a₁ k₁ + a₂ k₂ + ...)
(define (add-slopes! q out h coefficients)
  (define-fields equations q n y ks)
  (flvector-copy! out y)
  (for ([a (in-list coefficients)] [k (in-list ks)])
    (combine! n out out (fl* h a) [1.0 k])))

;; ---------------------------------------------------------------------------
;; Repetition

(define most-repetitions 40)

;; Below this a change that does not get less is rounding, which may go on for ever.
(define beyond-rounding 1e-12)

(define (repeat! q h)
  (define-fields equations q f! n y A ks w new change)
  ;; -> the greatest change of a slope, relative to y
  (define (once!)
    (for/fold ([most 0.0]) ([row (in-list A)] [k (in-list ks)])
      (add-slopes! q w h row)
      (f! w new)
      (weighted-sum! n change [h new] [(fl- 0.0 h) k])
      (flvector-copy! k new)
      (flmax most (root-mean-square change y y n))))
  (define (no-less? size last) (and (fl< size beyond-rounding) (fl>= size last)))
  (and (steps-to-converge once! most-repetitions no-less?) #t))

;; (step!) -> the size of its changes; (only-rounding? size last) : may it be no more than rounding?
;; -> how many steps it took until changes were, or #f
(define (steps-to-converge step! most only-rounding?)
  (let loop ([count 1] [last +inf.0])
    (define size (step!))
    (cond [(or (fl<= size rounding) (only-rounding? size last)) count]
          [(or (= count most) (diverges? count size last)) #f]
          [else (loop (+ count 1) size)])))

;; NaN counts as diverging.
(define (diverges? count size last)
  (not (fl< size (if (<= count 3) +inf.0 last))))

;; ---------------------------------------------------------------------------
;; Newton's method

(define most-iterations 20)

;; The rates of a stiff system are wrong by rounding that its J makes larger.
(define beyond-rates 1e-9)

;; Newton's method would make it much less.
(define (only-rounding? size last)
  (or (and (fl< size beyond-rounding) (fl>= size (fl* 0.5 last)))
      (and (fl< size beyond-rates) (fl>= size last))))

;; More steps than these ask for new derivatives.
(define fast 7)

(define (begin-newton! q)
  (define-fields equations q f! n A)
  (define all (* n (length A)))
  (set-equations-newton! q (newton (jacobian-of f! n) (make-flvector (* n n))
                                   (make-flvector (* all all)) (make-fxvector all)
                                   (make-flvector all) #f #f))
  (restart! q))

;; Repetition may have led anywhere.
(define (restart! q)
  (define-fields equations q f! n y ks)
  (f! y (car ks))
  (for ([k (in-list (cdr ks))]) (flvector-copy! k (car ks))))

(define (solve-by-newton! q h)
  (define m (equations-newton q))
  (or (and (eqv? (newton-step m) h) (or-restart! q (iterate! q h void)))
      (and (not (newton-turning? m))
           (made-at-y? q m h)
           (or-restart! q (iterate! q h void)))
      (begin
        (set-newton-turning?! m #t)
        (iterate! q h (lambda () (make-at-places! q m h))))))

(define (or-restart! q solved?)
  (unless solved? (restart! q))
  solved?)

;; (prepare!) : called before each iteration -> did it converge?
(define (iterate! q h prepare!)
  (define m (equations-newton q))
  (define (step!)
    (prepare!)
    (newton-step! q m h))
  (define count (steps-to-converge step! most-iterations only-rounding?))
  (unless (and count (<= count fast) (not (newton-turning? m))) (set-newton-step! m #f))
  (and count #t))

;; -> the greatest change of a slope, relative to y
(define (newton-step! q m h)
  (define-fields equations q f! n y A ks w new change)
  (define-fields newton m matrix exchanges residual)
  (for ([row (in-list A)] [k (in-list ks)] [from (in-naturals)])
    (add-slopes! q w h row)
    (f! w new)
    (weighted-sum! n change [1.0 new] [-1.0 k])
    (for ([i (in-range n)] [x (in-flvector change)])
      (flvector-set! residual (+ i (* from n)) x)))
  (solve-factored! matrix (flvector-length residual) exchanges residual)
  (for/fold ([most 0.0]) ([k (in-list ks)] [from (in-naturals)])
    (for ([i (in-range n)]) (flvector-set! change i (flvector-ref residual (+ i (* from n)))))
    (weighted-sum! n k [1.0 k] [1.0 change])
    (scale! change h)
    (flmax most (root-mean-square change y y n))))

;; ---------------------------------------------------------------------------
;; Its matrix

;; -> has the matrix, made of the derivatives at y, an inverse?
(define (made-at-y? q m h)
  (define-fields equations q n y A)
  (define-fields newton m jacobian! J)
  (jacobian! y J)
  (for ([column (in-range (length A))]) (fill-column! m column J A n h))
  (define made? (factor-matrix! m))
  (set-newton-step! m (and made? h))
  made?)

;; A matrix without an inverse makes changes that are no numbers.
(define (make-at-places! q m h)
  (define-fields equations q n A w)
  (define-fields newton m jacobian! J matrix)
  (for ([row (in-list A)] [column (in-naturals)])
    (add-slopes! q w h row)
    (jacobian! w J)
    (fill-column! m column J A n h))
  (unless (factor-matrix! m) (flvector-set! matrix 0 +nan.0)))

(define (factor-matrix! m)
  (define-fields newton m matrix exchanges residual)
  (factor! matrix (flvector-length residual) exchanges))

;; The blocks δ − h a J of one of the places.
(define (fill-column! m column J A n h)
  (define matrix (newton-matrix m))
  (define all (* n (length A)))
  (define left (* column n))
  (for ([row (in-list A)] [top (in-range 0 all n)])
    (define ha (fl* h (list-ref row column)))
    (for* ([i (in-range n)] [j (in-range n)])
      (define x (fl* ha (flvector-ref J (+ i (* j n)))))
      (define diagonal? (= (+ top i) (+ left j)))
      (flvector-set! matrix (+ (* (+ top i) all) left j)
                     (if diagonal? (fl- 1.0 x) (fl- 0.0 x))))))
