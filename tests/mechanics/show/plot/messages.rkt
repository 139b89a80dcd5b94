#lang racket/base
;; Messages of each procedure that draws on a call it does not take.

(require racket/string
         mechanics/plot
         (prefix-in m: mechanics)
         "../../support/checks.rkt" "../../support/messages.rkt")

(define f (frame 0 1 0 1))
(define tr (m:evolve-trajectory (lambda (s) (m:up 1 0)) (m:up 0 1) 1))
(define (curve t) (m:up t t))

;; A procedure, arguments that it takes, how many those may be, and its keywords.
(define line '(#:color #:label #:style #:width))
(define dot '(#:color #:label #:size))
(define calls
  (list
   (list frame '(0 1 0 1) "4 arguments"
         '(#:aspect-ratio #:height #:title #:width #:x-label #:x-scale #:y-label #:y-scale))
   (list plot-point (list f 0 0) "3 arguments" dot)
   (list plot-line (list f 0 0 1 1) "5 arguments" line)
   (list plot-function (list f sin 0 1) "4 or 5 arguments" line)
   (list plot-parametric (list f curve 0 1) "4 or 5 arguments" line)
   (list plot-parametric-fill (list f curve 0 1) "4 or 5 arguments" dot)
   (list plot-trajectory (list f tr m:time) "3 or 4 arguments" line)
   (list plot-contours (list f + '(1)) "3 arguments" '(#:color #:label #:samples #:style #:width))
   (list graphics-clear (list f) "1 argument" '())
   (list graphics-close (list f) "1 argument" '())
   (list graphics-save (list f "f.png") "2 arguments" '(#:centimeters #:font #:font-size))
   (list graphics-show (list f) "1 argument" '(#:wait?))
   (list frame-points (list f) "1 argument" '())
   (list frame-curves (list f) "1 argument" '())
   (list frame->pict (list f) "1 argument" '())))

(define-syntax-rule (for-calls (draw who arguments count keywords) body ...)
  (for ([c (in-list calls)])
    (define-values (draw arguments count keywords) (apply values c))
    (define who (object-name draw))
    (with-check-info (['procedure who]) body ...)))

(define (its keywords) (if (null? keywords) "" (format "\n  its keywords: ~s" keywords)))

(test-case "a number of arguments that it does not take"
  (for-calls (draw who arguments count keywords)
    (check-message (format "~a: takes ~a; it was given none~a" who count (its keywords))
                   (draw) exn:fail:contract:arity?)
    (check-message (format "~a: takes ~a; it was given 9~a" who count (its keywords))
                   (apply draw (append arguments (build-list (- 9 (length arguments)) values)))
                   exn:fail:contract:arity?)))

(test-case "a keyword that it does not know"
  (for-calls (draw who arguments count keywords)
    (check-message (format "~a: there is no keyword #:colour here~a" who (its keywords))
                   (keyword-apply draw '(#:colour) '(red) arguments))))

(test-case "something else in place of the frame, a frame in the place of something else"
  (for-calls (draw who arguments count keywords)
    (unless (eq? draw frame)
      (check-message (format (string-append "~a: expected a frame, such as (frame 0 1 -1 1)\n"
                                            "  given: (trajectory from 0.0 to 1.0), a function")
                             who)
                     (apply draw tr (cdr arguments)))
      (unless (null? (cdr arguments))
        (define said (message-of (apply draw f f (cddr arguments))))
        (check-true (string-prefix? said (format "~a: " who)) said)
        (check-regexp-match #rx"given: .frame x from 0.0 to 1.0, y from 0.0 to 1.0: [^\n]*" said)
        (check-false (regexp-match? #rx"contract|#<|[a-z]-ref" said) said)))))

(test-case "nothing was drawn"
  (check-equal? (append (frame-points f) (frame-curves f)) '()))
