#lang racket/base
;; Loops over Taylor coefficients.
;;
;; A *row* is an flvector of the coefficients of one quantity, from order 0 on.  The
;; coefficient k of a product is the convolution Σ a_j b_{k−j}; recurrences of functions are
;; convolutions as well, over parts of that range.  Several terms are taken at a time, and several
;; sums in one loop: the compiler keeps them all in registers.

(require racket/unsafe/ops
         "../unboxed-loop.rkt")

(provide convolve convolve-halves polynomials smaller greater)

(define-syntax-rule (smaller a b) (let ([x a] [y b]) (if (unsafe-fx< x y) x y)))
(define-syntax-rule (greater a b) (let ([x a] [y b]) (if (unsafe-fx< x y) y x)))

;; `result`, where each s is Σ a_j b_{k−j} for j from `first` to `last`.
(define-syntax convolve
  (syntax-rules ()
    [(_ k first last (one) result) (convolve-one k first last one result)]
    [(_ k first last (one ...) result) (convolve-some k first last (one ...) result)]))

;; Terms in pairs.
(define-syntax-rule (convolve-some k first last ([s a b] ...) result)
  (let ([end last] [from first])
    (let loop ([i from] [j (unsafe-fx- k from)] [s 0.0] ...)
      (cond [(unsafe-fx< i end) (loop (unsafe-fx+ i 2) (unsafe-fx- j 2) (plus-two s a b i j) ...)]
            [(unsafe-fx= i end) (let ([s (plus-one s a b i j)] ...) result)]
            [else result]))))

;; A sum alone would wait for each addition: it is two.
(define-syntax-rule (convolve-one k first last [s a b] result)
  (let ([end last] [from first])
    (let loop ([i from] [j (unsafe-fx- k from)] [s 0.0] [rest 0.0])
      (define left (unsafe-fx- end i))
      (define-syntax-rule (ending with-s) (let ([s with-s]) result))
      (cond [(unsafe-fx> left 2)
             (loop (unsafe-fx+ i 4) (unsafe-fx- j 4)
                   (plus-two s a b i j)
                   (plus-two rest a b (unsafe-fx+ i 2) (unsafe-fx- j 2)))]
            [(unsafe-fx= left 2)
             (ending (unsafe-fl+ (plus-two s a b i j)
                                 (plus-one rest a b (unsafe-fx+ i 2) (unsafe-fx- j 2))))]
            [(unsafe-fx= left 1) (ending (unsafe-fl+ (plus-two s a b i j) rest))]
            [(unsafe-fx= left 0) (ending (plus-one (unsafe-fl+ s rest) a b i j))]
            [else (ending (unsafe-fl+ s rest))]))))

(define-syntax-rule (plus-one s a b i j) (unsafe-fl+ s (unsafe-fl* (at a i) (at b j))))

(define-syntax-rule (plus-two s a b i j)
  (unsafe-fl+ s (unsafe-fl+ (unsafe-fl* (at a i) (at b j))
                            (unsafe-fl* (at a (unsafe-fx+ i 1)) (at b (unsafe-fx- j 1))))))

;; `result`, where each s is Σ a_j a_{k−j} for j from `first` to k − `first`: twice the sum
;; below the middle, and the square in it.
(define-syntax-rule (convolve-halves k first ([s a] ...) result)
  (let loop ([i first] [j (unsafe-fx- k first)] [s 0.0] ...)
    (cond [(unsafe-fx< i j)
           (loop (unsafe-fx+ i 1) (unsafe-fx- j 1)
                 (unsafe-fl+ s (unsafe-fl* (at a i) (at a j))) ...)]
          [(unsafe-fx= i j)
           (let ([s (unsafe-fl+ (unsafe-fl+ s s) (unsafe-fl* (at a i) (at a i)))] ...) result)]
          [else (let ([s (unsafe-fl+ s s)] ...) result)])))

;; `result`, where each s is Σ c_j u^(j − first) for j from `first` to `last`, of the row c.  Even
;; and odd terms are two sums in u²: the processor works on both at once.
(define-syntax-rule (polynomials u first last ([s odd c] ...) result)
  (let ([square (unsafe-fl* u u)])
    (let loop ([j last] [s 0.0] ... [odd 0.0] ...)
      (cond [(unsafe-fx> j first)
             (loop (unsafe-fx- j 2)
                   (unsafe-fl+ (at c j) (unsafe-fl* square s)) ...
                   (unsafe-fl+ (at c (unsafe-fx- j 1)) (unsafe-fl* square odd)) ...)]
            [(unsafe-fx= j first)
             (let ([s (unsafe-fl+ (unsafe-fl+ (at c j) (unsafe-fl* square s))
                                  (unsafe-fl* u odd))] ...)
               result)]
            [else (let ([s (unsafe-fl+ odd (unsafe-fl* u s))] ...) result)]))))
