#lang racket/base
;; Lines of a program that were meant as one form: m = 3, f(3), or a line pasted with its prompt.
;; They are refused before the program is expanded, or each of their names would be unknown.  And
;; printed results that were pasted into a program.

(require (for-template "expansion-advice.rkt")
         "../../generic/on-demand.rkt")

(require-on-demand ["line-habits.rkt" misread-line]
                   ["pasted-result.rkt" pasted-sentence])

(provide check-lines as-pasted)

;; forms : of a module; defined : symbols that it defines
(define (check-lines forms defined)
  (when (side-by-side? forms)
    (define known? (known-beside (car forms) (lambda (name) (memq name defined))))
    (define found (misread-line forms known? (lambda (name) #f)))
    (when found (raise-syntax-error 'line (cdr found) (car found)))))

;; form : syntax of a module; defines? : symbol -> does the module define it?
(define ((known-beside form defines?) name)
  (and (or (defines? name) (identifier-binding (datum->syntax form name))) #t))

;; The form of a module; if it looks like a printed result, its names carry that as advice.
(define (as-pasted form defines?)
  (define head (and (pair? (syntax-e form)) (car (syntax-e form))))
  (define text
    (and head (memq (syntax-e head) '(+ - * / expt up down sqrt sin cos))
         (pasted-sentence (syntax->datum form) (known-beside form defines?))))
  (if text (with-advice-throughout form text) form))

(define (with-advice-throughout stx text)
  (define d (syntax-e stx))
  (cond [(symbol? d) (with-advice stx text)]
        [(pair? d)
         (datum->syntax stx (let within ([d d])
                              (cond [(pair? d) (cons (within (car d)) (within (cdr d)))]
                                    [(syntax? d) (with-advice-throughout d text)]
                                    [else d]))
                        stx stx)]
        [else stx]))

;; Do two of them stand on one line?
(define (side-by-side? forms)
  (and (pair? forms)
       (for/or ([form (in-list forms)] [next (in-list (cdr forms))])
         (and (syntax-line form) (eqv? (syntax-line form) (syntax-line next))))))
