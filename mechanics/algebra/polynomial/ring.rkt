#lang racket/base
;; Rings of polynomials, and the layout of their monomials.
;;
;; A monomial x₀^e₀ ··· xₙ₋₁^eₙ₋₁ is packed into bit fields, the total degree on
;; top, then x₀, x₁ and so on, over as many words (monomial.rkt) as it takes:
;;
;;     | 0 total degree | 0 e₀ | 0 e₁ | ... |   | 0 eₖ | ... |   ...
;;
;; A field has room for the ring's greatest degree and one more bit, the
;; *guard*, which is 0 in every monomial.  Then the product of monomials is
;; addition, the graded lexicographic order is that of the words, and a divides
;; b just when b - a borrows across no field, so that its guard bits are 0.
;;
;; No exponent exceeds the total degree, so a product fits as soon as its total
;; degree does: one look at the product of the leading monomials guards a whole
;; multiplication.

(require racket/fixnum
         "work-budget.rkt" "monomial.rkt" "power.rkt"
         "../../error/degree-overflow.rkt")

(provide
 ;; rings
 make-ring wider-ring ring? ring-size ring-max-degree ring-one ring-guards charge!
 (struct-out exn:algebra:degree-overflow)
 check-degree check-monomial check-power
 ;; monomials from exponents
 variable-unit variable-monomial variable-power
 ;; exponents of monomials
 monomial-degree monomial-exponent monomial-factors monomial-fold
 monomial-part monomial-gcd
 ;; tables keyed by monomials
 make-monomial-hash)

;; bits : width of a field, with its guard; field : as many ones
;; degree-shift : place of the total degree in the first word
;; words, shifts : fxvectors by variable: its word, and its place there
;; lasts : vector by word: the variable in its lowest field
;; units : vector of the variables as monomials; one, guards : monomials
;; meter : of the work in the ring, or #f
(struct ring (size max-degree bits field degree-shift words shifts lasts units one guards meter)
  #:authentic)

(define word-bits 60)

;; Polynomials in n variables of total degree at most max-degree.
(define (make-ring n max-degree [meter #f])
  (define bits (+ 1 (integer-length (max 1 max-degree))))
  (unless (< (* 2 bits) word-bits)
    (raise-argument-error 'make-ring "a degree below 2^28" max-degree))
  (define field (- (fxlshift 1 bits) 1))
  (define-values (lasts words shifts) (layout n bits))
  (define word-count (vector-length lasts))
  (define degree-shift
    (fx* bits (+ 1 (vector-ref lasts 0))))
  (define (one-bit word shift) (chain word-count (hasheqv word (fxlshift 1 shift))))
  (define degree-unit (one-bit 0 degree-shift))
  (ring n max-degree bits field degree-shift words shifts lasts
        (for/vector #:length n ([w (in-fxvector words)] [s (in-fxvector shifts)])
          (monomial+ degree-unit (one-bit w s)))
        (chain word-count (hasheqv))
        (for/fold ([guards (one-bit 0 (+ degree-shift bits -1))])
                  ([w (in-fxvector words)] [s (in-fxvector shifts)])
          (monomial+ guards (one-bit w (+ s bits -1))))
        meter))

;; A ring of the same variables, with the same meter, for another greatest degree.
(define (wider-ring R max-degree) (make-ring (ring-size R) max-degree (ring-meter R)))

;; n terms are multiplied or looked at; those of many words are dearer.
(define (charge! R n)
  (define meter (ring-meter R))
  (when meter
    (meter-charge! meter (fxquotient (fx* n (fx+ 3 (vector-length (ring-lasts R)))) 4))))

;; Variables fill the words in order; the first word keeps one field free.
(define (layout n bits)
  (define per-word (quotient word-bits bits))
  (define words (make-fxvector n))
  (define shifts (make-fxvector n))
  (define lasts
    (let fill ([word 0] [start 0] [room (- per-word 1)])
      (define end (min n (+ start room)))
      (for ([i (in-range start end)])
        (fxvector-set! words i word)
        (fxvector-set! shifts i (* bits (- end i 1))))
      (cons (- end 1)
            (if (< end n) (fill (+ word 1) end per-word) '()))))
  (values (list->vector lasts) words shifts))

;; The monomial with the given words, others 0.
(define (chain word-count words)
  (let loop ([w 0])
    (define word (hash-ref words w 0))
    (if (= w (- word-count 1)) word (cons word (loop (+ w 1))))))

;; ---------------------------------------------------------------------------
;; Degree overflow

(define (check-degree R degree)
  (unless (<= degree (ring-max-degree R))
    (raise-degree-overflow degree (ring-max-degree R))))

;; m, a monomial or a product of two, when it is a monomial of the ring.
(define (check-monomial R m)
  (check-degree R (monomial-degree R m))
  m)

;; m^k, checked.
(define (check-power R m k)
  (check-degree R (* k (monomial-degree R m)))
  (monomial-power m k))

;; ---------------------------------------------------------------------------
;; Monomials from exponents

(define (variable-unit R i) (vector-ref (ring-units R) i))

(define (variable-monomial R i exponent)
  (check-power R (variable-unit R i) exponent))

;; The same monomial, unchecked: the exponent is known to fit.
(define (variable-power R i exponent)
  (monomial-power (variable-unit R i) exponent))

;; ---------------------------------------------------------------------------
;; Exponents of monomials

(define (monomial-degree R m)
  (fxrshift (monomial-head m) (ring-degree-shift R)))

(define (monomial-exponent R m i)
  (fxand (fxrshift (monomial-word m (fxvector-ref (ring-words R) i))
                   (fxvector-ref (ring-shifts R) i))
         (ring-field R)))

(define (monomial-word m w)
  (cond [(eq? w 0) (monomial-head m)]
        [(fixnum? (cdr m)) (cdr m)]
        [else (monomial-word (cdr m) (fx- w 1))]))

;; Fold over the variables that occur, by ascending index:
;; (combine index exponent result).  Costs one step a variable occurring and one
;; a word, not one a variable of the ring.
(define (monomial-fold R m combine result)
  (define bits (ring-bits R))
  (define lasts (ring-lasts R))
  (let next-field ([rest (below-degree R m)] [m m] [w 0] [result result])
    (cond [(not (eq? rest 0))
           (define k (fxquotient (fx- (integer-length rest) 1) bits))
           (define shift (fx* k bits))
           (define e (fxrshift rest shift))
           (next-field (fx- rest (fxlshift e shift)) m w
                       (combine (fx- (vector-ref lasts w) k) e result))]
          [(fixnum? m) result]
          [else
           (next-field (monomial-head (cdr m)) (cdr m) (fx+ w 1) result)])))

;; Powers (power.rkt) of the variables that occur, by ascending index.
(define (monomial-factors R m)
  (reverse (monomial-fold R m (lambda (i e factors) (cons (make-power i e) factors)) '())))

;; The first word without the total degree.
(define (below-degree R m)
  (define word (monomial-head m))
  (define shift (ring-degree-shift R))
  (fx- word (fxlshift (fxrshift word shift) shift)))

;; A procedure from monomials to their parts in the given variables.
(define (monomial-part R variables)
  (define field (ring-field R))
  (define mask
    (for/fold ([mask (ring-one R)]) ([i (in-list variables)])
      (define unit (variable-unit R i))
      (monomial-join mask (monomial-power (monomial- unit (degree-unit R)) field))))
  (lambda (m)
    (for/fold ([part (ring-one R)]) ([f (in-list (monomial-factors R (monomial-mask mask m)))])
      (monomial+ part (variable-power R (power-base f) (power-exponent f))))))

;; The total degree 1 alone, no variable.
(define (degree-unit R)
  (define bit (fxlshift 1 (ring-degree-shift R)))
  (define one (ring-one R))
  (if (fixnum? one) bit (cons bit (cdr one))))

(define (monomial-gcd R a b)
  (let loop ([xs (monomial-factors R a)] [ys (monomial-factors R b)] [m (ring-one R)])
    (cond [(or (null? xs) (null? ys)) m]
          [else
           (define i (power-base (car xs)))
           (define j (power-base (car ys)))
           (define e (min (power-exponent (car xs)) (power-exponent (car ys))))
           (cond [(< i j) (loop (cdr xs) ys m)]
                 [(> i j) (loop xs (cdr ys) m)]
                 [else (loop (cdr xs) (cdr ys) (monomial+ m (variable-power R i e)))])])))

;; ---------------------------------------------------------------------------
;; Tables

(define (make-monomial-hash R)
  (if (fixnum? (ring-one R)) (make-hasheq) (make-hash)))
