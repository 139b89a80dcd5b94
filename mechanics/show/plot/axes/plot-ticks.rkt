#lang racket/base
;; Ticks of an axis, and the numbers beside them.
;;
;; The step from one number to the next is a power of ten, or a half, a quarter or a fifth of it:
;; that which has the number of multiples between the ends nearest to four.  Between the numbers
;; are ticks without one, at multiples of a finer step of this kind that meet all the numbers.

(require (only-in racket/math exact-ceiling exact-floor exact-round
                  order-of-magnitude)
         (only-in racket/string string-trim))

(provide ticks-between log-ticks-between (struct-out tick))

;; value : exact number; label : string, or #f
(struct tick (value label) #:transparent)

(define wanted-numbers 4)

;; low < high : the ends of the axis -> list of ticks, ascending
(define (ticks-between from to)
  (define-values (low high) (values (inexact->exact from) (inexact->exact to)))
  (define numbers (multiples (best-step low high wanted-numbers) low high))
  (define digits (- 3 (order-of-magnitude (- high low))))
  (for/list ([x (in-list (or (finer numbers low high) numbers))])
    (tick x (and (member x numbers) (number->label x digits)))))

(define (finer numbers low high)
  (for*/first ([parts (in-range 2 5)]
               [all (in-value (multiples (best-step low high (* parts wanted-numbers)) low high))]
               #:when (> (length all) (length numbers))
               #:when (andmap (lambda (x) (member x all)) numbers))
    all))

(define (multiples step low high)
  (for/list ([k (in-range (exact-ceiling (/ low step)) (+ 1 (exact-floor (/ high step))))])
    (* k step)))

;; Of two steps that are as good, the later is taken.
(define (best-step low high wanted)
  (define power (expt 10 (order-of-magnitude (- high low))))
  (define (distance step)
    (define inner
      (for/sum ([x (in-list (multiples step low high))])
        (if (< (* 1000 (min (- x low) (- high x))) power) 0 1)))
    (abs (- inner wanted)))
  (for*/fold ([best power] [least +inf.0] #:result best)
             ([unit (in-list (if (< wanted 10) '(1 10) '(1/10 1 10)))]
              [part (in-list '(1 1/2 1/4 1/5))])
    (define step (* power unit part))
    (define d (distance step))
    (if (<= d least) (values step d) (values best least))))

;; ---------------------------------------------------------------------------
;; Logarithmic axes

;; low < high : decimal logarithms -> list of ticks at logarithms, ascending.  There are numbers at
;; powers of ten, from one to the next or passing over some, and ticks at their multiples up to 9;
;; where there are fewer than two powers, numbers are those of a plain axis.
(define (log-ticks-between from to)
  (define rounding (* 1e-9 (- to from)))
  (define-values (low high) (values (- from rounding) (+ to rounding)))
  (define powers (multiples 1 (inexact->exact low) (inexact->exact high)))
  (define apart (max 1 (quotient (length powers) wanted-numbers)))
  (cond [(null? (if (pair? powers) (cdr powers) '()))
         (for/list ([t (in-list (ticks-between (expt 10.0 low) (expt 10.0 high)))])
           (tick (log (tick-value t) 10) (tick-label t)))]
        [else
         (for*/list ([k (in-range (exact-floor low) (+ 1 (exact-ceiling high)))]
                     [m (in-range 1 (if (= apart 1) 10 2))]
                     [at (in-value (+ k (log m 10)))]
                     #:when (<= low at high))
           (tick at (and (= m 1) (eqv? 0 (modulo k apart)) (power->label k))))]))

(define (power->label k)
  (if (<= -2 k 3) (number->label (expt 10 k) 3) (format "10~a" (superscript k))))

;; ---------------------------------------------------------------------------
;; Labels

;; x rounded to so many digits after the point; negative: to tens, hundreds ...  An integer, or a
;; number less than 1, has a power of ten where that is shorter.
(define (number->label x digits)
  (define rounded (exact-round (* (abs x) (expt 10 digits))))
  (if (= rounded 0)
      "0"
      (string-append (if (< x 0) "-" "") (magnitude->label (number->string rounded) digits))))

(define (magnitude->label all digits)
  (define significant (string-trim all "0" #:left? #f #:repeat? #t))
  (define exponent (- (string-length all) 1 digits))        ; of the first digit
  (define plain (decimal significant exponent))
  (define short (format "~a×10~a" (decimal significant 0) (superscript exponent)))
  (define mixed? (< -1 exponent (- (string-length significant) 1)))
  (if (or mixed? (<= (string-length plain) (string-length short))) plain short))

;; -> the decimal number with these digits, of which the first is of 10^exponent
(define (decimal digits exponent)
  (define length (string-length digits))
  (define (zeros n) (make-string n #\0))
  (define point (+ exponent 1))
  (cond [(<= point 0) (string-append "." (zeros (- point)) digits)]
        [(>= point length) (string-append digits (zeros (- point length)))]
        [else (string-append (substring digits 0 point) "." (substring digits point))]))

(define (superscript n)
  (list->string (for/list ([c (in-string (number->string n))]) (cdr (assv c raised)))))

(define raised (map cons (string->list "0123456789-") (string->list "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")))
