#lang racket/base
;; Trees as presentation MathML, of the subset that today's browsers share (MathML Core).
;;
;; The dots of time derivatives stand over their letters as spacing characters: browsers misplace
;; combining ones, and an accent's dots lie on the letter.

(require "renderer.rkt"
         "../../algebra/notation/name.rkt"
         racket/class
         (only-in racket/list add-between)
         (only-in xml xexpr->string))

(provide tree->MathML visible)

;; block? : on a line of its own, and not within a text?
(define (tree->MathML t block?)
  (xexpr->string
   `(math ([xmlns "http://www.w3.org/1998/Math/MathML"]
           [display ,(if block? "block" "inline")])
          ,(send (new MathML%) draw t))))

(define MathML%
  (class typesetter%
    (super-new)
    (define/override (prose text) `(mtext ,(visible text)))
    (define/override (verbatim text) `(mtext ([style "font-family:monospace"]) ,(visible text)))
    (define/override (number text) `(mn ,text))
    (define/override (roman text) `(mi ([mathvariant "normal"]) ,text))
    (define/override (function-name text) (roman text))
    (define/override (sign text form)
      (if (eq? form 'relation) `(mo ,(visible text)) `(mo ([form ,(symbol->string form)]) ,text)))
    (define/override (comma) '(mo ([separator "true"]) ","))
    (define/override (small-space) (space 0.17))
    (define/override (part-space unlabelled?) (space 0.5))
    (define/override (indent n) (space n))
    (define/override (in-row items) (row-of items))
    (define/override (in-table rows) (table rows "center" '()))
    (define/override (in-lines items sort) (table (map list items) "left" left-aligned))
    (define/override (divided above below) `(mfrac ,above ,below))
    (define/override (superscripted base exponent) `(msup ,base ,exponent))
    (define/override (rooted body) `(msqrt ,body))
    (define/override (enclosed open items close trees) (fenced open items close trees))
    ;; the invisible sign of an application
    (define/override (apply-to head items) (row-of (list* head '(mo "\u2061") items)))
    (define/override (letters p) (with-dots (letters->xexpr p) (parts-dots p)))
    (define/override (indexed base below above) (with-indices base below above))
    (define/override (derivative-sign text) `(mi ,text))
    (define/override (draw-scientific digits exponent)
      (row-of `((mn ,digits) (mo "×") (msup (mn "10") ,(integer->xexpr exponent)))))))

(define (space em) `(mspace ([width ,(format "~aem" em)])))
(define (row-of items) (if (and (pair? items) (null? (cdr items))) (car items) `(mrow ,@items)))

(define (integer->xexpr n)
  (if (negative? n) `(mrow (mo "−") (mn ,(number->string (- n)))) `(mn ,(number->string n))))

;; XML has no place for some characters, however they are written.
(define (visible text)
  (regexp-replace* #px"[^\t\n\r\u20-\uD7FF\uE000-\uFFFD\U10000-\U10FFFF]" text "\uFFFD"))

;; ---------------------------------------------------------------------------
;; Names

(define (letters->xexpr p)
  (case (parts-sort p)
    [(letter) `(mi ,(parts-base p))]
    [(capital word) `(mi ([mathvariant "normal"]) ,(parts-base p))]
    [else `(mtext ,(visible (parts-base p)))]))

(define (with-dots base n)
  (if (= n 0)
      base
      `(mover ,base
              (mo ([stretchy "false"]) ,(vector-ref (vector "" "˙" "¨" "˙˙˙") n)))))

;; below, above : texts
(define (with-indices base below above)
  (cond [(and (null? below) (null? above)) base]
        [(null? above) `(msub ,base ,(index below))]
        [(null? below) `(msup ,base ,(index above))]
        [else `(msubsup ,base ,(index below) ,(index above))]))

(define (index texts)
  (row-of (add-between (for/list ([text (in-list texts)])
                         (if (regexp-match? #px"^[0-9]+$" text) `(mn ,text) `(mi ,text)))
                       '(mo ([separator "true"]) ","))))

;; ---------------------------------------------------------------------------
;; Fences and tables

;; Fences around trees no taller than a letter do not stretch, and keep no distance.
(define (fenced open items close trees)
  (define stretchy (if (or (not trees) (ormap tall? trees)) "true" "false"))
  (define (fence form text) `(mo ([form ,form] [stretchy ,stretchy]) ,text))
  `(mrow ,(fence "prefix" open) ,@items ,(fence "postfix" close)))

(define (table rows alignment cell-attributes)
  `(mtable ([columnalign ,alignment] [displaystyle "true"])
           ,@(for/list ([row (in-list rows)])
               `(mtr ,@(for/list ([x (in-list row)]) `(mtd ,@cell-attributes ,x))))))

;; For browsers that do not know the attribute of the table; they center without it.
(define left-aligned '(([style "text-align:left"])))
