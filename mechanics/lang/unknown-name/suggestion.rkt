#lang racket/base
;; What an unknown name was meant for: one that another library of the package defines, one
;; of the book that is not there yet, one that is called otherwise elsewhere, a formula written
;; as in print, or a known one that is spelt nearly so.

(require "other-library.rkt" "../../error/spelling.rkt"
         "../../generic/on-demand.rkt")

(require-on-demand ["../help/later.rkt" later-sentence]
                   ["../paper-notation/other-notation.rkt" notation-sentence]
                   ["../paper-notation/typed-formula.rkt" typed-formula])

(provide suggestion what-was-meant)

;; name : that is unknown; known : list of symbols; advice : what the form it stands in was
;; meant for, or #f  -> sentences, what is likelier first
(define (what-was-meant name known advice)
  (define formula (typed-formula name))
  (define meant (or advice (suggestion name known)))
  (append (if meant (list meant) '())
          (if (and formula (or (notation-sentence name) (not (letter-in formula))))
              '()
              (list (symbol-sentence name formula)))))

;; -> text or #f
(define (suggestion name known)
  (define library (library-of name))
  (define later (and (not library) (later-sentence name)))
  (define elsewhere (and (not library) (not later) (notation-sentence name)))
  (define names (if (or library later elsewhere) '() (likely-names name known)))
  (cond [library (format "(require ~a) defines it" library)]
        [later later]
        [elsewhere elsewhere]
        [(pair? names) (format "did you mean ~a?" (alternatives names))]
        [(typed-formula name) => (lambda (f) (format "operations come first: ~a" f))]
        [else #f]))

;; How a symbol of that name is written; in what looks like a formula, the letters are symbols.
(define (symbol-sentence name formula)
  (define letter (and formula (letter-in formula)))
  (if letter
      (format "a symbol in it is quoted, as '~s" letter)
      (format "as a symbol it is written '~s~a" name (or-number name))))

;; Letters that are numbers to mathematicians
(define (or-number name)
  (case name
    [(e) "; the number e is (exp 1)"]
    [(i) "; the imaginary unit is +i"]
    [else ""]))

(define (letter-in formula) (first-letter (read (open-input-string formula))))

;; In a formula, a datum: the first symbol that is no operation; or #f.
(define (first-letter formula)
  (cond [(symbol? formula) formula]
        [(pair? formula) (ormap first-letter (cdr formula))]
        [else #f]))
