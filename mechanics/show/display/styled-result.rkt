#lang racket/base
;; Results in the styles that are not S-expressions.
;;
;; Nothing that fails here reaches the prompt: a value that cannot be typeset is shown as it was
;; before there were styles, with a line that says why.

(require file/convertible
         "formula-text.rkt" "print-shown.rkt" "result-formula.rkt" "result-note.rkt"
         "../../algebra/expression/write.rkt"
         (only-in "../../algebra/notation/tree.rkt" plain?)
         "../../generic/describe.rkt" "../../generic/kind.rkt" "../../generic/on-demand.rkt"
         "../../generic/value-struct.rkt" "../../generic/value-tree.rkt"
         (only-in "../../algebra/expression/expression.rkt" symbolic?))

(require-on-demand ["formula-snip.rkt" formula->snip]
                   ["formula-drawing.rkt" convert-formula])

(provide styled-result)

;; Numbers and names that are drawn in one picture at most.
(define most-drawn 2000)

;; shown  : a value; notes : assumptions of its simplification (result-lines.rkt)
;; manner : as manner-here (display-style.rkt) gives it, but 'expression
;; unstyled : -> the result as an S-expression, as text with its notes and without
;; made   : (string -> value), which prints as that string
;; -> a value to be printed
(define (styled-result shown notes width manner unstyled made)
  (define (give-up why)
    (define-values (text program) (unstyled))
    (made (if why (format "~a\n; not typeset: ~a" text why) text)))
  (with-handlers ([exn:fail? (lambda (e) (give-up (one-line (exn-message e))))])
    (define tree (value->tree shown (not (eq? manner 'infix))))
    (define drawn? (memq manner '(snip picture)))
    (define size (if drawn? (max (atoms shown) (formula-size tree)) 0))
    (cond [(plain? tree) (give-up #f)]
          [(> size most-drawn)
           (give-up (format "it has ~a parts, and up to ~a are drawn" size most-drawn))]
          [drawn?
           (define-values (text program) (unstyled))
           (define f (formula tree (map note->remark notes) program text width))
           (if (eq? manner 'snip) (special (formula->snip f)) (picture f))]
          [else (made (styled-text tree notes width manner))])))

;; The number of atoms of an expression before its tree is cut at print-limit.
(define (atoms x)
  (if (or (symbolic? x) (has-kind? x)) ((make-sizer) (value->datum x)) 0))

(define (one-line text) (regexp-replace* #rx"\n *" text "; "))

;; For places that show values convertible to a picture: pages of Scribble, notebooks.  It prints
;; as the text that it is elsewhere, and stays text where the libraries that draw are missing.
(value-struct picture (formula)
  #:text (lambda (p) (formula-text (picture-formula p)))
  #:property prop:convertible
  (lambda (p request default)
    (with-handlers ([exn:fail? (lambda (e) default)])
      (convert-formula (picture-formula p) request default))))

;; ---------------------------------------------------------------------------
;; Text, and the notes beneath it

(define (styled-text tree notes width manner)
  (define comment
    (case manner
      [(TeX) "\n% ~a ~a"]
      [(MathML) "\n<!-- ~a ~a -->"]
      [else "\n; ~a ~a"]))
  (define (beneath n)
    (format comment (note-label n) (tree-in-format (note->tree n) width 'infix)))
  (apply string-append (tree-in-format tree width manner) (map beneath notes)))

(define (note->remark n) (cons (note-label n) (note->tree n)))
