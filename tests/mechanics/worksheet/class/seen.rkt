#lang racket/base
;; What a submission sees of the teacher's folders: this library, and nothing that stands beside
;; it, where worksheets and their keys may be.

(require mechanics/worksheet/class/isolation
         racket/port
         rackunit
         "../../support/skip.rkt")

(define i (find-isolation 512 30))

(define (isolated form)
  (define-values (process out in err)
    (start-isolated i (list "-l" "racket/base" "-e" (format "~s" form))))
  (close-output-port in)
  (begin0 (port->string out)
          (close-input-port out)
          (close-input-port err)
          (subprocess-wait process)))

(define collection (simplify-path (collection-path "mechanics")))
(define around (path->string (simplify-path (build-path collection 'up))))

(skip-unless (isolation-complete? i)
             "no namespaces for submissions here: unshare, setpriv and prlimit are needed"
  (test-case "the library is found, and can be used"
    (check-equal? (isolated '(display (dynamic-require 'mechanics/worksheet/exercise 'exercise?)))
                  "#<procedure:exercise?>"))
  (test-case "nothing beside the library is seen"
    (check-equal? (isolated '(write (map path->string (directory-list "/library"))))
                  "(\"mechanics\")")
    (check-equal? (isolated `(write (directory-exists? ,around))) "#f")
    (for ([f '("CHANGELOG.md" "examples" "tests" "scribblings")])
      (define path (path->string (build-path around f)))
      (check-equal? (isolated `(write (or (file-exists? ,path) (directory-exists? ,path)))) "#f"
                    path)))
  (test-case "the library cannot be written to"
    (check-equal?
     (isolated '(with-handlers ([void (lambda (e) (write 'refused))])
                  (call-with-output-file "/library/mechanics/x" void)))
     "refused")))

(close-isolation i)
