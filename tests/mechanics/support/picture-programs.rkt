#lang racket/base
;; Programs that write pictures, run in this process, each in a folder of its own; and a
;; machine without the drawing library.

(require racket/file
         syntax/modresolve)

(provide
 run-in-namespace   ; (run-in-namespace make-namespace program argument ...) -> what it prints
 loaded-from        ; (loaded-from anchor library ...) -> namespace
 in-a-folder        ; (in-a-folder body ...): what is written is deleted after them
 without-drawing)   ; (without-drawing f library ...): f of functions, from a name to what it is
                    ; in each library, in a namespace where racket/draw cannot be loaded

;; A namespace where the libraries are loaded already, as they are at the anchor, and no
;; program.
(define (loaded-from anchor . libraries)
  (define namespace (make-base-empty-namespace))
  (for ([library (in-list libraries)])
    (namespace-attach-module (namespace-anchor->empty-namespace anchor) library namespace))
  namespace)

;; The program's `main`, with these arguments on its command line.
(define (run-in-namespace namespace program . arguments)
  (define out (open-output-string))
  (parameterize ([current-namespace namespace]
                 [current-output-port out]
                 [current-command-line-arguments (list->vector arguments)])
    (dynamic-require `(submod ,program main) #f))
  (get-output-string out))

(define-syntax-rule (in-a-folder body ...)
  (let ([folder (make-temporary-file "pictures~a" 'directory)])
    (dynamic-wind void
                  (lambda () (parameterize ([current-directory folder]) body ...))
                  (lambda () (delete-directory/files folder)))))

(define (without-drawing f . libraries)
  (define missing (resolve-module-path 'racket/draw #f))
  (define load (current-load/use-compiled))
  (parameterize ([current-namespace (make-base-empty-namespace)]
                 [current-load/use-compiled
                  (lambda (path name)
                    (when (equal? path missing) (raise-user-error "libcairo.so.2 is missing"))
                    (load path name))])
    (apply f (for/list ([library (in-list libraries)])
               (lambda (name) (dynamic-require library name))))))
