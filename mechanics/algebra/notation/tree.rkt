#lang racket/base
;; The tree of a formula: how its parts stand beside, above and below each other.
;;
;; It is made at one place (formula.rkt for S-expressions, a kind's own layout for other
;; values) and drawn in several ways: on one line, in lines of text, as TeX, as MathML, as a
;; picture.  The tree says what is a sum, a quotient, a power; how these look is the affair of
;; whoever draws it.  Parentheses that every way of drawing needs are in the tree; a line of
;; text adds those that a fraction bar, a raised exponent or a roof makes unnecessary.
;;
;; Trees are prefab: a snip with one is written to a file and read by another program.

(require (only-in racket/list append-map))

(provide (struct-out name) (struct-out word) (struct-out digits) (struct-out scientific)
         (struct-out imaginary)
         (struct-out plain)
         (struct-out row) (struct-out sum) (struct-out term) (struct-out product)
         (struct-out fraction) (struct-out power) (struct-out radical) (struct-out exponential)
         (struct-out parenthesized) (struct-out bars) (struct-out dotted)
         (struct-out derivative) (struct-out mark)
         (struct-out application)
         (struct-out column) (struct-out across) (struct-out grid) (struct-out listing)
         (struct-out relation) (struct-out omitted)
         (struct-out report) (struct-out report-line)
         (struct-out broken) (struct-out continuation)
         tree-parts fenced-itself? of-reports? unlabelled?)

;; Leaves
(struct name (symbol) #:prefab)          ; a variable or function, by the reader's name
(struct word (text) #:prefab)            ; upright: sin, or a word of prose
(struct digits (text) #:prefab)          ; a number without sign: 12, 0.5
(struct scientific (digits exponent) #:prefab)   ; digits × 10^exponent
(struct imaginary (coefficient) #:prefab)   ; a number times i
(struct plain (text) #:prefab)           ; the plain form of a value that is no formula

;; Formulas
(struct row (items) #:prefab)            ; one beside the other, without space
(struct sum (terms) #:prefab)            ; of `term`s
(struct term (negative? body) #:prefab)
(struct product (factors) #:prefab)
(struct fraction (numerator denominator) #:prefab)
(struct power (base exponent) #:prefab)
(struct radical (body) #:prefab)         ; a square root
(struct exponential (exponent) #:prefab) ; a power of e
(struct parenthesized (body) #:prefab)
(struct bars (body) #:prefab)            ; an absolute value
(struct dotted (base dots) #:prefab)     ; a time derivative: a name, 1 to 3 dots over it
(struct derivative (marks function) #:prefab)    ; function: #f of the operator alone
(struct mark (path count) #:prefab)      ; path: #f for D, or the indices of a ∂
;; bare?: without parentheses, as in sin x
(struct application (function arguments bare?) #:prefab)

;; Containers
(struct column (items) #:prefab)         ; an up tuple
(struct across (items) #:prefab)         ; a down tuple
(struct grid (rows) #:prefab)            ; a matrix: lists of one length
(struct listing (items) #:prefab)

;; Statements
(struct relation (left sign right) #:prefab)
(struct omitted (count) #:prefab)        ; in place of so many atoms, a text
(struct report (lines) #:prefab)
;; label : a string; parts : trees, none where the label stands alone
(struct report-line (depth label parts) #:prefab)

;; Statements in a list stand one below the other, without commas.
(define (of-reports? l) (ormap report? (listing-items l)))

(define (unlabelled? l) (string=? "" (report-line-label l)))

;; A sum or product cut into lines, each a tree; a part within the width is never cut.
(struct broken (lines) #:prefab)
(struct continuation (sign body) #:prefab)   ; a line that goes on with this sign

;; A single argument that brings parentheses of its own when it is drawn.
(define (fenced-itself? arguments)
  (and (= 1 (length arguments)) (column? (car arguments))))

;; The trees that a tree consists of, in order.
(define (tree-parts t) (trees-in (cdr (vector->list (struct->vector t)))))

;; xs : contents of fields; marks of derivatives, texts and numbers are no trees
(define (trees-in xs)
  (append-map (lambda (x)
                (cond [(term? x) (list (term-body x))]
                      [(report-line? x) (report-line-parts x)]
                      [(list? x) (trees-in x)]
                      [(and (prefab-struct-key x) (not (mark? x))) (list x)]
                      [else '()]))
              xs))
