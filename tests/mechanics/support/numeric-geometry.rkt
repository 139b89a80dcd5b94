#lang racket/base
;; Connections, curvature and brackets of plain functions of numbers, by differences: nothing here
;; is the library's.
;;
;; A metric is a function of n numbers to n lists of n numbers, a vector field one to n numbers.
;; Derivatives are by the symmetric formula of order 6 over steps of 1/200, right to about 1e-11.

(provide numeric-Christoffel     ; (numeric-Christoffel metric x) : (symbols a b k)
         numeric-Riemann         ; (numeric-Riemann metric x) : (R a b k l)
         numeric-Ricci           ; (numeric-Ricci metric x) : (R b l)
         numeric-bracket)        ; (numeric-bracket X Y x) : list of numbers

(define h 1/200)

(define (moved x k by) (for/list ([c (in-list x)] [i (in-naturals)]) (if (= i k) (+ c by) c)))

;; ∂f/∂xₖ, f a function of a list of numbers
(define (slope f k x)
  (define (difference m) (- (f (moved x k (* m h 1.0))) (f (moved x k (* m h -1.0)))))
  (/ (+ (* 45 (difference 1)) (* -9 (difference 2)) (difference 3)) (* 60.0 h)))

(define-syntax-rule (sum (i n) term) (for/sum ([i (in-range n)]) term))

;; By Gauss and Jordan, largest pivots first
(define (inverse rows)
  (define n (length rows))
  (define M
    (for/list ([row (in-list rows)] [i (in-naturals)])
      (append row (for/list ([j (in-range n)]) (if (= i j) 1.0 0.0)))))
  (define (clear row pivot-row k)
    (define factor (/ (list-ref row k) (list-ref pivot-row k)))
    (map (lambda (a b) (- a (* factor b))) row pivot-row))
  (for/fold ([M M] #:result (for/list ([row (in-list M)] [i (in-naturals)])
                              (map (lambda (a) (/ a (list-ref row i))) (list-tail row n))))
            ([k (in-range n)])
    (define best (argmax-by (lambda (i) (abs (list-ref (list-ref M i) k))) k n))
    (define swapped (exchanged M k best))
    (for/list ([row (in-list swapped)] [i (in-naturals)])
      (if (= i k) row (clear row (list-ref swapped k) k)))))

(define (argmax-by f from to)
  (for/fold ([best from]) ([i (in-range from to)]) (if (> (f i) (f best)) i best)))

(define (exchanged M i j)
  (for/list ([row (in-list M)] [k (in-naturals)])
    (list-ref M (cond [(= k i) j] [(= k j) i] [else k]))))

;; ---------------------------------------------------------------------------

(define (numeric-Christoffel metric x)
  (define n (length x))
  (define (entry i j) (lambda (x) (list-ref (list-ref (apply metric x) i) j)))
  (define up (inverse (apply metric x)))
  (lambda (a b k)
    (* 1/2 (sum (m n)
                (* (list-ref (list-ref up a) m)
                   (+ (slope (entry m b) k x) (slope (entry m k) b x)
                      (- (slope (entry b k) m x))))))))

(define (numeric-Riemann metric x)
  (define n (length x))
  (define symbol (numeric-Christoffel metric x))
  (define (symbol-slope a b k by)
    (slope (lambda (x) ((numeric-Christoffel metric x) a b k)) by x))
  (lambda (a b k l)
    (+ (symbol-slope a b l k) (- (symbol-slope a b k l))
       (sum (m n) (- (* (symbol a m k) (symbol m b l)) (* (symbol a m l) (symbol m b k)))))))

(define (numeric-Ricci metric x)
  (define R (numeric-Riemann metric x))
  (lambda (b l) (sum (a (length x)) (R a b a l))))

(define (numeric-bracket X Y x)
  (define n (length x))
  (define (along U V i)
    (sum (k n) (* (list-ref (apply U x) k) (slope (lambda (x) (list-ref (apply V x) i)) k x))))
  (for/list ([i (in-range n)]) (- (along X Y i) (along Y X i))))
