#lang racket/base
;; Trees as TeX: formulas for LaTeX's mathematics mode, with amsmath.
;;
;; A name of any characters comes out as these: see TeX-text.rkt.

(require "TeX-text.rkt" "renderer.rkt"
         "../../algebra/notation/name.rkt"
         "../../operation/operation-column.rkt"
         racket/class
         (only-in racket/string string-append* string-join))

(provide tree->TeX)

(define (tree->TeX t) (send (new TeX%) draw t))

(define TeX-pieces%
  (class typesetter%
    (super-new)
    (define/override (prose text) (word->TeX text))
    (define/override (verbatim text) (typewriter text))
    (define/override (number text) text)
    (define/override (roman text) (format "\\mathrm{~a}" text))
    (define/override (sign text form)
      (define shown (sign->TeX text))
      (if (eq? form 'infix) (string-append " " shown " ") shown))
    (define/override (comma) ",\\, ")
    (define/override (small-space) "\\,")
    (define/override (indent n) (format "\\hspace{~aem}" n))
    (define/override (in-row texts) (apply string-append texts))
    (define/override (in-table rows) (array rows ""))
    (define/override (in-lines texts sort)
      (if (eq? sort 'broken)
          (environment "aligned" "" (for/list ([t (in-list texts)]) (string-append "&" t)))
          (environment "array" "{l}" texts)))
    (define/override (divided above below) (string-append "\\frac{" above "}{" below "}"))
    (define/override (superscripted base exponent) (string-append base "^{" exponent "}"))
    (define/override (rooted body) (format "\\sqrt{~a}" body))
    (define/override (enclosed open texts close trees)
      (define stretch? (or (not trees) (ormap tall? trees)))
      (if (equal? open "|")
          (fenced "\\lvert " (string-append* texts) "\\rvert " stretch?)
          (fenced open (string-append* texts) close stretch?)))))

(define TeX%
  (class TeX-pieces%
    (super-new)
    (inherit draw draw-all enclosed)
    (define/override (letters p)
      (define base (parts-base p))
      (with-dots (if (eq? (parts-sort p) 'odd) (upright base) (letters->TeX base)) (parts-dots p)))
    (define/override (indexed base below above)
      (string-append base (index "_" below) (index "^" above)))
    (define/override (derivative-sign text) (if (string=? text "∂") "\\partial" text))
    (define/override (draw-operand t) (list " " (draw t)))
    (define/override (draw-scientific digits exponent)
      (format "~a\\times 10^{~a}" digits exponent))
    (define/override (function-name text)
      (hash-ref commands (string->symbol text) (lambda () (format "\\operatorname{~a}" text))))
    (define/override (apply-bare head texts) (format "~a{~a}" head (string-append* texts)))
    (define/override (draw-across items)
      (define row (draw-all items))
      (define several? (and (pair? row) (pair? (cdr row))))
      (enclosed "[" (if several? (list (array (list row) ",")) row) "]" #f))
    (define/override (draw-list items) (string-join (draw-all items) ",\\quad "))
    (define/override (draw-continuation text body)
      (format "\\quad{}~a{}~a" (sign->TeX text) (draw body)))
    (define/override (line-label text) (if (string=? text "") "" (upright text)))
    (define/override (part-space unlabelled?)
      (if unlabelled? "\\displaystyle " "\\ \\displaystyle "))))

(define (index sign texts)
  (if (null? texts) "" (string-append sign "{" (string-join (map letters->TeX texts) ",") "}")))

(define (with-dots base n)
  (if (= n 0) base (format "\\~a{~a}" (vector-ref #("" "dot" "ddot" "dddot") n) base)))

(define-column names-in-TeX
  [log "\\log"] [sin "\\sin"] [cos "\\cos"] [tan "\\tan"] [sinh "\\sinh"] [cosh "\\cosh"]
  [tanh "\\tanh"]
  [(asin acos atan atan2 asinh acosh atanh erf sgn) (none "LaTeX has no command of this name")]
  [(sqrt exp abs) (none "it has a notation of its own")])

(define commands
  (hash-set* names-in-TeX 'sec "\\sec" 'csc "\\csc" 'cot "\\cot" 'coth "\\coth"))

;; Fences around a body no taller than a letter do not stretch, and keep to their distance.
(define (fenced open body close stretch?)
  (if stretch?
      (string-append "\\left" open body "\\right" close)
      (string-append open body close)))

(define (environment name columns lines)
  (format "\\begin{~a}~a~a\\end{~a}" name columns (string-join lines "\\\\") name))

;; rows of texts, the columns parted by a sign.  Fractions are as large as outside of it.
(define (array rows sign)
  (define columns (if (null? rows) 1 (max 1 (length (car rows)))))
  (define fractions? (ormap (lambda (row) (ormap has-fraction? row)) rows))
  (define lines
    (for/list ([row (in-list rows)]) (string-join (map in-cell row) (string-append sign " & "))))
  (cond [(and fractions? (= columns 1)) (environment "gathered" "" (map car rows))]
        [else (format "\\begin{array}{~a}~a\\end{array}" (make-string columns #\c)
                      (string-join lines (if fractions? " \\\\[2ex] " " \\\\ ")))]))

(define (has-fraction? text) (regexp-match? #rx"\\\\frac" text))
(define (in-cell text) (if (has-fraction? text) (string-append "\\displaystyle " text) text))
