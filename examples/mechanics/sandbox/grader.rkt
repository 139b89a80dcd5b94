#lang racket/base
;; A grader: is the path that somebody handed in a motion of the harmonic oscillator?
;;
;; The program handed in may do anything: loop, fill the memory, read files, define
;; verify-solution anew.  So it runs in a sandbox, and so does every call of what it defines.
;; Out of the sandbox come a verdict that we asked for ourselves, and its text.

(require mechanics racket/sandbox)

(provide grade)

(define ((L-harmonic m k) (up t x v))
  (- (* 1/2 m (square v)) (* 1/2 k (square x))))

;; A program in #lang mechanics that defines `path` -> a list of 'proved, 'refuted, 'undecided
;; or 'failed, and what can be told its author
(define (grade program #:seconds [seconds 20] #:megabytes [megabytes 512])
  (with-handlers ([failed? (lambda (e) (list 'failed (reason e)))])
    (define submission (open-submission program seconds megabytes))
    (dynamic-wind void
                  (lambda () (judge submission))
                  (lambda () (kill-evaluator submission)))))

(define (open-submission program seconds megabytes)
  (parameterize ([sandbox-namespace-specs (append (sandbox-namespace-specs) '(mechanics))]
                 [sandbox-eval-limits (list seconds megabytes)]
                 [sandbox-memory-limit megabytes]
                 [sandbox-output #f]
                 [sandbox-error-output #f])
    (make-module-evaluator program)))

;; Our question, asked inside.  Its answer is what our own verify-solution returned: if the
;; path escapes from it with an answer of its own, there is none.
(define (judge submission)
  (define path (submission 'path))
  (define verdict #f)
  (define text "it gave no answer")
  (call-in-sandbox-context
   submission
   (lambda ()
     (forget-assumptions)
     (automatic-assumptions #t)
     (define found (verify-solution (L-harmonic 'm (* 'm (square 'omega))) path))
     (set! text (format "~a" found))
     (set! verdict found)))
  (list (if (verdict? verdict) (verdict-status verdict) 'failed) text))

;; An exception raised inside is not printed, nor asked for its message.
(define (failed? e) (not (exn:break? e)))
(define (reason e)
  (if (or (exn:fail:resource? e) (exn:fail:sandbox-terminated? e))
      "it took too long, or too much memory"
      "it stopped with an error"))

(module+ main
  (define answer
    (grade "#lang mechanics\n(define (path t) (* 'a (sin (+ (* 'omega t) 'phi))))"))
  (printf "~a\n~a\n" (car answer) (cadr answer)))

(module+ test
  (require rackunit)
  (define (status . lines)
    (car (grade (apply string-append "#lang mechanics\n" lines))))
  (check-equal? (status "(define (path t) (* 'a (cos (* 'omega t))))") 'proved)
  (check-equal? (status "(define (path t) (* 'a (cos (* 2 'omega t))))") 'refuted)
  (check-equal? (status "(define (path t) (car t))") 'failed))
