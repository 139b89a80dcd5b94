#lang racket/base
;; Trees as TeX: formulas for LaTeX's mathematics mode, with amsmath.
;;
;; Whatever a name is made of, it comes out as its characters: see TeX-text.rkt.

(require "TeX-text.rkt"
         "../../algebra/notation/name.rkt" "../../algebra/notation/tree.rkt"
         (only-in racket/string string-join))

(provide tree->TeX)

(define (tree->TeX t)
  (cond [(name? t) (name->TeX (name-parts (name-symbol t)))]
        [(word? t) (word->TeX (word-text t))]
        [(digits? t) (digits-text t)]
        [(sum? t) (sum->TeX t)]
        [(product? t) (string-join (map tree->TeX (product-factors t)) "\\,")]
        [(fraction? t) (command "frac" (fraction-numerator t) (fraction-denominator t))]
        [(power? t) (string-append (tree->TeX (power-base t)) (raised (power-exponent t)))]
        [(parenthesized? t) (fenced "(" (tree->TeX (parenthesized-body t)) ")")]
        [(application? t) (application->TeX t)]
        [(derivative? t) (derivative->TeX t)]
        [else (other->TeX t)]))

(define (other->TeX t)
  (cond [(scientific? t) (format "~a\\times 10^{~a}" (scientific-digits t) (scientific-exponent t))]
        [(imaginary? t) (imaginary->TeX (imaginary-coefficient t))]
        [(radical? t) (command "sqrt" (radical-body t))]
        [(exponential? t) (string-append "\\mathrm{e}" (raised (exponential-exponent t)))]
        [(bars? t) (fenced "\\lvert " (tree->TeX (bars-body t)) "\\rvert ")]
        [(dotted? t) (name->TeX (dotted-parts (name-symbol (dotted-base t)) (dotted-dots t)))]
        [(row? t) (apply string-append (map tree->TeX (row-items t)))]
        [(relation? t) (string-append (tree->TeX (relation-left t))
                                      (sign->TeX (relation-sign t))
                                      (tree->TeX (relation-right t)))]
        [(plain? t) (typewriter (plain-text t))]
        [(omitted? t) (command "text" (plain (omitted-count t)))]
        [else (container->TeX t)]))

;; ---------------------------------------------------------------------------
;; Names

(define (name->TeX p)
  (define base
    (case (parts-sort p)
      [(letter capital word) (letters->TeX (parts-base p))]
      [else (upright (parts-base p))]))
  (string-append (with-dots base (parts-dots p))
                 (index "_" (map letters->TeX (subscripts p)))
                 (index "^" (map letters->TeX (superscripts p)))))

(define (index sign texts)
  (if (null? texts) "" (format "~a{~a}" sign (string-join texts ","))))

(define (with-dots base n)
  (case n
    [(0) base]
    [(1) (format "\\dot{~a}" base)]
    [(2) (format "\\ddot{~a}" base)]
    [else (format "\\dddot{~a}" base)]))

;; ---------------------------------------------------------------------------
;; Formulas

(define (command name . ts)
  (apply string-append "\\" name
         (for/list ([t (in-list ts)])
           (format "{~a}" (if (plain? t) (escaped (plain-text t)) (tree->TeX t))))))

(define (raised t) (format "^{~a}" (tree->TeX t)))

;; Around what is no taller than a letter they need not stretch, and keep to their distance.
(define (fenced open body close)
  (if (regexp-match? #rx"frac|sqrt|begin|left|ddot|[|]" body)
      (format "\\left~a~a\\right~a" open body close)
      (string-append open body close)))

(define (sum->TeX t)
  (define terms (sum-terms t))
  (apply string-append
         (if (term-negative? (car terms)) "-" "")
         (tree->TeX (term-body (car terms)))
         (for/list ([x (in-list (cdr terms))])
           (string-append (if (term-negative? x) " - " " + ") (tree->TeX (term-body x))))))

(define (imaginary->TeX coefficient)
  (string-append (cond [(equal? coefficient (digits "1")) ""]
                       [else (string-append (tree->TeX coefficient) "\\,")])
                 "\\mathrm{i}"))

(define (application->TeX t)
  (define f (application-function t))
  (define head (if (power? f)
                   (string-append (function->TeX (power-base f)) (raised (power-exponent f)))
                   (function->TeX f)))
  (define arguments (string-join (map tree->TeX (application-arguments t)) ",\\, "))
  (cond [(application-bare? t) (format "~a{~a}" head arguments)]
        [(fenced-itself? (application-arguments t)) (string-append head arguments)]
        [else (string-append head (fenced "(" arguments ")"))]))

(define (function->TeX f)
  (cond [(not (word? f)) (tree->TeX f)]
        [(member (word-text f) known-to-TeX) (string-append "\\" (word-text f))]
        [else (format "\\operatorname{~a}" (word-text f))]))

(define known-to-TeX
  '("sin" "cos" "tan" "sec" "csc" "cot" "sinh" "cosh" "tanh" "coth" "log"))

(define (derivative->TeX t)
  (string-append (apply string-append (map mark->TeX (derivative-marks t)))
                 (if (derivative-function t)
                     (string-append " " (tree->TeX (derivative-function t)))
                     "")))

(define (mark->TeX m)
  (string-append (if (mark-path m)
                     (format "\\partial_{~a}" (string-join (map number->string (mark-path m)) ","))
                     "D")
                 (if (= 1 (mark-count m)) "" (format "^{~a}" (mark-count m)))))

;; ---------------------------------------------------------------------------
;; Containers and statements

(define (container->TeX t)
  (cond [(column? t) (array "(" (map list (column-items t)) ")" "")]
        [(across? t) (array "[" (list (across-items t)) "]" ",")]
        [(grid? t) (array "[" (grid-rows t) "]" "")]
        [(listing? t) (if (of-reports? t)
                          (stacked (map tree->TeX (listing-items t)))
                          (string-join (map tree->TeX (listing-items t)) ",\\quad "))]
        [(broken? t) (format "\\begin{aligned}~a\\end{aligned}"
                             (string-join (for/list ([l (in-list (broken-lines t))])
                                            (string-append "&" (tree->TeX l)))
                                          "\\\\"))]
        [(continuation? t) (string-append "\\quad{}" (sign->TeX (continuation-sign t)) "{}"
                                          (tree->TeX (continuation-body t)))]
        [(report? t) (stacked (map report-line->TeX (report-lines t)))]
        [else (typewriter (format "~s" t))]))

;; rows of trees between brackets, the columns parted by a sign
(define (array open rows close sign)
  (define columns (if (null? rows) 1 (max 1 (length (car rows)))))
  (define body
    (string-join (for/list ([row (in-list rows)])
                   (string-join (map tree->TeX row) (string-append sign " & ")))
                 " \\\\ "))
  (fenced open
          (format "\\begin{array}{~a}~a\\end{array}" (make-string columns #\c) body)
          close))

(define (stacked lines) (format "\\begin{array}{l}~a\\end{array}" (string-join lines "\\\\")))

(define (report-line->TeX l)
  (string-append (format "\\hspace{~aem}" (* 2 (report-line-depth l)))
                 (if (unlabelled? l) "" (upright (report-line-label l)))
                 (apply string-append
                        (for/list ([p (in-list (report-line-parts l))])
                          (string-append (if (unlabelled? l) "" "\\ ")
                                         "\\displaystyle " (tree->TeX p))))))
