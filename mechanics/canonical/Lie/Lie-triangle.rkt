#lang racket/base
;; Normal forms order by order (Dragt and Finn 1976; SICM 7.2–7.3).
;;
;; H = h₀ + ε h₁ + ε² h₂ + ⋯ is transformed by one exponential for each order,
;;
;;     H' = exp(εⁿ L_{Wₙ}) ⋯ exp(ε² L_{W₂}) exp(ε L_{W₁}) H,        L_W F = {F, W}.
;;
;; The one for order n leaves those before as they are, and adds {h₀, Wₙ} to the term of order n:
;; so Wₙ is found from the homological equation {h₀, Wₙ} + hₙ = the part to be kept.  Then
;;
;;     hₘ ← Σⱼ Lʲ h_{m − jn}/j!.
;;
;; The terms may be series of waves or polynomials: the caller gives their bracket, sum and scale.

(require (only-in racket/list list-set))

(provide Lie-triangle carry)

;; h : the list of h₀, …, h_N;  bracket : F, G ↦ {F, G};  sum : F, G ↦ F + G; scale : number, F
;; solve : n, hₙ -> Wₙ, and the part that is kept
;; -> the terms of H' and the list of W₁, …, W_N
(define (Lie-triangle h bracket sum scale solve)
  (for/fold ([h h] [Ws '()] #:result (values h (reverse Ws))) ([n (in-range 1 (length h))])
    (define-values (W kept) (solve n (list-ref h n)))
    (define next (exponentiate h n W bracket sum scale))
    ;; by construction; rounding would leave a rest
    (values (list-set next n kept) (cons W Ws))))

;; The terms of ⋯ exp(ε² L_{W₂}) exp(ε L_{W₁}) F, for the terms of F; with the sign −1 the inverse,
;; exp(−ε L_{W₁}) exp(−ε² L_{W₂}) ⋯ F
(define (carry terms Ws bracket sum scale #:sign [sign 1])
  (define numbered (for/list ([W (in-list Ws)] [n (in-naturals 1)]) (cons n W)))
  (for/fold ([terms terms]) ([nW (in-list (if (= sign 1) numbered (reverse numbered)))])
    (exponentiate terms (car nW) (cdr nW) bracket sum scale sign)))

;; The terms of exp(± εⁿ L_W) F, for the terms of F
(define (exponentiate terms n W bracket sum scale [sign 1])
  (define powers                    ; powers[j] : the terms of Lʲ F/j!, shifted by j n
    (let loop ([j 0] [shifted terms] [found (list terms)])
      (define longest (- (length terms) (* (add1 j) n)))
      (cond [(<= longest 0) (reverse found)]
            [else
             (define next
               (for/list ([F (in-list shifted)] [_ (in-range longest)])
                 (scale (/ sign (add1 j)) (bracket F W))))
             (loop (add1 j) next (cons next found))])))
  (for/list ([m (in-range (length terms))])
    (for*/fold ([total #f] #:result total) ([(p j) (in-parallel (in-list powers) (in-naturals))]
                                            #:when (>= (- m (* j n)) 0))
      (define part (list-ref p (- m (* j n))))
      (if total (sum total part) part))))
