#lang racket/base
;; The likeliest meaning of an unknown name: one that another library of the package defines, one
;; of scmutils, one that has another name elsewhere, one of a library of Racket's, a formula written
;; as in print, or a known name that is spelt nearly so.

(require "other-library.rkt"
         "../paper-notation/operation-sign.rkt" "../paper-notation/typographic.rkt"
         "../written-form.rkt"
         "../../error/spelling.rkt"
         "../../generic/on-demand.rkt")

(require-on-demand ["../paper-notation/other-notation.rkt" notation-sentence]
                   ["scmutils-names.rkt" scmutils-sentence]
                   ["../paper-notation/prefix-form.rkt" typed-formula about-escapes])

(provide suggestion what-was-meant advice-on-name)

;; name : unknown; known : symbols; advice : on the form around the name, or #f;
;; more : a sentence for the end, or #f
;; -> sentences, the likeliest first
(define (what-was-meant name known advice [more #f])
  (define formula (typed-formula name))
  (define letter (and formula (letter-in formula)))
  (define about-symbol
    (cond [(and (not formula) (formula-like? name)) #f]
          [(not formula) (format "as a symbol it is written '~s~a" name (or-number name))]
          [(or (not letter) (notation-sentence name)) #f]
          [else (format "a symbol in it is quoted, as '~s" letter)]))
  (define print (or (typographic-sentence name) (power-sentence name)))
  (if print
      (list print)
      (filter values (list (or advice (suggestion name known)) about-symbol more))))

;; id : an unknown name -> advice on the signs around it, or #f
(define (advice-on-name id) (and (escaped? id) (about-escapes id)))

;; Of ^2, as in (sin x)^2
(define (power-sentence name)
  (define found (regexp-match #rx"^(\\^|[*][*])(.+)$" (symbol->string name)))
  (and found (format "a power comes first, as in (expt (sin x) ~a)" (caddr found))))

;; -> text or #f
(define (suggestion name known)
  (define (near) (likely-names name known))
  (cond [(library-of name) => (lambda (library) (format "(require ~a) defines it" library))]
        [(scmutils-sentence name)]
        [(notation-sentence name)]
        [(Racket-library-of name)
         => (lambda (library) (format "(require (only-in ~a ~a)) defines it" library name))]
        [(pair? (near)) (format "did you mean ~a?" (alternatives (near)))]
        [(typed-formula name)
         => (lambda (form) (string-append "operations come first: " (form->text form)))]
        [(formula-like? name) about-formulas]
        [else #f]))

;; About letters that are numbers to mathematicians.
(define (or-number name)
  (case name
    [(e) "; the number e is (exp 1)"]
    [(i) "; the imaginary unit is +i"]
    [else ""]))

;; The first symbol of a formula that is no operation, or #f.
(define (letter-in formula)
  (define letters (operands formula))
  (and (pair? letters) (car letters)))
