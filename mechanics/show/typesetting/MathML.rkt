#lang racket/base
;; Trees as presentation MathML, of the subset that today's browsers share (MathML Core).
;;
;; The dots of time derivatives stand over their letters as spacing characters: combining ones
;; browsers misplace, and those of an accent lie on the letter.

(require "../../algebra/notation/name.rkt" "../../algebra/notation/tree.rkt"
         (only-in racket/list add-between append*)
         (only-in xml xexpr->string))

(provide tree->MathML visible)

;; block? : on a line of its own, and not within a text?
(define (tree->MathML t block?)
  (xexpr->string
   `(math ([xmlns "http://www.w3.org/1998/Math/MathML"]
           [display ,(if block? "block" "inline")])
          ,(xexpr t))))

(define (xexpr t)
  (cond [(name? t) (name->xexpr (name-parts (name-symbol t)))]
        [(word? t) `(mtext ,(visible (word-text t)))]
        [(digits? t) `(mn ,(digits-text t))]
        [(sum? t) (sum->xexpr t)]
        [(product? t) (row-of (add-between (map xexpr (product-factors t)) thin-space))]
        [(fraction? t) `(mfrac ,(xexpr (fraction-numerator t)) ,(xexpr (fraction-denominator t)))]
        [(power? t) `(msup ,(xexpr (power-base t)) ,(xexpr (power-exponent t)))]
        [(parenthesized? t) (fenced "(" (list (xexpr (parenthesized-body t))) ")"
                                   (tall? (parenthesized-body t)))]
        [(application? t) (application->xexpr t)]
        [(derivative? t) (derivative->xexpr t)]
        [else (other->xexpr t)]))

(define (other->xexpr t)
  (cond [(scientific? t)
         (row-of `((mn ,(scientific-digits t)) (mo "×")
                   (msup (mn "10") ,(integer->xexpr (scientific-exponent t)))))]
        [(imaginary? t) (imaginary->xexpr (imaginary-coefficient t))]
        [(radical? t) `(msqrt ,(xexpr (radical-body t)))]
        [(exponential? t) `(msup (mi ([mathvariant "normal"]) "e")
                                ,(xexpr (exponential-exponent t)))]
        [(bars? t) (fenced "|" (list (xexpr (bars-body t))) "|")]
        [(dotted? t) (name->xexpr (dotted-parts (name-symbol (dotted-base t)) (dotted-dots t)))]
        [(row? t) (row-of (map xexpr (row-items t)))]
        [(relation? t) (row-of (list (xexpr (relation-left t)) `(mo ,(visible (relation-sign t)))
                                     (xexpr (relation-right t))))]
        [(plain? t) `(mtext ([style "font-family:monospace"]) ,(visible (plain-text t)))]
        [(omitted? t) `(mtext ,(visible (omitted-count t)))]
        [else (container->xexpr t)]))

(define (row-of items) (if (and (pair? items) (null? (cdr items))) (car items) `(mrow ,@items)))
(define thin-space '(mspace ([width "0.17em"])))

(define (integer->xexpr n)
  (if (negative? n) `(mrow (mo "−") (mn ,(number->string (- n)))) `(mn ,(number->string n))))

;; XML has no place for some characters, however they are written.
(define (visible text)
  (regexp-replace* #px"[^\t\n\r\u20-\uD7FF\uE000-\uFFFD\U10000-\U10FFFF]" text "\uFFFD"))

;; ---------------------------------------------------------------------------
;; Names

(define (name->xexpr p)
  (define base
    (case (parts-sort p)
      [(letter) `(mi ,(parts-base p))]
      [(capital word) `(mi ([mathvariant "normal"]) ,(parts-base p))]
      [else `(mtext ,(visible (parts-base p)))]))
  (define below (subscripts p))
  (define above (superscripts p))
  (define dotted (with-dots base (parts-dots p)))
  (cond [(and (null? below) (null? above)) dotted]
        [(null? above) `(msub ,dotted ,(index below))]
        [(null? below) `(msup ,dotted ,(index above))]
        [else `(msubsup ,dotted ,(index below) ,(index above))]))

(define (index texts)
  (row-of (add-between (for/list ([text (in-list texts)])
                         (if (regexp-match? #px"^[0-9]+$" text) `(mn ,text) `(mi ,text)))
                       '(mo ([separator "true"]) ","))))

(define (with-dots base n)
  (if (= n 0)
      base
      `(mover ,base
              (mo ([stretchy "false"]) ,(vector-ref (vector "" "˙" "¨" "˙˙˙") n)))))

;; ---------------------------------------------------------------------------
;; Formulas

;; Around what is no taller than a letter they need not stretch, and keep no distance.
(define (fenced open items close [tall? #t])
  (define (sign form text)
    `(mo ([form ,form] [stretchy ,(if tall? "true" "false")]) ,text))
  `(mrow ,(sign "prefix" open) ,@items ,(sign "postfix" close)))

(define (tall? t)
  (or (fraction? t) (radical? t) (column? t) (grid? t) (broken? t) (across? t)
      (ormap tall? (tree-parts t))))

(define (sum->xexpr t)
  (define terms (sum-terms t))
  (define (sign x form) `(mo ([form ,form]) ,(if (term-negative? x) "−" "+")))
  (row-of
   (append (if (term-negative? (car terms)) (list (sign (car terms) "prefix")) '())
           (list (xexpr (term-body (car terms))))
           (append* (for/list ([x (in-list (cdr terms))])
                      (list (sign x "infix") (xexpr (term-body x))))))))

(define (imaginary->xexpr coefficient)
  (define i '(mi ([mathvariant "normal"]) "i"))
  (if (equal? coefficient (digits "1")) i (row-of (list (xexpr coefficient) thin-space i))))

(define (application->xexpr t)
  (define f (application-function t))
  (define head (if (power? f)
                   `(msup ,(function->xexpr (power-base f)) ,(xexpr (power-exponent f)))
                   (function->xexpr f)))
  (define arguments (add-between (map xexpr (application-arguments t)) comma))
  `(mrow ,head
         (mo "\u2061")                   ; the invisible sign of an application
         ,@(cond [(application-bare? t) (cons thin-space arguments)]
                 [(fenced-itself? (application-arguments t)) arguments]
                 [else (list (fenced "(" arguments ")" (ormap tall? (application-arguments t))))])))

(define comma '(mo ([separator "true"]) ","))

(define (function->xexpr f) (if (word? f) `(mi ([mathvariant "normal"]) ,(word-text f)) (xexpr f)))

(define (derivative->xexpr t)
  (row-of (append (map mark->xexpr (derivative-marks t))
                  (if (derivative-function t) (list (xexpr (derivative-function t))) '()))))

(define (mark->xexpr m)
  (define path (mark-path m))
  (define count `(mn ,(number->string (mark-count m))))
  (define once? (= 1 (mark-count m)))
  (cond [(not path) (if once? '(mi "D") `(msup (mi "D") ,count))]
        [else
         (define below (index (map number->string path)))
         (if once? `(msub (mi "∂") ,below) `(msubsup (mi "∂") ,below ,count))]))

;; ---------------------------------------------------------------------------
;; Containers and statements

(define (container->xexpr t)
  (cond [(column? t) (fenced "(" (list (table (map list (column-items t)) "center")) ")")]
        [(across? t) (fenced "[" (add-between (map xexpr (across-items t)) comma) "]"
                             (ormap tall? (across-items t)))]
        [(grid? t) (fenced "[" (list (table (grid-rows t) "center")) "]")]
        [(listing? t) (if (of-reports? t)
                          (table (map list (listing-items t)) "left")
                          (row-of (add-between (map xexpr (listing-items t)) comma)))]
        [(broken? t) (table (map list (broken-lines t)) "left")]
        [(continuation? t)
         `(mrow (mspace ([width "1em"])) (mo ([form "infix"]) ,(continuation-sign t))
                ,(xexpr (continuation-body t)))]
        [(report? t) (stack (map report-line->xexpr (report-lines t)))]
        [else `(mtext ,(visible (format "~s" t)))]))

(define (table rows alignment)
  `(mtable ([columnalign ,alignment] [displaystyle "true"])
           ,@(for/list ([row (in-list rows)])
               `(mtr ,@(for/list ([t (in-list row)]) (cell (xexpr t) alignment))))))

(define (stack items)
  `(mtable ([columnalign "left"] [displaystyle "true"])
           ,@(for/list ([i (in-list items)]) `(mtr ,(cell i "left")))))

;; Where the attribute of the table is not known, the style is; centered it is without.
(define (cell x alignment)
  (if (string=? alignment "center") `(mtd ,x) `(mtd ([style "text-align:left"]) ,x)))

(define (report-line->xexpr l)
  (row-of `((mspace ([width ,(format "~aem" (* 2 (report-line-depth l)))]))
            (mtext ,(visible (report-line-label l)))
            ,@(append* (for/list ([p (in-list (report-line-parts l))])
                         (list '(mspace ([width "0.5em"])) (xexpr p)))))))
