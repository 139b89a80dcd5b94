#lang racket/base
;; Normal forms near an equilibrium (Birkhoff 1927; with resonances Gustavson 1966).
;;
;; A symplectic matrix makes the quadratic terms a sum of modes (../quadratic/), and H is expanded
;; in variables x and y of these in which they are Σ c x y (complex-polynomial.rkt).  Then H is
;; transformed degree by degree (../Lie/Lie-triangle.rkt).  The monomial xᵃ yᵇ is removed by
;; dividing by i ω·(a − b): it stays if that is 0, which it always is for a = b, and otherwise is
;; a resonance of the frequencies.  Those of saddles are imaginary.

(require racket/list
         "../Lie/Lie-triangle.rkt" "../quadratic/phase-space-equilibrium.rkt"
         "../quadratic/symplectic-normal-form.rkt"
         "complex-polynomial.rkt" "Taylor-polynomial.rkt" "vanishing-divisor.rkt"
         "../../algebra/expression/expression.rkt"
         "../../calculus/expression-function.rkt"
         "../../error/complain.rkt"
         "../../generic/define-plain.rkt"
         "../../generic/describe.rkt" "../../generic/function.rkt"
         "../../generic/value-struct.rkt" "../../generic/wrong-argument.rkt"
         "../../hamiltonian/H-state.rkt"
         "../../value/matrix/matrix.rkt"
         "../../value/rewrite.rkt" "../../value/shape.rkt" "../../value/simplify.rkt"
         "../../value/series/series-access.rkt")

(provide Birkhoff-normal-form normal-form? normal-form-Hamiltonian normal-form-generators
         normal-form-resonances
         ;; for transformations and verdicts
         normal-form-state normal-form-place normal-form-matrix normal-form-modes
         normal-form-given normal-form-terms normal-form-Ws
         check-normal-form polynomial-function)

;; place : coordinates and momenta of the equilibrium; matrix : of the quadratic terms' modes
;; given, terms : the polynomials of degree 2, 3, … of H and of its normal form; Ws : of degree
;; 3, …; divisors : ((degree k . ω·k) …)
(value-struct normal-form (state place matrix modes tolerance given terms Ws divisors)
  #:text normal-form->text)

(define (check-normal-form who N)
  (check-argument who normal-form? N "what Birkhoff-normal-form gives"))

(define (normal-form-frequencies N) (modes-frequencies (normal-form-modes N)))
(define (normal-form-equilibrium N) (place->state (normal-form-state N) (normal-form-place N)))

(provide-parts normal-form? "what Birkhoff-normal-form gives"
  normal-form-frequencies normal-form-divisors normal-form-equilibrium)

;; ---------------------------------------------------------------------------

;; H near an equilibrium, with numbers for parameters;  state : of symbols;  at : a state of
;; numbers near the equilibrium;  degree : of the last terms, at least 3
(define-plain (Birkhoff-normal-form H state #:degree [degree 4] #:at [at #f]
                                    #:tolerance [tolerance rounding])
  (define who 'Birkhoff-normal-form)
  (unless (and (exact-integer? degree) (<= 3 degree most-degree))
    (complain-of-argument who (format "the degree of the last terms, from 3 to ~a" most-degree)
                          degree))
  (check-tolerance who tolerance)
  (define place (equilibrium-of who H state at))
  (define form (form-of-matrix (second-derivatives who H state place) tolerance))
  (define M (quadratic-normal-form-matrix form))
  (unless M (complain who "~a" form))
  (define m (make-modes (quadratic-normal-form-frequencies form)
                        (quadratic-normal-form-coordinates form)))
  (define h (homogeneous-parts who H state place M m degree))
  (define divisors '())
  (define-values (terms Ws)
    (Lie-triangle h (polynomial-bracket m) polynomial-sum polynomial-scale
                  (lambda (order f)
                    (define-values (W kept gone) (solve-monomials f m tolerance))
                    (set! divisors (append divisors (map (lambda (g) (cons (+ order 2) g)) gone)))
                    (values W kept))))
  (normal-form state place M m tolerance h terms Ws (remove-duplicates divisors)))

;; {H₂, W} + f = kept;  -> W, kept, ((a − b . ω·(a − b)) …)
(define (solve-monomials f m tolerance)
  (define-values (W kept frequencies) (values (make-hasheqv) (make-hasheqv) (modes-frequencies m)))
  (define gone
    (for/fold ([gone '()]) ([(key c) (in-hash f)])
      (define k (exponent-differences key (mode-count m)))
      (define d (apply + (map * k frequencies)))
      (cond [(vanishing? d frequencies tolerance)
             (hash-set! kept key c)
             gone]
            [else
             (hash-set! W key (/ (* 0+1i c) d))
             (if (positive? (first-nonzero k)) (cons (cons k d) gone) gone)])))
  (values W kept (sort (remove-duplicates gone) lexically<? #:key car)))

(define (lexically<? k l)
  (for/or ([i (in-list k)] [j (in-list l)] #:unless (= i j)) (< i j)))

(define (first-nonzero k) (or (findf (lambda (x) (not (zero? x))) k) 0))

;; The polynomials of degree 2, …, of the Taylor series of H at the place, in the modes' variables.
;; The terms of degree 2 are those of the modes: rounding leaves others beside them.
(define (homogeneous-parts who H state place M m degree)
  (define (variable row)
    (for/fold ([p (make-hasheqv)]) ([c (in-vector row)] [k (in-naturals)])
      (polynomial-sum p (polynomial-scale c (real-variable m k)))))
  (define parts
    (Taylor-parts (H state)
                  (for/list ([name (in-list (cdr (scalars state)))] [x (in-list place)]
                             [row (in-vector (matrix-rows M))])
                    (list* name x (variable row)))
                  degree
                  (lambda (part) (raise-no-number who H part))))
  (define n (mode-count m))
  (define quadratic
    (make-hasheqv
     (for/list ([w (in-list (modes-frequencies m))] [kappa (in-vector (modes-brackets m))]
                [j (in-naturals)] #:unless (eqv? w 0))
       (cons (+ (unit-key j) (unit-key (+ n j))) (/ (* 0-1i w) kappa)))))
  (cons quadratic (list-tail (vector->list parts) 3)))

;; ---------------------------------------------------------------------------
;; The results

;; The series of functions of the new state, by degree from 2 on
(define (normal-form-Hamiltonian N)
  (check-normal-form 'normal-form-Hamiltonian N)
  (apply series (map (lambda (f) (polynomial-function N f)) (terms-less-rounding N))))

(define (normal-form-generators N)
  (check-normal-form 'normal-form-generators N)
  (map (lambda (f) (polynomial-function N f)) (normal-form-Ws N)))

(define (polynomial-function N f)
  (define e (polynomial-in-symbols N f))
  (define state (normal-form-state N))
  (unary-function (lambda () (value->datum e)) (at)
    (check-state-like 'Birkhoff-normal-form state at)
    (evaluate-at e state at)))

;; With decimals a sum of monomials.
(define (polynomial-in-symbols N f)
  (define e (polynomial->expression (normal-form-modes N) f (cdr (scalars (normal-form-state N)))))
  (cond [(not (expression? e)) e]
        [(for/and ([c (in-hash-values f)]) (exact? c)) (simplify e)]
        [else (expand e)]))

;; Decimals that are nothing beside those of H and of the normal form of that degree are left out.
(define (terms-less-rounding N)
  (for/list ([f (in-list (normal-form-terms N))] [h (in-list (normal-form-given N))])
    (define small
      (* rounding (apply max 0 (map magnitude (append (hash-values f) (hash-values h))))))
    (for/hasheqv ([(key c) (in-hash f)] #:unless (and (inexact? c) (<= (magnitude c) small)))
      (values key c))))

;; The integers k with k·ω = 0 of the monomials that stayed beside those of a = b
(define (normal-form-resonances N)
  (check-normal-form 'normal-form-resonances N)
  (remove-duplicates
   (append*
    (for/list ([f (in-list (terms-less-rounding N))])
      (sort (for*/list ([key (in-list (hash-keys f))]
                        [k (in-value (exponent-differences key (mode-count (normal-form-modes N))))]
                        #:when (positive? (first-nonzero k)))
              k)
            lexically<?)))))

;; ---------------------------------------------------------------------------
;; In words

(define (normal-form->text N)
  (define terms (terms-less-rounding N))
  (define (line mark ks) (if (null? ks) "" (format "\n  ~a: ~a" mark ks)))
  (define place (normal-form-place N))
  (string-append
   (format "normal form to degree ~a, of frequencies ~a" (add1 (length terms))
           (normal-form-frequencies N))
   (if (andmap (lambda (x) (eqv? x 0)) place)
       ""
       (format "\n  at ~a" (value->text (normal-form-equilibrium N))))
   (apply string-append
          (for/list ([f (in-list terms)] [degree (in-naturals 2)])
            (format "\n  degree ~a: ~a" degree (value->text (polynomial-in-symbols N f)))))
   (line "resonances" (normal-form-resonances N))
   (line "near resonances, undecided" (near-resonances N))))

;; ((k divisor) …) of divisors that have lost more than half of their digits
(define (near-resonances N)
  (define frequencies (normal-form-frequencies N))
  (remove-duplicates
   (for/list ([d (in-list (normal-form-divisors N))]
              #:when (and (inexact? (cddr d))
                          (vanishing? (cddr d) frequencies (sqrt (normal-form-tolerance N)))))
     (list (cadr d) (cddr d)))))
