#lang racket/base
;; Integrals of functions made by the generic arithmetic.
;;
;; Within a derivative the integrand, or a limit, may be a perturbed value.
;; Integration is linear, so the integral of f + f' ε + … is that of f plus ε times
;; that of f', and so on; and at a limit b + b' ε it is the integral up to b plus
;; f(b) b' ε, to higher order the Taylor series that this begins.  Where a gradient
;; is taken, the derivative by each variable is the integral of that of f.
;;
;; An integrand that jumps or bends at a place that moves with ε is integrated in pieces,
;; whose ends move (moving-places.rkt).

(require racket/list
         "derivative.rkt" "dual.rkt" "gradient-tape.rkt" "Taylor-number.rkt"
         "perturbed-value.rkt"
         "moving-places.rkt" "peak-places.rkt" "recorded-number.rkt"
         "../error/note.rkt"
         "../generic/arithmetic.rkt" "../generic/operation-rule/branches.rkt"
         "../generic/elementary.rkt"
         "../generic/number-argument.rkt" "../generic/sums-and-products.rkt"
         "../numeric/quadrature/improper.rkt")

(provide integrate integral-by-components)

;; One integral: the question, the bound of its error and its cost so far.
;; compile : f x -> f as a function from flonum to flonum, or #f; x is an example
;; bound   : the sum of the bounds of errors;  count : how often f was evaluated
;; search? : -> whether to look for narrow peaks
;; met     : was a value other than an exact 0 met?
(struct task (who tolerance compile search? [bound #:mutable] [count #:mutable] [met #:mutable])
  #:authentic)

;; A box around an integral that is being taken, which another within its integrand sets:
;; to look for peaks takes ten times the evaluations of a smooth integrand, which is little,
;; but a thousand times those of a threefold integral.
(define current-integral (make-parameter #f))

;; The integral of a function of one variable, to a tolerance relative to the
;; integral of its absolute value, as (report value bound count).  It is loaded on demand,
;; which a function with keywords would make slow.
(define (integrate who f low high tolerance
                   [compile (lambda (f x) #f)] [report (lambda (value bound count) value)])
  (check-function-of-one-variable who f)
  (define around (current-integral))
  (define iterated? (box (and around #t)))
  (when around (set-box! around #t))
  (define t (task who tolerance compile (lambda () (not (unbox iterated?))) 0.0 0 #f))
  (define value
    (parameterize ([current-integral iterated?]) (integral-not-heard t f low high)))
  (define nothing-seen?
    (and (not around) (task-met t) (eqv? value 0.0) (eqv? (task-bound t) 0.0) (> (task-count t) 0)))
  (when nothing-seen? (note-with-result (format nothing-seen who)))
  (report value (if nothing-seen? +inf.0 (task-bound t)) (task-count t)))

(define nothing-seen
  (string-append "~a: the integrand was 0 at all points where it was looked at;\n"
                 "  of a peak between them, ends next to it give the integral"))

;; A listener to branches is told of those at the ends alone.
(define (integral-not-heard t f low high)
  (tell-choices-at-ends f (innermost low) (innermost high))
  (parameterize ([current-branches #f]) (integral t f low high)))

(define (integral t f low high)
  (define (end x) (number (task-who t) x))
  (define (edge-at limit) (edge f limit 0.0))
  (between-numbers low high edge-at edge-at
                   (lambda (low high) (integral-between t f (end low) (end high)))))

;; The integral between limits that may be perturbed, from (integral low high) between numbers
;; and the part due to the ε of either limit.
(define (between-numbers low high low-edge high-edge integral)
  (let between ([low low] [high high])
    (cond
      [(perturbed? low) (g:- (between (base low) high) (low-edge low))]
      [(perturbed? high) (g:+ (between low (base high)) (high-edge high))]
      [else (integral low high)])))

(define (base limit) ((parts-value (parts-of limit)) limit))

;; The part of the integral due to the ε of a limit b + δ: Σ f⁽ᵐ⁾(b) δᵐ⁺¹/(m+1)!, where δ to the
;; power of the order is the last that does not vanish.
;; aside : a number added to b for f to take the branch of the piece that ends there
(define (edge f limit aside)
  (define b (base limit))
  (define δ (g:- limit b))
  (define slopes (slopes-beside f b aside (if (jet? limit) (sub1 (jet-order limit)) 0)))
  (for/fold ([sum 0] [term 1] #:result sum) ([slope (in-list slopes)] [m (in-naturals 1)])
    (define next (g:/ (g:* term δ) m))
    (values (g:+ sum (g:* slope next)) next)))

;; f and its derivatives at b, from beside it: where f goes as a + c √|x − b|, as an integral
;; does from whose range a curve leaves, a is twice its value there less that at four times the
;; distance.
(define (slopes-beside f b aside order)
  (define (at distance) (derivatives-at f (g:+ b distance) order))
  (if (= aside 0.0)
      (at aside)
      (for/list ([near (in-list (at aside))] [far (in-list (at (* 4.0 aside)))])
        (g:- (g:* 2 near) far))))

;; Between numbers.  Where f turns out to be perturbed, or to choose a branch by perturbed values,
;; its parts are integrated one after the other, in pieces.
(define (integral-between t f low high)
  (define (whole-piece note) (piece-between t f low high note))
  (define result
    (let/ec branching
      (whole-piece (lambda (value made between) (branching #f)))))
  (or result
      (let ([places (moving-places (task-who t) f low high)])
        (if (null? places)
            (whole-piece void)
            (sum-of-pieces t f (append (list low) places (list high)))))))

;; A short piece needs less relative precision, and allows no more: its ends are rounded.
(define (sum-of-pieces t f ends)
  (define whole (abs (- (innermost (last ends)) (innermost (first ends)))))
  (g:for/sum ([from (in-list ends)] [to (in-list (cdr ends))])
    (define-values (a b) (values (innermost from) (innermost to)))
    (define part (/ (abs (- b a)) whole))
    (define tolerance
      (if (< 0.0 part 1.0)
          (min 1.0 (/ (task-tolerance t) part))
          (task-tolerance t)))
    (moving-piece t f from to (max tolerance (task-tolerance t)))))

(define (moving-piece t f low high tolerance)
  (define-values (a b) (values (innermost low) (innermost high)))
  (between-numbers low high
                   (lambda (low) (edge f low (aside f a b)))
                   (lambda (high) (edge f high (aside f b a)))
                   (lambda (low high)
                     (if (< (abs (- b a)) (* negligible (+ 1.0 (min (abs a) (abs b)))))
                         0
                         (piece-between t f low high void tolerance)))))

(define negligible 1e-13)

;; note : called with the branches that f takes by perturbed values
(define (piece-between t f low high note [tolerance (task-tolerance t)])
  (define (integral-of g) (piece-between t g low high note tolerance))
  (define result
    (let/ec stop
      (define (sample x)
        (define y (f x))
        (unless (eqv? y 0) (set-task-met! t #t))
        (cond [(real? y) y]
              [(perturbed? y) (stop y)]
              [else (number (task-who t) y)]))
      (define-values (value bound)
        (parameterize ([current-branches note])
          (improper-quadrature (counted t (impatient t f sample)) low high
                               #:search? (task-search? t) #:peaks (lambda () (peak-places f))
                               #:tolerance tolerance #:name (task-who t))))
      (set-task-bound! t (+ bound (task-bound t)))
      value))
  (if (perturbed? result) (integral-by-components integral-of f result) result))

(define ((counted t f) x)
  (set-task-count! t (+ 1 (task-count t)))
  (f x))

;; The number of evaluations after which a function is compiled: that takes as long as some
;; hundred evaluations by the generic arithmetic, and most integrals need fewer.
(define patience 500)

;; The compiled function serves where it gives a number; elsewhere `sample` names the
;; fault.
(define (impatient t f sample)
  (define evaluations 0)
  (define fast #f)
  (lambda (x)
    (set! evaluations (+ evaluations 1))
    (when (= evaluations patience) (set! fast ((task-compile t) f x)))
    (define y (and fast (fast x)))
    (if (and y (< -inf.0 y +inf.0)) y (sample x))))

;; The integral of f from those of its components, where f is perturbed as its value y is.
(define (integral-by-components integral f y)
  (if (recorded? y)
      (integral-recorded integral f (recorded-tape y))
      (integral-by-parts integral f (perturbed-tag y) (and (jet? y) (jet-order y)))))

;; The derivatives by all variables of the tape come from the same runs of f.
(define (integral-recorded integral f tape)
  (define runs (make-hasheqv))          ; x -> value there, and its derivatives
  (define (run x)
    (or (hash-ref runs x #f)
        (let ([r (call-with-values (lambda () (value-and-derivatives tape (f x))) cons)])
          (hash-set! runs x r)
          r)))
  (define value (integral (lambda (x) (car (run x)))))
  (for/fold ([sum value]) ([i (in-range (tape-inputs tape))])
    (define slope (integral (lambda (x) (vector-ref (cdr (run x)) i))))
    (g:+ sum (g:* slope (record-input tape i 0)))))

;; order : of a jet, #f for a dual number
(define (integral-by-parts integral f tag order)
  (define ε (if order (displaced tag order 0) (perturb tag 0)))
  (g:for/sum ([k (in-range (add1 (or order 1)))])
    (define part (integral (lambda (x) (coefficient-part (f x) tag k))))
    (if (eqv? k 0) part (g:* part (g:expt ε k)))))

;; The coefficient of εᵏ in x, for the ε of this tag.
(define (coefficient-part x tag k)
  (define (from x)
    (cond [(not (perturbed? x)) (if (eqv? k 0) x 0)]
          [(not (eqv? (perturbed-tag x) tag)) ((parts-map (parts-of x)) from x)]
          [(jet? x) (jet-coefficient x k)]
          [(eqv? k 0) (primal-part x tag)]
          [else (tangent-part x tag)]))
  (from x))
