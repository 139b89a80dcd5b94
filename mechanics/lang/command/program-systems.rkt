#lang racket/base
;; The systems of a program, ready for export: those it follows while it runs, and state
;; derivatives that it defines and does not follow.
;;
;; The names of variables and parameters come from the program's text (definition-heads.rkt): a
;; motion itself is of numbers.

(require "definition-heads.rkt" "run-program.rkt" "system-of-program.rkt"
         "../program-file.rkt"
         "../../motion/observed-systems.rkt"
         (only-in "../../motion/system/check.rkt" state-derivative?)
         (only-in "../../motion/system/manifold.rkt" manifold-derivative?)
         (only-in "../../motion/system/parametric-system.rkt" derivative-for)
         "../../generic/up-down.rkt")

(provide program-systems (struct-out findings))

;; systems   : candidates, in the order in which they are followed
;; shapeless : names of state derivatives of which no state is known
;; error     : message of the error that ended the program early, or #f
;; exited?   : did it end itself, by `exit`?
(struct findings (systems shapeless error exited?) #:authentic)

;; who : in whose name is complained; name : of the file, as it was given -> findings
(define (program-systems who file name #:derivatives? [derivatives? #f])
  (check-program who name file)
  (define stx (call-with-program file (lambda (port) (read-whole-program who name file port))))
  (define-values (motions defined) (values '() '()))
  (define (look namespace) (set! defined (definitions stx namespace)))
  (define end
    (outcome-end
     (call-watching-systems
      (lambda (maker ps state) (set! motions (with-motion maker ps state motions)))
      (lambda () (run-program stx file #:shown void #:look look)))))
  (define k (make-knowledge stx defined file))
  (define all (reverse motions))
  (define-values (unfollowed shapeless) (defined-only all defined k))
  (findings (systems-of (append all unfollowed) k derivatives?)
            shapeless
            (and end (early-end-message end))
            (and end (not (early-end-message end)))))

;; ---------------------------------------------------------------------------
;; Systems that are followed

;; A program may make its system anew for each motion.
(define most-motions 500)

;; motions : followed, the last first
(define (with-motion maker ps state motions)
  (define derivative (if (null? ps) (derivative-for maker '()) maker))
  (define (same? f)
    (and (eq? derivative (followed-maker f))
         (= (length ps) (length (followed-parameters f)))
         (same-shape? state (followed-state f))))
  (if (or (>= (length motions) most-motions) (ormap same? motions))
      motions
      (cons (followed derivative ps state) motions)))

;; ---------------------------------------------------------------------------
;; Systems that are defined

;; -> alist of names and values
(define (definitions stx namespace)
  (for*/list ([name (in-list (defined-names stx))]
              [value (in-value (namespace-variable-value name #t (lambda () #f) namespace))]
              #:when (procedure? value))
    (cons name value)))

;; -> followed, with states from the patterns of arguments; and the names of state derivatives
;; without a pattern
(define (defined-only all defined k)
  (define makers (map followed-maker all))
  (for/fold ([unfollowed '()] [shapeless '()]
             #:result (values (reverse unfollowed) (reverse shapeless)))
            ([d (in-list defined)]
             #:when (or (state-derivative? (cdr d)) (manifold-derivative? (cdr d)))
             #:unless (memq (cdr d) makers))
    (define state (state-by-pattern (cdr d) k))
    (if state
        (values (cons (followed (cdr d) '() state) unfollowed) shapeless)
        (values unfollowed (cons (car d) shapeless)))))
