#lang racket/base
;; Files of the library that have changed since they were compiled.  Racket loads them from
;; their sources, beside others that were compiled with what they were before.

(require compiler/compilation-path
         (only-in racket/list append*)
         racket/runtime-path
         "../error/compiling-note.rkt")

(provide tell-of-stale-files    ; ->
         stale-files)           ; path of a folder -> paths of stale files in it

(define-runtime-path library "..")

;; Where nothing is compiled the library says so as it is loaded.
(define (tell-of-stale-files)
  (define folder (simplify-path library))
  (define first-loaded (build-path folder "error" "uncompiled.rkt"))
  (unless (or (eq? (use-compiled-file-check) 'exists) (stale? first-loaded))
    (define files (stale-files folder))
    (unless (null? files)
      (tell-of-stale files (simplify-path (build-path folder 'up))))))

(define (stale-files folder)
  (append*
   (for/list ([name (in-list (map path->string (directory-list folder)))])
     (define path (build-path folder name))
     (cond [(module-name? name) (if (stale? path) (list path) '())]
           [(and (not (regexp-match? #rx"[.]|^compiled$" name)) (directory-exists? path))
            (stale-files path)]
           [else '()]))))

;; info.rkt is data.
(define (module-name? name) (regexp-match? #rx"(?<!^info)[.]rkt$" name))

(define (stale? file)
  (define (seconds path) (file-or-directory-modify-seconds path #f (lambda () 0)))
  (< (seconds (get-compilation-bytecode-file file)) (seconds file)))
