#lang racket/base
;; A tree on one line: ½ m ẋ² − m g x, (a + b)/(2 c), D²x(t), up(r, φ).
;;
;; What a fraction bar or a raised exponent would hold together is put between parentheses, so
;; that read-infix.rkt reads from the line what was written.  A product is written with spaces,
;; an application without; a quotient holds all that stands before the slash in its product,
;; and one factor behind it.

(require "line-name.rkt" "tree.rkt"
         (only-in racket/string string-join))

(provide tree->line)

(define (tree->line tree)
  (define spell (speller tree))
  (line tree (speaker spell #f)))

;; spell : symbol -> text; beside-slash? : is it written next to the slash of a quotient, where
;; sin x would seem to go on?
(struct speaker (spell beside-slash?) #:authentic)

(define (at-slash s) (speaker (speaker-spell s) #t))
(define (apart s) (speaker (speaker-spell s) #f))

(define (line t s)
  (cond [(name? t) ((speaker-spell s) (name-symbol t))]
        [(word? t) (word-text t)]
        [(digits? t) (digits-text t)]
        [(plain? t) (plain-text t)]
        [(sum? t) (sum-line t (apart s))]
        [(product? t) (spaced (for/list ([f (in-list (product-factors t))]) (factor f s)))]
        [(fraction? t) (or (small-fraction t) (quotient-line t (at-slash s)))]
        [(power? t) (power-line t s)]
        [(parenthesized? t) (within (parenthesized-body t) s)]
        [(application? t) (application-line t s)]
        [(derivative? t) (derivative-line t s)]
        [else (other-line t (apart s))]))

(define (other-line t s)
  (cond [(scientific? t) (string-append (scientific-digits t) "×10"
                                        (raised-text (number->string (scientific-exponent t))))]
        [(imaginary? t) (string-append (atom (imaginary-coefficient t) s) "i")]
        [(radical? t) (string-append "√" (under-roof (radical-body t) s))]
        [(exponential? t) (call "exp" (list (exponential-exponent t)) s)]
        [(bars? t) (call "abs" (list (bars-body t)) s)]
        [(dotted? t) (dotted-line t s)]
        [(column? t) (call "up" (column-items t) s)]
        [(across? t) (call "down" (across-items t) s)]
        [(grid? t) (grid-line t s)]
        [(listing? t) (call "list" (listing-items t) s)]
        [(relation? t) (relation-line t s)]
        [(omitted? t) (omitted-count t)]
        [(row? t) (apply string-append (lines (row-items t) s))]
        [(report? t) (report->line t s)]
        [else (string-join (lines (tree-parts t) s))]))

(define (lines ts s) (for/list ([t (in-list ts)]) (line t s)))
(define (spaced texts) (string-join texts " "))
(define (within t s) (string-append "(" (line t (apart s)) ")"))
(define (call f ts s) (string-append f "(" (string-join (lines ts (apart s)) ", ") ")"))

;; ---------------------------------------------------------------------------

(define (sum-line t s)
  (define terms (sum-terms t))
  (define (signed x positive negative)
    (string-append (if (term-negative? x) negative positive) (line (term-body x) s)))
  (apply string-append
         (signed (car terms) "" "−")
         (for/list ([x (in-list (cdr terms))]) (signed x " + " " − "))))

(define (factor t s)
  (if (and (fraction? t) (not (small-fraction t))) (within t s) (line t s)))

(define (small-fraction t)
  (define above (fraction-numerator t))
  (define below (fraction-denominator t))
  (and (digits? above)
       (digits? below)
       (hash-ref small-fractions (string-append (digits-text above) "/" (digits-text below)) #f)))

(define small-fractions
  (hash "1/2" "½" "1/3" "⅓" "2/3" "⅔" "1/4" "¼" "3/4" "¾" "1/5" "⅕" "2/5" "⅖" "3/5" "⅗"
        "4/5" "⅘" "1/6" "⅙" "5/6" "⅚" "1/8" "⅛" "3/8" "⅜" "5/8" "⅝" "7/8" "⅞"))

(define (quotient-line t s)
  (define above (fraction-numerator t))
  (string-append (if (product? above) (line above s) (atom above s))
                 "/"
                 (atom (fraction-denominator t) s)))

;; What holds together beside a slash.
(define (atom t s)
  (if (or (sum? t) (product? t) (relation? t) (imaginary? t) (omitted? t)
          (and (fraction? t) (not (small-fraction t))))
      (within t s)
      (line t s)))

(define (power-line t s)
  (define exponent (power-exponent t))
  (string-append (atom (power-base t) s)
                 (if (and (digits? exponent) (regexp-match? #rx"^[0-9]+$" (digits-text exponent)))
                     (raised-text (digits-text exponent))
                     (string-append "^" (within exponent s)))))

(define (under-roof t s)
  (if (or (name? t) (digits? t) (parenthesized? t)) (line t s) (within t s)))

(define (application-line t s)
  (define head (line (application-function t) s))
  (if (and (application-bare? t) (not (speaker-beside-slash? s)))
      (spaced (list head (line (car (application-arguments t)) s)))
      (call head (application-arguments t) s)))

(define (derivative-line t s)
  (string-append (apply string-append (map mark-line (derivative-marks t)))
                 (if (derivative-function t) (line (derivative-function t) (apart s)) "")))

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
(define (dotted-line t s)
  (define base (dotted-base t))
  (define n (dotted-dots t))
  (if (regexp-match? #rx"^[|]" (line base s))
      (derivative-line (derivative (list (mark #f n)) base) s)
      (dotted-line-name (name-symbol base) n)))

(define (grid-line t s)
  (string-append "["
                 (string-join (for/list ([row (in-list (grid-rows t))])
                                (string-join (lines row s) ", "))
                              "; ")
                 "]"))

(define (relation-line t s)
  (define right (relation-right t))
  (spaced (list (line (relation-left t) s)
                (relation-sign t)
                (if (relation? right) (within right s) (line right s)))))

(define (report->line t s)
  (string-join (for/list ([l (in-list (report-lines t))])
                 (define texts (lines (report-line-parts l) s))
                 (spaced (if (unlabelled? l) texts (cons (report-line-label l) texts))))
               "; "))
