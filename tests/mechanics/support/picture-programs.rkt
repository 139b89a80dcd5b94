#lang racket/base
;; For programs that write pictures: a folder of their own, and a machine without the drawing
;; library.

(require racket/file
         syntax/modresolve)

(provide
 in-a-folder        ; (in-a-folder body ...): what is written is deleted after them
 without-drawing)   ; (without-drawing f library ...): f of functions, from a name to what it is
                    ; in each library, in a namespace where racket/draw cannot be loaded

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
