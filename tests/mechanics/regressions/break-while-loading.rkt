#lang racket/base
;; A break (Ctrl-C) that came while a room was loaded at the first call was raised again by
;; every later call of the session.  When that was mended, a caller that was killed left the
;; room half made.

;; for-label: compiled with this file.
(require (for-label mechanics) "../support/checks.rkt")

;; In a namespace of its own, where nothing is loaded yet.  The break comes when the file
;; of that number is loaded.
(define (first-call expression #:break-at n)
  (define loaded 0)
  (define load (current-load/use-compiled))
  (define asker (current-thread))
  (parameterize ([current-namespace (make-base-empty-namespace)])
    (namespace-require 'mechanics)
    (define broken?
      (with-handlers ([exn:break? (lambda (e) #t)])
        (parameterize ([current-load/use-compiled
                        (lambda (path name)
                          (set! loaded (+ loaded 1))
                          (when (= loaded n) (break-thread asker))
                          (load path name))])
          (eval expression)
          (sleep 0))                    ; where it comes at the latest
        #f))
    (list broken? (format "~s" (eval expression)))))

(test-case "what was broken off at its first call works at the next"
  (for ([n '(1 20 60)])
    (check-equal? (first-call '(simplify (+ 'x 'x)) #:break-at n) '(#t "(* 2 x)")))
  (check-equal? (first-call '(proved? (prove-zero (- 'x 'x))) #:break-at 5) '(#t "#t"))
  (check-equal? (first-call '(compiled-function? (compile-function (lambda (x) (* x x)) 1.0))
                            #:break-at 3)
                '(#t "#t")))

;; The same, when the caller is killed instead.
(define (killed-call expression #:kill-at n)
  (define loaded 0)
  (define load (current-load/use-compiled))
  (parameterize ([current-namespace (make-base-empty-namespace)])
    (namespace-require 'mechanics)
    (define limits (make-custodian))
    (define (load-and-kill path name)
      (set! loaded (+ loaded 1))
      (when (= loaded n) (custodian-shutdown-all limits))
      (load path name))
    (thread-wait
     (parameterize ([current-custodian limits]
                    [current-load/use-compiled load-and-kill])
       (thread (lambda () (eval expression)))))
    (list (>= loaded n) (format "~s" (eval expression)))))

(test-case "what was killed at its first call works at the next"
  (for ([n '(1 20 60)])
    (check-equal? (killed-call '(simplify (+ 'x 'x)) #:kill-at n) '(#t "(* 2 x)"))))
