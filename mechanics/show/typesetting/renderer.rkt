#lang racket/base
;; The traversal of a formula's tree that all renderers share.
;;
;; A renderer makes *pieces*: strings of TeX, X-expressions, blocks of text or picts.  Its methods
;; say how a piece is made of letters and of other pieces; which pieces a tree has is said here.

(require "../../algebra/notation/name.rkt" "../../algebra/notation/tree.rkt"
         racket/class
         (only-in racket/list add-between append-map))

(provide renderer% typesetter% tall?)

;; ---------------------------------------------------------------------------
;; Pieces

(define pieces%
  (class object%
    (super-new)
    (abstract draw)               ; tree -> piece
    (abstract draw-leaf)          ; the same, of leaves on one line everywhere
    (abstract prose verbatim number)
    (abstract roman)              ; upright letters: those of e and i
    (abstract sign)               ; (sign text form), form : 'prefix, 'infix or 'relation
    (abstract comma small-space indent)
    (abstract in-row)             ; pieces -> piece
    (abstract in-table)           ; rows of pieces -> piece
    (abstract in-lines)           ; (in-lines pieces sort), sort : 'broken, 'reports or 'report
    (abstract divided superscripted rooted)
    ;; (enclosed open pieces close trees), trees : those inside; #f of fences that always stretch
    (abstract enclosed)
    (define/public (draw-all ts) (for/list ([t (in-list ts)]) (draw t)))
    (define/public (with-commas ts) (add-between (draw-all ts) (comma)))))

;; ---------------------------------------------------------------------------
;; Formulas

(define formula-renderer%
  (class pieces%
    (super-new)
    (inherit draw draw-all draw-leaf in-row enclosed sign small-space
             divided superscripted rooted)
    (define/public (draw-sum terms)
      (define (signed x form)
        (list (sign (if (term-negative? x) "−" "+") form) (draw (term-body x))))
      (define start (signed (car terms) 'prefix))
      (in-row (append (if (term-negative? (car terms)) start (cdr start))
                      (append-map (lambda (x) (signed x 'infix)) (cdr terms)))))
    (define/public (factor-space factors) (small-space))
    (define/public (draw-product factors)
      (in-row (add-between (draw-all factors) (factor-space factors))))
    (define/public (draw-fraction t)
      (divided (draw (fraction-numerator t)) (draw (fraction-denominator t))))
    (define/public (draw-exponent t) (draw t))
    (define/public (draw-power base exponent) (superscripted base (draw-exponent exponent)))
    (define/public (draw-radical body) (rooted (draw body)))
    (define/public (draw-parenthesized body) (enclosed "(" (list (draw body)) ")" (list body)))
    (define/public (draw-mark m) (draw-leaf m))
    (define/public (draw-operand t) (list (draw t)))
    ;; function : #f of an operator alone
    (define/public (draw-derivative marks function)
      (in-row (append (for/list ([m (in-list marks)]) (draw-mark m))
                      (if function (draw-operand function) '()))))))

(define application-renderer%
  (class formula-renderer%
    (super-new)
    (inherit draw draw-power with-commas in-row enclosed prose small-space)
    (define/public (function-name text) (prose text))
    (define/public (apply-to head pieces) (in-row (cons head pieces)))
    (define/public (apply-bare head pieces) (apply-to head (cons (small-space) pieces)))
    (define/private (draw-head f)
      (cond [(power? f) (draw-power (draw-head (power-base f)) (power-exponent f))]
            [(word? f) (function-name (word-text f))]
            [else (draw f)]))
    (define/public (draw-application t)
      (define arguments (application-arguments t))
      (define head (draw-head (application-function t)))
      (define pieces (with-commas arguments))
      (cond [(application-bare? t) (apply-bare head pieces)]
            [(fenced-itself? arguments) (apply-to head pieces)]
            [else (apply-to head (list (enclosed "(" pieces ")" arguments)))]))))

;; ---------------------------------------------------------------------------
;; Containers and statements

(define container-renderer%
  (class application-renderer%
    (super-new)
    (inherit draw draw-all draw-leaf with-commas in-row in-table in-lines enclosed prose sign
             indent)
    (define/public (draw-across items) (enclosed "[" (with-commas items) "]" items))
    (define/public (draw-list items) (in-row (with-commas items)))
    (define/public (draw-continuation text body)
      (in-row (list (indent 1) (sign text 'infix) (draw body))))
    (define/public (line-label text) (prose text))
    (define/public (part-space unlabelled?) (prose (if unlabelled? "" " ")))
    (define/private (draw-report-line l)
      (define (part t) (list (part-space (unlabelled? l)) (draw t)))
      (in-row (list* (indent (* 2 (report-line-depth l))) (line-label (report-line-label l))
                     (append-map part (report-line-parts l)))))
    (define/public (draw-container t)
      (define (table rows) (list (in-table (for/list ([row (in-list rows)]) (draw-all row)))))
      (cond [(column? t) (enclosed "(" (table (map list (column-items t))) ")" #f)]
            [(grid? t) (enclosed "[" (table (grid-rows t)) "]" #f)]
            [(across? t) (draw-across (across-items t))]
            [(broken? t) (in-lines (draw-all (broken-lines t)) 'broken)]
            [(continuation? t) (draw-continuation (continuation-sign t) (continuation-body t))]
            [(report? t)
             (in-lines (for/list ([l (in-list (report-lines t))]) (draw-report-line l)) 'report)]
            [(not (listing? t)) (draw-leaf t)]
            [(of-reports? t) (in-lines (draw-all (listing-items t)) 'reports)]
            [else (draw-list (listing-items t))]))))

(define renderer%
  (class container-renderer%
    (super-new)
    (inherit draw-all draw-sum draw-product draw-fraction draw-power draw-exponent draw-radical
             draw-parenthesized draw-application draw-derivative draw-container
             prose number verbatim roman superscripted in-row enclosed sign)
    (define/override (draw t)
      (cond [(word? t) (prose (word-text t))]
            [(digits? t) (number (digits-text t))]
            [(plain? t) (verbatim (plain-text t))]
            [(omitted? t) (prose (omitted-count t))]
            [(row? t) (in-row (draw-all (row-items t)))]
            [(sum? t) (draw-sum (sum-terms t))]
            [(product? t) (draw-product (product-factors t))]
            [(fraction? t) (draw-fraction t)]
            [(power? t) (draw-power (draw (power-base t)) (power-exponent t))]
            [(radical? t) (draw-radical (radical-body t))]
            [(exponential? t) (superscripted (roman "e") (draw-exponent (exponential-exponent t)))]
            [(parenthesized? t) (draw-parenthesized (parenthesized-body t))]
            [(application? t) (draw-application t)]
            [(derivative? t) (draw-derivative (derivative-marks t) (derivative-function t))]
            [(bars? t) (enclosed "|" (list (draw (bars-body t))) "|" (list (bars-body t)))]
            [(relation? t) (in-row (list (draw (relation-left t)) (sign (relation-sign t) 'relation)
                                         (draw (relation-right t))))]
            [else (draw-container t)]))))

;; Is it taller than a letter?  Then brackets around it stretch.
(define (tall? t)
  (or (fraction? t) (radical? t) (column? t) (grid? t) (broken? t) (across? t)
      (ormap tall? (tree-parts t))))

;; ---------------------------------------------------------------------------
;; With indices above and below letters

(define typesetter%
  (class renderer%
    (super-new)
    (inherit draw in-row roman small-space verbatim)
    (abstract letters)            ; parts of a name -> its letters with the dots over them
    (abstract indexed)            ; (indexed base below above), below and above : texts
    (abstract derivative-sign)    ; "D" or "∂" -> piece
    (abstract draw-scientific)    ; digits exponent -> piece
    (define/private (draw-name p) (indexed (letters p) (subscripts p) (superscripts p)))
    (define/private (draw-imaginary coefficient)
      (if (equal? coefficient (digits "1"))
          (roman "i")
          (in-row (list (draw coefficient) (small-space) (roman "i")))))
    (define/override (draw-mark m)
      (define path (mark-path m))
      (define count (mark-count m))
      (indexed (derivative-sign (if path "∂" "D"))
               (map number->string (or path '()))
               (if (= count 1) '() (list (number->string count)))))
    (define/override (draw-leaf t)
      (cond [(name? t) (draw-name (name-parts (name-symbol t)))]
            [(dotted? t)
             (draw-name (dotted-parts (name-symbol (dotted-base t)) (dotted-dots t)))]
            [(scientific? t) (draw-scientific (scientific-digits t) (scientific-exponent t))]
            [(imaginary? t) (draw-imaginary (imaginary-coefficient t))]
            [else (verbatim (format "~s" t))]))))
