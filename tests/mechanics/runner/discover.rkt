#lang racket/base
;; Which files are tests: every module under tests/mechanics except the runner,
;; the benchmarks, the helpers in support/ and attack/ and package information; and
;; every helper and example with a `test` submodule.

(require racket/file
         racket/path
         racket/runtime-path)

(provide test-files      ; -> (listof path)
         files-under)    ; path -> (listof path): the modules below or at it

(define-runtime-path tests "..")
(define-runtime-path examples "../../../examples/mechanics")

(define (test-files)
  (for*/list ([folder (list tests examples)]
              [file (in-list (files-under (simplify-path folder)))]
              #:when (test? file))
    file))

(define (test? file)
  (define place (path->string (find-relative-path (simplify-path tests) file)))
  (cond [(regexp-match? #rx"^(runner|bench)/" place) #f]
        ;; read off the text, so that a file that does not compile is found too
        [(regexp-match? #rx"^(support|attack|[.][.])/" place)
         (regexp-match? #px"\\(module[+*]?\\s+test\\b" (file->string file))]
        [else #t]))

(define (files-under path) (find-files module-file? path))

(define (module-file? path)
  (and (path-has-extension? path #".rkt")
       (not (regexp-match? #rx"^[.]|^info[.]rkt$" (path->string (file-name-from-path path))))))
