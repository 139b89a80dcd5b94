#lang racket/base
;; Trees as text in two dimensions: fractions with their bars, roots with their roofs.

(require "text-box.rkt" "visible.rkt"
         "../../algebra/notation/infix.rkt" "../../algebra/notation/line-name.rkt"
         "../../algebra/notation/tree.rkt"
         (only-in racket/list add-between append-map))

(provide tree->text)

(define (tree->text t) (box-text (draw t)))

(define (draw t)
  (cond [(or (digits? t) (scientific? t) (imaginary? t) (derivative-operator? t)
             (omitted? t) (dotted? t))
         (text-box (tree->line t))]
        [(name? t) (text-box (shown-name (name-symbol t)))]
        [(word? t) (text-box (visible (word-text t)))]
        [(plain? t) (text-box (visible (plain-text t)))]
        [(sum? t) (draw-sum t)]
        [(product? t) (apply beside (add-between (map draw (product-factors t)) (text-box " ")))]
        [(fraction? t) (draw-fraction t)]
        [(power? t) (draw-power t)]
        [(parenthesized? t) (fence (draw (parenthesized-body t)) "(" ")")]
        [(application? t) (draw-application t)]
        [else (draw-other t)]))

(define (derivative-operator? t) (and (derivative? t) (not (derivative-function t))))

(define (draw-other t)
  (cond [(derivative? t) (beside (text-box (tree->line (derivative (derivative-marks t) #f)))
                                 (draw (derivative-function t)))]
        [(radical? t) (draw-radical (radical-body t))]
        [(exponential? t) (raised (text-box "e") (draw (exponential-exponent t)))]
        [(bars? t) (fence (draw (bars-body t)) "|" "|")]
        [(row? t) (apply beside (map draw (row-items t)))]
        [(relation? t) (beside (draw (relation-left t))
                               (text-box (format " ~a " (relation-sign t)))
                               (draw (relation-right t)))]
        [else (draw-container t)]))

;; ---------------------------------------------------------------------------
;; Names

(define (shown-name s)
  (define text (line-name s))
  (if (regexp-match? #rx"^[|]" text) (visible (symbol->string s)) text))

;; ---------------------------------------------------------------------------
;; Formulas

(define (draw-sum t)
  (define terms (sum-terms t))
  (apply beside
         (text-box (if (term-negative? (car terms)) "−" ""))
         (draw (term-body (car terms)))
         (append-map (lambda (x) (list (text-box (if (term-negative? x) " − " " + "))
                                       (draw (term-body x))))
                     (cdr terms))))

;; ½ where there is a character for it
(define (draw-fraction t)
  (define line (and (digits? (fraction-numerator t)) (tree->line t)))
  (cond [(and line (= 1 (string-length line))) (text-box line)]
        [else
         (define above (draw (fraction-numerator t)))
         (define below (draw (fraction-denominator t)))
         (define width (+ 2 (max (box2-width above) (box2-width below))))
         (stack (list above (text-box (make-string width #\─)) below) 'center
                (box-height above))]))

(define (draw-power t)
  (define exponent (power-exponent t))
  (define base (draw (power-base t)))
  (if (and (digits? exponent) (regexp-match? #rx"^[0-9]+$" (digits-text exponent)))
      (beside base (raise-to-top (text-box (raised-text (digits-text exponent))) base))
      (raised base (draw exponent))))

;; An exponent of one line at the top line of the base.
(define (raise-to-top exponent base) (raise-box exponent (box2-base base)))

(define (raised base exponent)
  (beside base (raise-box exponent (add1 (box2-base base)))))

(define (draw-radical t)
  (define body (draw t))
  (if (and (= 1 (box-height body)) (or (name? t) (digits? t)))
      (beside (text-box "√") body)
      (with-roof body)))

(define (draw-application t)
  (define arguments (application-arguments t))
  (define within (apply beside (add-between (map draw arguments) (text-box ", "))))
  (beside (draw (application-function t))
          (cond [(application-bare? t) (beside (text-box " ") within)]
                [(fenced-itself? arguments) within]
                [else (fence within "(" ")")])))

;; ---------------------------------------------------------------------------
;; Containers and statements

(define (draw-container t)
  (cond [(column? t) (fence (stack (spread (map draw (column-items t))) 'center) "(" ")")]
        [(across? t) (fence (with-commas (across-items t)) "[" "]")]
        [(grid? t) (fence (draw-grid (grid-rows t)) "[" "]")]
        [(listing? t) (if (of-reports? t)
                          (stack (map draw (listing-items t)) 'left 0)
                          (with-commas (listing-items t)))]
        [(broken? t) (stack (spread (map draw (broken-lines t))) 'left)]
        [(continuation? t) (beside (text-box (format "  ~a " (continuation-sign t)))
                                   (draw (continuation-body t)))]
        [(report? t) (draw-report (map draw-line (report-lines t)))]
        [else (text-box (visible (format "~s" t)))]))

(define (with-commas items)
  (apply beside (add-between (map draw items) (text-box ", "))))

;; A blank line between two of which one is taller than a line.
(define (spread boxes)
  (define (tall? b) (> (box-height b) 1))
  (for/fold ([spread '()] #:result (reverse spread)) ([b (in-list boxes)])
    (if (and (pair? spread) (or (tall? b) (tall? (car spread))))
        (list* b (text-box "") spread)
        (cons b spread))))

(define (draw-grid rows)
  (define cells (for/list ([row (in-list rows)]) (map draw row)))
  (define widths
    (for/list ([c (in-list (apply map list cells))]) (apply max (map box2-width c))))
  (stack (spread (for/list ([row (in-list cells)])
                   (apply beside (add-between (map centered row widths) (text-box "  ")))))
         'left))

(define (centered b width)
  (define free (- width (box2-width b)))
  (define left (quotient free 2))
  (beside (text-box (make-string left #\space)) b (text-box (make-string (- free left) #\space))))

;; The first line stands level with what is beside the report.
(define (draw-report lines)
  (stack lines 'left (if (null? lines) 0 (box2-base (car lines)))))

(define (draw-line l)
  (apply beside
         (text-box (make-string (* 2 (report-line-depth l)) #\space))
         (text-box (visible (report-line-label l)))
         (append-map (lambda (p) (list (text-box (if (unlabelled? l) "" " ")) (draw p)))
                     (report-line-parts l))))
