#lang racket/base
;; Systems exported as C, built by the compiler that is here, and called.

(require ffi/unsafe
         racket/flonum
         racket/system
         (only-in mechanics export-system)
         "folder.rkt")

(provide compiler? build-folder call-with-export in-folder run-in
         exported-function exported-evolve exported-ensemble)

;; Is there a compiler of C, and make?
(define compiler? (and (find-executable-path "cc") (find-executable-path "make") #t))

;; strict: as its users' strictest compilers would have it.
(define strict "CFLAGS=-std=c99 -O2 -Wall -Wextra -Werror -ffp-contract=off")

;; -> what the command prints; an error if it fails
(define (run-in folder #:input [input ""] command . arguments)
  (define out (open-output-string))
  (define good?
    (parameterize ([current-directory folder]
                   [current-input-port (open-input-string input)]
                   [current-output-port out]
                   [current-error-port out])
      (apply system* (find-executable-path* command) arguments)))
  (unless good? (error 'run-in "~a failed: ~a" command (get-output-string out)))
  (get-output-string out))

(define (find-executable-path* command)
  (if (path? command) command (or (find-executable-path command) command)))

(define (build-folder folder . more) (apply run-in folder "make" "-s" strict more))

(define (in-folder folder name) (build-path folder name))

;; (use folder library) in a folder that is gone afterwards
(define (call-with-export use name derivative example #:parameters [parameters #f]
                          #:derivatives? [derivatives? #f])
  (with-folder (beside)
    (define folder (build-path beside name))
    (export-system derivative example #:language 'C #:name name #:folder folder
                   #:parameters parameters #:derivatives? derivatives?)
    (build-folder folder)
    (use folder (ffi-lib (build-path folder (string-append "lib" name ".so"))))))

;; -> (state parameters -> flvector of so many numbers)
(define (exported-function library name outputs)
  (define f (get-ffi-obj name library (_fun _pointer _pointer _pointer -> _void)))
  (lambda (y p)
    (define out (make-flvector outputs))
    (call-with-doubles (list y p out)
                       (lambda (py pp pout)
                         (f py pp pout)
                         (read-doubles! out pout)))
    out))

;; -> the state reached, the status, and the states at the times
(define (exported-evolve library name y p end tolerance times)
  (define f
    (get-ffi-obj name library
                 (_fun _pointer _pointer _double _double _long _pointer _pointer -> _int)))
  (define last (flvector-copy y))
  (define rows (make-flvector (* (length times) (flvector-length y))))
  (define status
    (call-with-doubles (list y p (apply flvector times) rows)
                       (lambda (py pp pt pr)
                         (begin0 (f py pp end tolerance (length times) pt pr)
                                 (read-doubles! last py)
                                 (read-doubles! rows pr)))))
  (values last status rows))

;; -> how many failed, the states reached, the statuses
(define (exported-ensemble library name count starts p end tolerance)
  (define f
    (get-ffi-obj name library
                 (_fun _long _pointer _pointer _int _double _double _pointer -> _long)))
  (define last (flvector-copy starts))
  (define status (malloc 'raw (* 4 (max count 1))))
  (define failed
    (call-with-doubles (list starts p)
                       (lambda (ps pp)
                         (begin0 (f count ps pp 0 end tolerance status)
                                 (read-doubles! last ps)))))
  (define codes (for/list ([k (in-range count)]) (ptr-ref status _int k)))
  (free status)
  (values failed last codes))

;; Copies that the collector does not move, for the time of the call.
(define (call-with-doubles vectors use)
  (define pointers
    (for/list ([v (in-list vectors)])
      (define p (malloc 'raw (* 8 (+ 1 (flvector-length v)))))
      (for ([x (in-flvector v)] [k (in-naturals)]) (ptr-set! p _double k x))
      p))
  (begin0 (apply use pointers)
          (for-each free pointers)))

(define (read-doubles! v p)
  (for ([k (in-range (flvector-length v))]) (flvector-set! v k (ptr-ref p _double k))))
