#lang racket/base
;; Lines of a program that were meant as one form: m = 3, f(3), or one that was pasted with the
;; prompt before it.  They are refused before anything is expanded, or each of their forms would
;; be told to be unknown.

(require "../../generic/on-demand.rkt")

(require-on-demand ["line-habits.rkt" misread-line])

(provide check-lines)

;; forms : of a module; defined : symbols that it defines
(define (check-lines forms defined)
  (when (side-by-side? forms)
    (define (known? name)
      (or (and (memq name defined) #t)
          (and (identifier-binding (datum->syntax (car forms) name)) #t)))
    (define found (misread-line forms known? (lambda (name) #f)))
    (when found (raise-syntax-error 'line (cdr found) (car found)))))

;; Do two of them stand on one line?
(define (side-by-side? forms)
  (and (pair? forms)
       (for/or ([form (in-list forms)] [next (in-list (cdr forms))])
         (and (syntax-line form) (eqv? (syntax-line form) (syntax-line next))))))
