#lang racket/base
;; A submission's view of the teacher's folders: this library, and nothing that stands beside
;; it, where worksheets and their keys may be.

(require "../../support/checks.rkt" "../../support/isolated.rkt")

(define collection (simplify-path (collection-path "mechanics")))
(define around (path->string (simplify-path (build-path collection 'up))))

(call-with-namespaces
 (lambda (i)
   (test-case "the library is found, and can be used"
     (check-equal?
      (isolated i '(display (dynamic-require 'mechanics/teaching/worksheet/exercise 'exercise?)))
      "#<procedure:exercise?>"))
   (test-case "nothing beside the library is seen"
     (check-equal? (isolated i '(write (map path->string (directory-list "/library"))))
                   "(\"mechanics\")")
     (check-equal? (isolated i `(write (directory-exists? ,around))) "#f")
     (for ([f '("CHANGELOG.md" "examples" "tests" "scribblings")])
       (define path (path->string (build-path around f)))
       (check-equal? (isolated i `(write (or (file-exists? ,path) (directory-exists? ,path)))) "#f"
                     path)))
   (test-case "the library cannot be written to"
     (check-equal?
      (isolated i '(with-handlers ([void (lambda (e) (write 'refused))])
                   (call-with-output-file "/library/mechanics/x" void)))
      "refused"))))
