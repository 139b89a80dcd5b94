#lang racket/base
;; The interactions of the examples: each control is moved to its ends, and the body has a value
;; there.  The values are tested beside them (examples.rkt).

(require (only-in mechanics/book)
         (only-in mechanics/plot)
         racket/list
         racket/path
         (only-in racket/port open-output-nowhere)
         racket/runtime-path
         "../../../../mechanics/show/interact/control.rkt"
         "../../../../mechanics/show/interact/interaction.rkt"
         "../../../../mechanics/show/interact/outcome.rkt"
         "../../support/checks.rkt" "../../support/example-programs.rkt")

(define-runtime-path folder "../../../../examples/mechanics/interactive")

(define programs
  (for/list ([file (in-list (directory-list folder #:build? #t))]
             #:when (path-has-extension? file #".rkt"))
    file))

(define-namespace-anchor here)
(define space
  (loaded-from here 'mechanics 'mechanics/book 'mechanics/plot
               'mechanics/show/interact/interaction))

;; -> the interactions that a program provides
(define (interactions-of program)
  (parameterize ([current-namespace space] [current-output-port (open-output-nowhere)])
    (dynamic-require program #f)
    (define-values (variables syntaxes) (module->exports program))
    (filter interaction?
            (for*/list ([phase (in-list variables)] [export (in-list (cdr phase))])
              (dynamic-require program (car export))))))

;; The starts, and those with one control at one of its ends
(define (ends i)
  (define controls (interaction-controls i))
  (define starts (start-values i))
  (remove-duplicates
   (cons starts
         (for*/list ([(c k) (in-parallel controls (in-naturals))] #:when (control-values c)
                     [end (in-list (list (control-from c) (control-to c)))])
           (list-set starts k end)))))

(test-case "there are at least ten systems"
  (check-true (>= (length programs) 10)))

(for ([program (in-list programs)])
  (define name (path->string (file-name-from-path program)))
  (alone name
         (define interactions (interactions-of program))
         (test-case (format "~a provides interactions" name)
           (check-true (pair? interactions)))
         (for ([i (in-list interactions)])
           (test-case (format "~a: the body has a value at the ends of its controls" name)
             (for ([values (in-list (ends i))])
               (define o (interaction-outcome i values))
               (check-false (failed? o) (format "~a at ~a: ~a" name values o)))))))
