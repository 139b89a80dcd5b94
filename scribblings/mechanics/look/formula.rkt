#lang racket/base
;; Formulas in running text, written as they are read: @formula{½ m (l θ̇)²}.
;;
;; Formulas for `read-infix` are typeset as results are.  Text has more signs than that,
;; d/dt ∂L/∂θ̇ for one; such a formula is typeset sign by sign.

(require racket/list
         racket/string
         scribble/core
         (only-in xml xexpr->string)
         "typeset.rkt"
         (only-in "../../../mechanics/algebra/notation/formula.rkt" plain-datum->tree)
         (only-in "../../../mechanics/algebra/notation/read-infix.rkt" infix->datum)
         "../../../mechanics/show/typesetting/MathML.rkt")

(provide formula formula->markup)

(define (formula . content)
  (define plain (element "formula" content))
  (if (andmap string? content)
      (element "formula" (typeset-element (formula->markup (string-append* content)) content))
      plain))

(define (formula->markup text)
  (define datum
    (and (not (string-contains? text "|"))
         (with-handlers ([exn:fail:contract? (lambda (e) #f)]) (infix->datum text))))
  (if datum
      (tree->MathML (plain-datum->tree datum) #f)
      (xexpr->string `(math ([display "inline"]) ,@(signs text)))))

;; ---------------------------------------------------------------------------
;; Sign by sign

;; ((regexp . (match -> xexpr, or procedure of the xexpr before)) ...), the first that fits
(define rules
  (list
   (cons #px"^\\s+" (lambda (m) '(mspace ([width "0.2em"]))))
   (cons #px"^([∂d][²³]?)([^\\s/()+−]*)/([∂d][^\\s()+−=]*)"
         (lambda (m) `(mfrac (mrow ,@(signs (cadr m)) ,@(signs (caddr m)))
                             (mrow ,@(signs (cadddr m))))))
   (cons #px"^(?:sin|cos|tan|exp|log)(?!\\p{L})"
         (lambda (m) `(mi ([mathvariant "normal"]) ,(car m))))
   (cons #px"^(\\p{L})([\u307\u308\u20DB])"
         (lambda (m) `(mover (mi ,(cadr m)) (mo ([stretchy "false"])
                                                ,(cdr (assoc (caddr m) dots))))))
   (cons #px"^\\p{L}" (lambda (m) `(mi ,(car m))))
   (cons #px"^[0-9]+" (lambda (m) `(mn ,(car m))))
   (cons #px"^[⁰¹²³⁴⁵⁶⁷⁸⁹]+"
         (lambda (m) (lambda (base) `(msup ,base (mn ,(lowered (car m)))))))
   (cons #px"^½" (lambda (m) '(mfrac (mn "1") (mn "2"))))
   (cons #px"^." (lambda (m) `(mo ([stretchy "false"]) ,(car m))))))

(define dots '(("\u307" . "˙") ("\u308" . "¨") ("\u20DB" . "˙˙˙")))

(define (lowered digits)
  (list->string (for/list ([c (in-string digits)])
                  (string-ref "0123456789" (index-of (string->list "⁰¹²³⁴⁵⁶⁷⁸⁹") c)))))

;; -> xexprs
(define (signs text)
  (let loop ([text text] [done '()])
    (cond [(string=? text "") (reverse done)]
          [else
           (define rule (findf (lambda (r) (regexp-match? (car r) text)) rules))
           (define found (regexp-match (car rule) text))
           (define made ((cdr rule) found))
           (loop (substring text (string-length (car found)))
                 (cond [(not (procedure? made)) (cons made done)]
                       [(null? done) (list (made '(mrow)))]
                       [else (cons (made (car done)) (cdr done))]))])))
