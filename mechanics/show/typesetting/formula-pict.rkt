#lang racket/base
;; Trees as picts: names in italics, functions upright, fractions on the axis of the line.
;;
;; Every pict made here has its base line at its descent, so that picts put beside one
;; another by `hbl-append` stand level.

(require (only-in pict colorize hbl-append)
         "pict-glyphs.rkt" "pict-parts.rkt" "visible.rkt"
         "../../algebra/notation/name.rkt" "../../algebra/notation/tree.rkt"
         (only-in racket/list add-between append-map)
         (only-in racket/string string-join))

(provide tree->pict)

;; size : of letters, in units of the drawing; color : a color's name, or #f for that of the
;; text around
(define (tree->pict t size color)
  (define drawn (draw t (make-glyphs size)))
  (if color (colorize drawn color) drawn))

(define (draw t g)
  (cond [(name? t) (draw-name (name-parts (name-symbol t)) g)]
        [(word? t) (upright g (visible (word-text t)))]
        [(digits? t) (upright g (digits-text t))]
        [(sum? t) (draw-sum t g)]
        [(product? t) (apply hbl-append (factor-space t g) (draw-all (product-factors t) g))]
        [(fraction? t) (over g (draw (fraction-numerator t) g) (draw (fraction-denominator t) g))]
        [(power? t) (with-exponent g (draw (power-base t) g)
                      (draw (power-exponent t) (smaller g)))]
        [(parenthesized? t) (fenced g "(" (draw (parenthesized-body t) g) ")")]
        [(application? t) (draw-application t g)]
        [(derivative? t) (draw-derivative t g)]
        [else (draw-other t g)]))

;; Words need more room between them than letters.
(define (factor-space t g)
  (define (long? f) (and (name? f) (eq? 'word (parts-sort (name-parts (name-symbol f))))))
  (if (ormap long? (product-factors t)) (* 2 (thin-space g)) (thin-space g)))

(define (draw-all ts g) (for/list ([t (in-list ts)]) (draw t g)))

(define (draw-other t g)
  (cond [(scientific? t)
         (hbl-append (upright g (format "~a × 10" (scientific-digits t)))
                     (raised g (upright (smaller g) (minus-sign (scientific-exponent t)))))]
        [(imaginary? t) (draw-imaginary (imaginary-coefficient t) g)]
        [(radical? t) (under-root g (draw (radical-body t) g))]
        [(exponential? t) (with-exponent g (upright g "e")
                            (draw (exponential-exponent t) (smaller g)))]
        [(bars? t) (fenced g "|" (draw (bars-body t) g) "|")]
        [(dotted? t) (draw-name (dotted-parts (name-symbol (dotted-base t)) (dotted-dots t)) g)]
        [(row? t) (apply hbl-append (draw-all (row-items t) g))]
        [(relation? t) (hbl-append (draw (relation-left t) g)
                                   (spaced-sign g (relation-sign t))
                                   (draw (relation-right t) g))]
        [(plain? t) (typewriter g (visible (plain-text t)))]
        [(omitted? t) (upright g (visible (omitted-count t)))]
        [else (draw-container t g)]))

(define (minus-sign n) (regexp-replace #rx"-" (number->string n) "−"))

;; ---------------------------------------------------------------------------
;; Names

(define (draw-name p g)
  (define letters
    (if (memq (parts-sort p) '(letter word))
        (italic g (parts-base p))
        (upright g (visible (parts-base p)))))
  (define base (with-dots g letters (parts-dots p) #:tall? (tall-letter? p)))
  (with-indices g base (index (subscripts p) g) (index (superscripts p) g)))

(define (tall-letter? p)
  (regexp-match? #px"^(?:\\p{Lu}|[bdfhikltjβδζθλξϕψ])" (parts-base p)))

;; -> a pict, or #f
(define (index texts g)
  (and (pair? texts)
       (let ([small (smaller g)] [text (string-join texts ",")])
         (if (regexp-match? #px"^[0-9,]+$" text) (upright small text) (italic small text)))))

;; ---------------------------------------------------------------------------
;; Formulas

(define (draw-sum t g)
  (define terms (sum-terms t))
  (define (sign x) (if (term-negative? x) "−" "+"))
  (apply hbl-append
         (append (if (term-negative? (car terms)) (list (upright g "−")) '())
                 (list (draw (term-body (car terms)) g))
                 (append-map (lambda (x) (list (spaced-sign g (sign x)) (draw (term-body x) g)))
                             (cdr terms)))))

(define (draw-imaginary coefficient g)
  (if (equal? coefficient (digits "1"))
      (upright g "i")
      (hbl-append (thin-space g) (draw coefficient g) (upright g "i"))))

(define (draw-application t g)
  (define f (application-function t))
  (define arguments (application-arguments t))
  (define within (with-commas arguments g))
  (define head (draw f g))
  (cond [(application-bare? t) (hbl-append (thin-space g) head within)]
        [(fenced-itself? arguments) (hbl-append head within)]
        [else (hbl-append head (fenced g "(" within ")"))]))

(define (with-commas ts g)
  (apply hbl-append (add-between (draw-all ts g) (upright g ", "))))

(define (draw-derivative t g)
  (apply hbl-append
         (append (for/list ([m (in-list (derivative-marks t))]) (draw-mark m g))
                 (if (derivative-function t) (list (draw (derivative-function t) g)) '()))))

(define (draw-mark m g)
  (define path (mark-path m))
  (define count (if (= 1 (mark-count m)) '() (list (number->string (mark-count m)))))
  (with-indices g (if path (upright g "∂") (italic g "D"))
    (index (if path (map number->string path) '()) g)
    (index count g)))

;; ---------------------------------------------------------------------------
;; Containers and statements

(define (draw-container t g)
  (cond [(column? t) (fenced g "(" (rows g (map list (draw-all (column-items t) g)) 'center) ")")]
        [(across? t) (fenced g "[" (with-commas (across-items t) g) "]")]
        [(grid? t) (fenced g "[" (rows g (for/list ([r (in-list (grid-rows t))]) (draw-all r g))
                                       'center)
                           "]")]
        [(listing? t) (if (of-reports? t)
                          (lines g (draw-all (listing-items t) g))
                          (with-commas (listing-items t) g))]
        [(broken? t) (lines g (draw-all (broken-lines t) g))]
        [(continuation? t) (hbl-append (indentation g 1) (spaced-sign g (continuation-sign t))
                                       (draw (continuation-body t) g))]
        [(report? t) (lines g (for/list ([l (in-list (report-lines t))]) (draw-line l g)))]
        [else (typewriter g (visible (format "~s" t)))]))

(define (draw-line l g)
  (apply hbl-append
         (indentation g (* 2 (report-line-depth l)))
         (upright g (visible (report-line-label l)))
         (append-map (lambda (p) (list (upright g (if (unlabelled? l) "" " ")) (draw p g)))
                     (report-line-parts l))))
