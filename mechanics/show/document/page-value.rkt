#lang racket/base
;; A result as elements of a page.
;;
;; A formula that a narrow screen would have to scroll is there a second time, cut for 40
;; columns; the style sheet shows the one that the screen has room for.  Reports are text with
;; formulas in it, whose lines break where they must.

(require racket/list
         (only-in xml cdata)
         "../../algebra/notation/tree.rkt"
         "../typesetting/MathML.rkt" "../typesetting/break.rkt"
         "picture-markup.rkt" "shown-result.rkt")

(provide shown->xexprs tree->xexprs inline-xexprs picture-shown? visible raw)

(define wide 80)
(define narrow 40)

(define (picture-shown? s) (shown-picture? s))

;; Markup that is known to be well-formed.
(define (raw text) (cdata #f #f text))

;; number : -> how many pictures the page has before this one
(define (shown->xexprs s number)
  (cond [(shown-formula? s)
         (append (tree->xexprs (shown-formula-tree s))
                 (map note->xexpr (shown-formula-notes s)))]
        [(shown-table? s) (list (table->xexpr s))]
        [(shown-picture? s)
         (list `(figure ([aria-label ,(visible (shown-picture-text s))])
                        ,(raw (picture->markup s (number)))))]
        [else (list (text->xexpr (shown-text-text s)))]))

(define (text->xexpr text) `(pre ([class ,(string-append "text" (verdict-class text))])
                                 ,(visible text)))

(define (note->xexpr tree) `(p ([class "note"]) ,@(inline-xexprs tree)))

;; ---------------------------------------------------------------------------
;; Trees

(define (tree->xexprs t)
  (cond [(report? t) (list (report->xexpr t))]
        [(plain? t) (list (text->xexpr (plain-text t)))]
        [(and (listing? t) (ormap report? (listing-items t)))
         (append-map tree->xexprs (listing-items t))]
        [else (formula->xexprs t)]))

(define (formula->xexprs t)
  (define-values (for-wide for-narrow) (values (fit t wide) (fit t narrow)))
  (define (block tree class) `(div ([class ,class]) ,(raw (tree->MathML tree #t))))
  (if (equal? for-wide for-narrow)
      (list (block for-wide "formula"))
      (list (block for-wide "formula wide") (block for-narrow "formula narrow"))))

(define (report->xexpr t)
  `(div ([class ,(string-append "report" (report-class t))])
        ,@(for/list ([l (in-list (report-lines t))])
            `(p ([style ,(format "margin-left:~aem" (* 1.5 (report-line-depth l)))])
                (span ([class "label"]) ,(visible (report-line-label l)))
                ,@(append-map (lambda (part) (cons " " (inline-xexprs part)))
                              (report-line-parts l))))))

;; Words are the text's, and so is a comma after a formula.
(define (inline-xexprs t)
  (cond [(word? t) (list (visible (word-text t)))]
        [(plain? t) (list `(code ,(visible (plain-text t))))]
        [(and (row? t) (ormap word? (row-items t))) (append-map inline-xexprs (row-items t))]
        [(report? t) (list (report->xexpr t))]
        [else (list `(span ([class "inline"]) ,(raw (tree->MathML (fit t wide) #f))))]))

(define (report-class t)
  (define lines (report-lines t))
  (if (null? lines) "" (verdict-class (report-line-label (first lines)))))

(define (verdict-class text)
  (define m (regexp-match #px"^(proved|refuted|undecided)\\b" text))
  (if m (string-append " " (cadr m)) ""))

;; ---------------------------------------------------------------------------
;; Tables

(define (table->xexpr s)
  `(div ([class "table"])
        (table
         ,@(if (shown-table-header s)
               `((thead (tr ,@(for/list ([h (in-list (shown-table-header s))]) `(th ,h)))))
               '())
         (tbody
          ,@(for/list ([row (in-list (shown-table-rows s))])
              `(tr ,@(for/list ([t (in-list row)]) `(td ,@(inline-xexprs t)))))))))
