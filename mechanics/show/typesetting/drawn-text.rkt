#lang racket/base
;; Trees as text in two dimensions: fractions with their bars, roots with their roofs.

(require "renderer.rkt" "text-box.rkt" "visible.rkt"
         "../../algebra/notation/infix.rkt" "../../algebra/notation/one-line-name.rkt"
         "../../algebra/notation/tree.rkt"
         racket/class
         (only-in racket/list add-between))

(provide tree->text)

(define (tree->text t) (box-text (send (new text-renderer%) draw t)))

(define text-pieces%
  (class renderer%
    (super-new)
    (define/override (prose text) (text-box (visible text)))
    (define/override (verbatim text) (prose text))
    (define/override (number text) (text-box text))
    (define/override (roman text) (text-box text))
    (define/override (sign text form)
      (text-box (if (eq? form 'prefix) text (format " ~a " text))))
    (define/override (comma) (text-box ", "))
    (define/override (small-space) (indent 1))
    (define/override (indent n) (text-box (make-string n #\space)))
    (define/override (in-row boxes) (apply beside boxes))
    (define/override (in-table rows) (draw-table rows))
    (define/override (in-lines boxes sort)
      (case sort
        [(broken) (stack (spread boxes) 'left)]
        [(reports) (stack boxes 'left 0)]
        ;; The first line stands level with the text beside the report.
        [else (stack boxes 'left (if (null? boxes) 0 (box2-base (car boxes))))]))
    (define/override (divided above below)
      (define bar (make-string (+ 2 (max (box2-width above) (box2-width below))) #\─))
      (stack (list above (text-box bar) below) 'center (box-height above)))
    (define/override (superscripted base exponent)
      (beside base (raise-box exponent (add1 (box2-base base)))))
    (define/override (rooted body) (with-roof body))
    (define/override (enclosed open boxes close trees) (fence (apply beside boxes) open close))))

(define text-renderer%
  (class text-pieces%
    (super-new)
    (inherit draw)
    (define/override (draw-leaf t)
      (cond [(name? t) (text-box (shown-name (name-symbol t)))]
            [(dotted? t) (draw-dotted (dotted-base t) (dotted-dots t))]
            [else (text-box (tree->line t))]))
    (define/private (draw-dotted base dots)
      (define text (letters-of-name (name-symbol base) dots))
      (if text (text-box text) (draw-derivative (list (mark #f dots)) base)))
    (define/override (draw-derivative marks function)
      (define operator (text-box (tree->line (derivative marks #f))))
      (if function (beside operator (draw function)) operator))
    ;; ½ where there is a character for it
    (define/override (draw-fraction t)
      (define line (and (digits? (fraction-numerator t)) (tree->line t)))
      (if (and line (= 1 (string-length line))) (text-box line) (super draw-fraction t)))
    ;; Digits stand at the top line of the base.
    (define/override (draw-power base exponent)
      (if (and (digits? exponent) (regexp-match? #rx"^[0-9]+$" (digits-text exponent)))
          (beside base (raise-box (text-box (raised-text (digits-text exponent))) (box2-base base)))
          (super draw-power base exponent)))
    (define/override (draw-radical body)
      (define box (draw body))
      (if (and (= 1 (box-height box)) (or (name? body) (digits? body)))
          (beside (text-box "√") box)
          (with-roof box)))))

(define (shown-name s) (or (letters-of-name s 0) (visible (symbol->string s))))

;; ---------------------------------------------------------------------------
;; Tables

;; A blank line between two of which one is taller than a line.
(define (spread boxes)
  (define (tall? b) (> (box-height b) 1))
  (for/fold ([spread '()] #:result (reverse spread)) ([b (in-list boxes)])
    (if (and (pair? spread) (or (tall? b) (tall? (car spread))))
        (list* b (text-box "") spread)
        (cons b spread))))

(define (draw-table rows)
  (define columns (if (null? rows) '() (apply map list rows)))
  (define widths (for/list ([c (in-list columns)]) (apply max (map box2-width c))))
  (stack (spread (for/list ([row (in-list rows)])
                   (apply beside (add-between (map centered row widths) (text-box "  ")))))
         'left))

(define (centered b width)
  (define free (- width (box2-width b)))
  (define (blank n) (text-box (make-string n #\space)))
  (define left (quotient free 2))
  (beside (blank left) b (blank (- free left))))
