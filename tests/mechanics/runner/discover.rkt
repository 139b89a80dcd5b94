#lang racket/base
;; Which files are tests: every module under tests/mechanics except the runner,
;; the benchmarks, the helpers in support/ and attack/ and package information; and
;; every helper with a `test` submodule.  Those of the examples are run by some of the tests,
;; many in a process (support/example-programs.rkt).

(require racket/file
         racket/path
         racket/runtime-path)

(provide test-files      ; -> (listof path)
         example-files   ; -> (listof path): examples with tests
         files-under)    ; path -> (listof path): the modules below or at it

(define-runtime-path tests "..")
(define-runtime-path examples "../../../examples/mechanics")

(define (test-files)
  (filter test? (files-under (simplify-path tests))))

(define (test? file)
  (define place (path->string (find-relative-path (simplify-path tests) file)))
  (cond [(regexp-match? #rx"^(runner|bench)/" place) #f]
        [(regexp-match? #rx"^(support|attack)/" place) (has-tests? file)]
        [else #t]))

(define (example-files) (filter has-tests? (files-under (simplify-path examples))))

;; Read off the text, so that a file that does not compile is found too.
(define (has-tests? file) (regexp-match? #px"\\(module[+*]?\\s+test\\b" (file->string file)))

(define (files-under path) (find-files module-file? path))

(define (module-file? path)
  (and (path-has-extension? path #".rkt")
       (not (regexp-match? #rx"^[.]|^info[.]rkt$" (path->string (file-name-from-path path))))))
