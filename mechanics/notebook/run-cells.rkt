#lang racket/base
;; The cells of a notebook run in this process, for a notebook that is written with its results.

(require "cell-session.rkt" "cell.rkt" "changed-pictures.rkt"
         "../show/display/receiving-printer.rkt"
         "../show/notebook/program-cells.rkt")

(provide run-cells)

(define-namespace-anchor here)

;; Runs cells, unless on? until one fails -> for each cell its outputs as Jupyter has them; the last
;; failure or #f.  In a thread of their own, so that no message tells who runs them.
(define (run-cells cells #:on? [on? #f])
  (define result
    (list (map (lambda (_) '()) cells) (failure "a cell ended the process of the notebook" #f #f)))
  (thread-wait (thread (lambda ()
                         (set! result (call-with-values (lambda () (run-here cells on?)) list)))))
  (apply values result))

(define (run-here cells on?)
  (parameterize ([current-namespace (namespace-anchor->empty-namespace here)])
    (namespace-require 'mechanics)
    (call-as-session
     (lambda ()
       (for/fold ([outputs '()] [failed #f] #:result (values (reverse outputs) failed))
                 ([c (in-list cells)])
         (define-values (found why)
           (if (and (eq? (cell-kind c) 'code) (or on? (not failed)))
               (run-cell (cell-source c))
               (values '() #f)))
         (values (cons found outputs) (or why failed)))))))

(define (run-cell code)
  (define outputs '())
  (define written (open-output-string))
  (define (add! output) (set! outputs (cons output outputs)))
  (define (add-text!)
    ;; and empties the port
    (define text (bytes->string/utf-8 (get-output-bytes written #t) #\uFFFD))
    (unless (string=? text "")
      (add! (hasheq 'output_type "stream" 'name "stdout" 'text text))))
  (define pictures (make-changed-pictures))
  (define (show! x)
    (unless (void? x)
      (define data (hash-ref (result-message pictures x #f) 'data))
      (add-text!)
      (add! (hasheq 'output_type "display_data" 'metadata (hasheq) 'data data))
      (note-shown! pictures x)))
  (define failed
    (parameterize ([current-output-port written] [current-error-port written]
                   [current-print (output-receiver show! written)])
      (call-showing-changes pictures (lambda () (evaluate-cell code)) show!)))
  (add-text!)
  (when failed (add! (failure->output failed)))
  (values (reverse outputs) failed))

(define (failure->output f)
  (hasheq 'output_type "error" 'ename "error" 'evalue (failure-message f)
          'traceback (list (failure-message f))))
