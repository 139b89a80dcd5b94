#lang racket/base
;; How far a resonance reaches (SICM 7.4, pp. 479–490).
;;
;; Near k·ω(I) = 0 the wave k of the perturbation, V cos(k·θ − δ), turns slowly.  Moved along k,
;; I = I* + J k, the rest of H₀ + V cos is a pendulum, A J²/2 + V cos ψ with A = k·∂²H₀·k, whose
;; separatrix is 2 √(V/A) high on either side: momenta are moved by up to that times k.
;; Resonances whose widths overlap make the motion chaotic (Chirikov 1979).

(require (only-in racket/list append-map list-set)
         "Poisson-series.rkt" "unperturbed.rkt"
         "../../calculus/derivative.rkt"
         "../../error/complain.rkt"
         "../../generic/arithmetic.rkt" "../../generic/compare.rkt" "../../generic/describe.rkt"
         "../../generic/elementary.rkt"
         "../../generic/sums-and-products.rkt" "../../generic/up-down.rkt"
         "../../generic/wrong-argument.rkt"
         "../../hamiltonian/H-state.rkt" "../../hamiltonian/Hamiltonian.rkt"
         "../../lagrangian/local-tuple.rkt"
         "../../value/shape.rkt" "../../value/simplify.rkt")

(provide resonance-width resonance-center)

;; The greatest shift of the momenta from the middle of the resonance, a tuple like these.
;; H0, H1 : functions of the state; k : integers; state : on the resonance
(define (resonance-width H0 H1 k state)
  (check-Hamiltonian 'resonance-width H0)
  (check-Hamiltonian 'resonance-width H1)
  (check-H-state 'resonance-width state)
  (check-unperturbed 'resonance-width H0 (symbolic-state state))
  (define-values (names wave) (wave-of 'resonance-width H1 k state))
  (define A (curvature H0 k state))
  (when (g:zero? A)
    (complain 'resonance-width
              "the frequency of the wave ~a does not change along it: no pendulum bounds it" k))
  (define (at e) (apply substitute e (append-map list names (scalars state))))
  (define V (g:sqrt (g:+ (g:square (at (wave-cosine wave))) (g:square (at (wave-sine wave))))))
  (define half (g:* 2 (g:sqrt (g:abs (g:/ V A)))))
  (list->structure (momentum state) (for/list ([i (in-list k)]) (g:* half (abs i)))))

;; k·∂²H₀/∂I²·k
(define (curvature H0 k state)
  (define direction (list->structure (momentum state) k))
  (define (energy x)
    (H0 (up (time state) (coordinate state) (g:+ (momentum state) (g:* x direction)))))
  (derivative-at (lambda (x) (derivative-at energy x)) 0))

;; A state of symbols, spelt as in messages: those of the state, or t, q and p with indices
(define (symbolic-state state)
  (define (spelt part name)
    (define xs (list->vector (scalars part)))
    (define (index k) (if (= (vector-length xs) 1) "" (format "_~a" k)))
    (scalars->structure part (lambda (k)
                               (define x (vector-ref xs k))
                               (if (symbol? x) x (string->symbol (format "~a~a" name (index k)))))))
  (unknowns-like (up (spelt (time state) "t")
                     (spelt (coordinate state) "q")
                     (spelt (momentum state) "p"))))

;; The value of the momentum of index j that puts a state on the resonance k, the others being
;; as they are: where k·ω is of degree 1 in it.
(define (resonance-center H0 k state j)
  (define who 'resonance-center)
  (check-Hamiltonian who H0)
  (check-H-state who state)
  (define I (scalars (momentum state)))
  (check-integers who k (length I))
  (check-unperturbed who H0 (symbolic-state state))
  (unless (and (exact-nonnegative-integer? j) (< j (length I)))
    (complain-of-argument who (format "the index of a momentum, below ~a" (length I)) j))
  (define (slope x)
    (define p (list->structure (momentum state) (list-set I j x)))
    (define omegas
      (scalars (derivative-at (lambda (p) (H0 (up (time state) (coordinate state) p))) p)))
    (g:for/sum ([n (in-list k)] [omega (in-list omegas)]) (g:* n omega)))
  (define rate (simplify (derivative-at slope 0)))
  (check-linear who slope rate k j)
  (simplify (g:negate (g:/ (slope 0) rate))))

;; slope : p -> k·ω;  rate : its derivative at 0
(define (check-linear who slope rate k j)
  (define p (string->uninterned-symbol "p"))
  (unless (eqv? 0 (simplify-strictly (g:- (derivative-at slope p) rate)))
    (complain who
              (string-append "the frequency of the wave ~a is not of degree 1 in the momentum ~a"
                             "\n  its zeros are found by (find-root f low high)")
              k j))
  (when (g:zero? rate)
    (complain who "the frequency of the wave ~a does not depend on the momentum ~a" k j)))

(define (check-integers who k n)
  (unless (and (list? k) (= (length k) n) (andmap exact-integer? k))
    (complain who "expected the integers of a wave, a list of ~a; given ~a" n
              (describe-with-value k))))

;; -> symbols, and the wave of H1 at these
(define (wave-of who H1 k state)
  (check-H-state who state)
  (define place (symbols-like state "x"))
  (define angles (scalars (coordinate place)))
  (check-integers who k (length angles))
  (define (fail part)
    (complain who "~a is no sum of sines and cosines of the angles: there is ~a"
              (value->text H1) (value->text part)))
  (define waves (series-waves (expression->Poisson-series (H1 place) angles fail)))
  (values (scalars place)
          (or (hash-ref waves k #f) (hash-ref waves (map - k) #f)
              (complain who "the perturbation has no wave ~a; it has ~a" k
                        (sort (hash-keys waves) string<? #:key value->text)))))
