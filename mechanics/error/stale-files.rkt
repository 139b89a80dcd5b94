#lang racket/base
;; Files of the library that have changed since they were compiled.  Racket loads them from their
;; sources, beside others that were compiled with their earlier versions.

(require compiler/compilation-path
         (only-in racket/list append*)
         "compiling-note.rkt")

(provide tell-of-stale-files    ; ->
         stale-files)           ; path of a folder -> paths of stale files in it

;; A library that is not compiled at all says so when it is loaded.
(define (tell-of-stale-files)
  (define folder (simplify-path (collection-path "mechanics")))
  (define first-loaded (build-path folder "error" "uncompiled.rkt"))
  (unless (or (nobody-waits?)
              (eq? (use-compiled-file-check) 'exists)
              (newer-than-compiled? first-loaded))
    (define files (stale-files folder))
    (unless (null? files)
      (tell-of-stale files (simplify-path (build-path folder 'up))))))

;; A folder that cannot be listed is no reason to refuse a program.
(define (stale-files folder)
  (append*
   (for/list ([name (in-list (names-in folder))])
     (define path (build-path folder name))
     (cond [(and (module-name? name) (newer-than-compiled? path)) (list path)]
           [(and (not (regexp-match? #rx"[.]|^compiled$" name)) (directory-exists? path))
            (stale-files path)]
           [else '()]))))

;; info.rkt is data.
(define (module-name? name) (regexp-match? #rx"(?<!^info)[.]rkt$" name))

(define (names-in folder)
  (with-handlers ([exn:fail:filesystem? (lambda (_) '())])
    (map path->string (directory-list folder))))

;; DrRacket looks for compiled files in two folders, of which one may be empty.
(define (newer-than-compiled? file)
  (define source (seconds file))
  (not (for/or ([mode (in-list (use-compiled-file-paths))])
         (>= (seconds (get-compilation-bytecode-file file #:modes (list mode))) source))))

(define (seconds path) (file-or-directory-modify-seconds path #f (lambda () 0)))
