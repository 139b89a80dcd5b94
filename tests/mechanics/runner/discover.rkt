#lang racket/base
;; Which files are tests: every module under tests/mechanics except the runner,
;; the helpers, the benchmarks and package information; and every helper and
;; example with a `test` submodule.

(require racket/file
         racket/list
         racket/path
         racket/runtime-path)

(provide test-files      ; -> (listof path), sorted
         files-under)    ; path -> (listof path): the modules in or at path

(define-runtime-path tests-folder "..")
(define-runtime-path support-folder "../support")
(define-runtime-path examples-folder "../../../examples/mechanics")

(define not-tests '("runner" "bench" "support" "compiled"))

(define (test-files)
  (append
   (append* (for/list ([p (directory-list (simplify-path tests-folder) #:build? #t)]
                       #:unless (member (name-of p) not-tests))
              (files-under p)))
   (for*/list ([folder (list support-folder examples-folder)]
               [p (in-list (files-under (simplify-path folder)))]
               #:when (has-test-submodule? p))
     p)))

(define (files-under path)
  (sort (find-files module-file? path) path<?))

(define (module-file? p)
  (and (path-has-extension? p #".rkt")
       (file-exists? p)
       (not (equal? (name-of p) "info.rkt"))
       (not (regexp-match? #rx"^[.]" (name-of p)))))

(define (name-of p) (path->string (file-name-from-path p)))

;; Read off the text, so that a file that does not compile is still found.
(define (has-test-submodule? p)
  (regexp-match? #px"\\(module[+*]?\\s+test\\b" (file->string p)))
