#lang racket/base
;; The systems of a program, ready for export: those it follows while it runs, and state
;; derivatives that it defines and does not follow.
;;
;; What its own definitions call the variables and parameters is read off its text
;; (definition-heads.rkt): a motion itself is of numbers.

(require "definition-heads.rkt" "run-program.rkt" "system-of-program.rkt"
         "../program-file.rkt"
         "../../generic/describe.rkt"
         "../../motion/observed-systems.rkt"
         (only-in "../../motion/system/parametric-system.rkt" derivative-for)
         "../../generic/up-down.rkt")

(provide program-systems (struct-out findings))

;; systems   : found ones, in the order in which they are followed
;; shapeless : names of state derivatives of which no state is known
;; error     : what ended the program before its last form, a text, or #f
;; exited?   : did it end itself, by `exit`?  Then nothing beyond is known
(struct findings (systems shapeless error exited?) #:authentic)

;; who : in whose name is complained; name : of the file, as it was given -> findings
(define (program-systems who file name #:derivatives? [derivatives? #f])
  (check-program who name file)
  (define stx (call-with-program file (lambda (port) (read-whole-program who name file port))))
  (define r (register '()))
  (define defined '())
  (define (look namespace) (set! defined (definitions stx namespace)))
  (define o
    (call-watching-systems (lambda (maker ps state) (register! r maker ps state))
                           (lambda () (run-program stx file #:shown void #:look look))))
  (define end (outcome-end o))
  (define k (make-knowledge stx defined file))
  (define all (reverse (register-all r)))
  (define-values (unfollowed shapeless) (defined-only all defined k))
  (findings (systems-of (append all unfollowed) k derivatives?)
            shapeless
            (and end (early-end-message end))
            (and end (not (early-end-message end)))))

;; ---------------------------------------------------------------------------
;; What is followed

;; all : followed, the last first
(struct register ([all #:mutable]) #:authentic)

;; A program may make its system anew for each motion.
(define most-registered 500)

(define (register! r maker ps state)
  (define all (register-all r))
  (define derivative (if (null? ps) (derivative-for maker '()) maker))
  (unless (or (>= (length all) most-registered)
              (for/or ([f (in-list all)])
                (and (eq? derivative (followed-maker f))
                     (= (length ps) (length (followed-parameters f)))
                     (same-shape? state (followed-state f)))))
    (set-register-all! r (cons (followed derivative ps state) all))))

;; ---------------------------------------------------------------------------
;; What is defined

;; -> alist of names and values
(define (definitions stx namespace)
  (for*/list ([name (in-list (defined-names stx))]
              [value (in-value (namespace-variable-value name #t (lambda () #f) namespace))]
              #:when (procedure? value))
    (cons name value)))

(define makers
  '(Lagrangian->state-derivative Hamiltonian->state-derivative constrained-state-derivative))

(define (state-derivative? x)
  (define d (value->datum x))
  (and (pair? d) (memq (car d) makers) #t))

;; -> followed, with states that its arguments show, and the names of those that show none
(define (defined-only all defined k)
  (define others
    (for/list ([d (in-list defined)]
               #:when (state-derivative? (cdr d))
               #:unless (for/or ([f (in-list all)]) (eq? (cdr d) (followed-maker f))))
      d))
  (define states (for/list ([d (in-list others)]) (state-by-pattern (cdr d) k)))
  (values (for/list ([d (in-list others)] [s (in-list states)] #:when s)
            (followed (cdr d) '() s))
          (for/list ([d (in-list others)] [s (in-list states)] #:unless s) (car d))))
