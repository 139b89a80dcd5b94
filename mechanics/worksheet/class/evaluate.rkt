#lang racket/base
;; The process of one submission: it runs a student's program, and writes down the answers.
;;
;; It knows no key and gives no verdict.  The program runs in a sandbox of Racket's, and so does
;; whatever is asked of its values, for applying an answer or writing it down runs what the
;; student wrote.  What gets out of the sandbox is in a process that has nothing (isolation.rkt).
;;
;; It reads a request, and writes a line for each answer (answer-lines.rkt).

(require racket/sandbox
         "answer-lines.rkt"
         "../check-answers.rkt" "../exercise-kind.rkt" "../exercise.rkt")

(provide evaluate-request (struct-out request))

;; seconds : or #f, where its cost is watched over from outside
;; exercises : without keys; text : the program
(struct request (seconds megabytes exercises text) #:prefab)

;; in, out : ports
(define (evaluate-request in out)
  (define r (read in))
  (write-line-of '*ready* '(unanswered) out)
  (flush-output out)
  (define program (open-program r))
  (if (string? program)
      (write-line-of '*program* (list 'failed program) out)
      (for ([e (in-list (request-exercises r))])
        (write-line-of (exercise-name e) (answer-of program e) out)
        (flush-output out))))

;; -> an evaluator, or what went wrong
(define (open-program r)
  (with-handlers ([void reason])
    (parameterize ([sandbox-namespace-specs
                    (append (sandbox-namespace-specs) '(mechanics mechanics/answers))]
                   [sandbox-eval-limits (list (request-seconds r) (request-megabytes r))]
                   [sandbox-memory-limit (request-megabytes r)]
                   [sandbox-input #f]
                   [sandbox-output #f]
                   [sandbox-error-output #f]
                   [sandbox-propagate-exceptions #t]
                   [sandbox-propagate-breaks #f]
                   [sandbox-gui-available #f]
                   [checking? #f])
      (make-module-evaluator (request-text r)))))

;; A program that does not define the name leaves it unanswered.
(define (answer-of program e)
  (define name (exercise-name e))
  (with-handlers ([void (lambda (x) (list 'failed (reason x)))])
    (call-in-sandbox-context
     program
     (lambda ()
       (if (defined? name)
           (answer-of-kind e (eval name))
           '(unanswered))))))

(define (defined? name)
  (identifier-binding (namespace-symbol->identifier name) 0 #t))

;; What was raised is not asked for its message unless it is an error of Racket's own making,
;; and is not printed.
(define (reason x)
  (cond [(or (exn:fail:resource? x) (exn:fail:sandbox-terminated? x))
         "it took too long, or too much memory, or ended itself"]
        [(and (exn? x) (string? (exn-message x))) (exn-message x)]
        [else "it raised what is no error"]))
