#lang racket/base
;; The homological equation of a Hamiltonian h₀(I) with the frequencies ω = ∂h₀/∂I,
;;
;;     {h₀, W} + h = kept,      that is      ω·∂W/∂θ = h − kept,
;;
;; wave by wave: c cos k·θ + s sin k·θ is the rate of (c sin k·θ − s cos k·θ)/(k·ω).  The term
;; without angles is kept, and so are the waves of resonances: those with k·ω = 0 whatever the
;; momenta, which cannot be removed, and those that are asked for.

(require "Poisson-series.rkt" "vanishing-divisor.rkt"
         "../../generic/arithmetic.rkt" "../../generic/sums-and-products.rkt"
         "../../value/simplify.rkt")

(provide solve-homological (struct-out removed))

;; A wave that was removed: its integers and its divisor
(struct removed (numbers divisor) #:authentic)

;; k·ω
(define (divisor k frequencies)
  (simplify-strictly
   (g:for/sum ([i (in-list k)] [omega (in-list frequencies)])
     (g:* i omega))))

;; h : a Poisson series; resonant? : k -> is it to be kept?; number : an expression -> the same
;; with its decimals (symbols-for-decimals.rkt), which tell whether it vanishes
;; -> W, the series kept, the list of waves removed
(define (solve-homological h frequencies resonant? number)
  (define none (zero-series (length frequencies)))
  (define sizes (map number frequencies))
  (for/fold ([W none] [kept none] [gone '()]) ([k (in-list (wave-numbers h))])
    (define-values (c s)
      (let ([w (hash-ref (series-waves h) k)]) (values (wave-cosine w) (wave-sine w))))
    (define d (divisor k frequencies))
    (cond [(or (andmap zero? k) (vanishing? (number d) sizes) (resonant? k))
           (values W (series-sum kept (one-wave k c s)) gone)]
          [else
           (define V (one-wave k (g:negate (g:/ s d)) (g:/ c d)))
           (values (series-sum W V) kept (cons (removed k d) gone))])))
