#lang racket/base
;; A tree on one line: ½ m ẋ² − m g x, (a + b)/(2 c), D²x(t), up(r, φ).
;;
;; Parentheses replace the grouping of a fraction bar or a raised exponent, so
;; that read-infix.rkt reads from the line the tree written.  A product is written with spaces,
;; an application without; a quotient holds all that stands before the slash in its product,
;; and one factor behind it.

(require "one-line-name.rkt" "tree.rkt"
         (only-in racket/string string-join))

(provide tree->line)

(define (tree->line tree) (line tree))

;; slash? : is it written next to the slash of a quotient, where sin x would seem to go on?
(define (line t [slash? #f])
  (cond [(name? t) (line-name (name-symbol t))]
        [(word? t) (word-text t)]
        [(digits? t) (digits-text t)]
        [(plain? t) (plain-text t)]
        [(sum? t) (sum-line t)]
        [(product? t) (spaced (for/list ([f (in-list (product-factors t))]) (factor f slash?)))]
        [(fraction? t) (or (small-fraction t) (quotient-line t))]
        [(power? t) (power-line t slash?)]
        [(parenthesized? t) (within (parenthesized-body t))]
        [(application? t) (application-line t slash?)]
        [(derivative? t) (derivative-line t)]
        [else (other-line t)]))

(define (other-line t)
  (cond [(scientific? t) (string-append (scientific-digits t) "×10"
                                        (raised-text (number->string (scientific-exponent t))))]
        [(imaginary? t) (string-append (atom (imaginary-coefficient t)) "i")]
        [(radical? t) (string-append "√" (under-roof (radical-body t)))]
        [(exponential? t) (call "exp" (list (exponential-exponent t)))]
        [(bars? t) (call "abs" (list (bars-body t)))]
        [(dotted? t) (dotted-line t)]
        [(column? t) (call "up" (column-items t))]
        [(across? t) (call "down" (across-items t))]
        [(grid? t) (grid-line t)]
        [(listing? t) (call "list" (listing-items t))]
        [(relation? t) (relation-line t)]
        [(omitted? t) (omitted-count t)]
        [(row? t) (apply string-append (lines (row-items t)))]
        [(report? t) (report->line t)]
        [else (string-join (lines (tree-parts t)))]))

(define (lines ts) (map line ts))
(define (spaced texts) (string-join texts " "))
(define (within t) (string-append "(" (line t) ")"))
(define (call f ts) (string-append f "(" (string-join (lines ts) ", ") ")"))

;; ---------------------------------------------------------------------------

(define (sum-line t)
  (define terms (sum-terms t))
  (define (signed x positive negative)
    (string-append (if (term-negative? x) negative positive) (line (term-body x))))
  (apply string-append
         (signed (car terms) "" "−")
         (for/list ([x (in-list (cdr terms))]) (signed x " + " " − "))))

(define (factor t slash?)
  (if (and (fraction? t) (not (small-fraction t))) (within t) (line t slash?)))

(define (small-fraction t)
  (define above (fraction-numerator t))
  (define below (fraction-denominator t))
  (and (digits? above)
       (digits? below)
       (quotient->small-fraction (string-append (digits-text above) "/" (digits-text below)))))

(define (quotient-line t)
  (define above (fraction-numerator t))
  (string-append (if (product? above) (line above #t) (atom above #t))
                 "/"
                 (atom (fraction-denominator t) #t)))

;; t as an operand of a slash, in parentheses if the slash would take it apart.
(define (atom t [slash? #f])
  (if (or (sum? t) (product? t) (relation? t) (imaginary? t) (omitted? t)
          (and (fraction? t) (not (small-fraction t))))
      (within t)
      (line t slash?)))

(define (power-line t slash?)
  (define exponent (power-exponent t))
  (string-append (atom (power-base t) slash?)
                 (if (and (digits? exponent) (regexp-match? #rx"^[0-9]+$" (digits-text exponent)))
                     (raised-text (digits-text exponent))
                     (string-append "^" (within exponent)))))

(define (under-roof t)
  (if (or (name? t) (digits? t) (parenthesized? t)) (line t) (within t)))

(define (application-line t slash?)
  (define head (line (application-function t) slash?))
  (if (and (application-bare? t) (not slash?))
      (spaced (list head (line (car (application-arguments t)) slash?)))
      (call head (application-arguments t))))

(define (derivative-line t)
  (string-append (apply string-append (map mark-line (derivative-marks t)))
                 (if (derivative-function t) (line (derivative-function t)) "")))

(define (mark-line m)
  (string-append (if (mark-path m) (partial-line (mark-path m)) "D")
                 (if (= 1 (mark-count m)) "" (raised-text (number->string (mark-count m))))))

(define (partial-line path)
  (if (null? (cdr path))
      (string-append "∂" (lowered-number (car path)))
      (format "∂_(~a)" (string-join (map number->string path) ","))))

(define (lowered-number n)
  (list->string (for/list ([c (in-string (number->string n))])
                  (integer->char (+ 8272 (char->integer c))))))

;; A name between bars has no letter to bear the dots.
(define (dotted-line t)
  (define base (dotted-base t))
  (define n (dotted-dots t))
  (if (regexp-match? #rx"^[|]" (line base))
      (derivative-line (derivative (list (mark #f n)) base))
      (dotted-line-name (name-symbol base) n)))

(define (grid-line t)
  (string-append "["
                 (string-join (for/list ([row (in-list (grid-rows t))])
                                (string-join (lines row) ", "))
                              "; ")
                 "]"))

(define (relation-line t)
  (define right (relation-right t))
  (spaced (list (line (relation-left t))
                (relation-sign t)
                (if (relation? right) (within right) (line right)))))

(define (report->line t)
  (string-join (for/list ([l (in-list (report-lines t))])
                 (define texts (lines (report-line-parts l)))
                 (spaced (if (unlabelled? l) texts (cons (report-line-label l) texts))))
               "; "))
