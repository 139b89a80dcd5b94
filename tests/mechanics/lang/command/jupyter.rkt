#lang racket/base
;; `raco mechanics jupyter --remove`: the folder that Jupyter looks in, and what is said of it.

(require mechanics/lang/command/raco
         racket/file
         "../../support/checks.rkt" "../../support/skip.rkt")

(define folder (make-temporary-file "jupyter~a" 'directory))
(define kernel (build-path folder "jupyter" "kernels" "mechanics"))

;; variables : of the environment, in place of those there are -> status, and what was printed
(define (remove-kernel variables . arguments)
  (define out (open-output-string))
  (define status
    (parameterize ([current-output-port out] [current-directory folder]
                   [current-environment-variables
                    (apply make-environment-variables variables)])
      (run-command-line (list* "jupyter" "--remove" arguments))))
  (list status (get-output-string out)))

(define (data name path) (list name (path->bytes path)))
(define none (list 0 (format "there is no kernel mechanics in ~a\n" kernel)))

(test-case "the kernel is in Jupyter's folder, that of the user's data, or that of an environment"
  (define data-folder (build-path folder "jupyter"))
  (check-equal? (remove-kernel (data #"JUPYTER_DATA_DIR" data-folder)) none)
  (skip-unless (eq? 'unix (system-type)) "no other system has this place"
    (check-equal? (remove-kernel (data #"XDG_DATA_HOME" folder)) none))
  (check-equal? (remove-kernel '() "--prefix" "environment")
                (list 0 (format "there is no kernel mechanics in ~a\n"
                                (build-path folder "environment" "share" "jupyter" "kernels"
                                            "mechanics")))))

(test-case "a kernel is taken out with its folder"
  (make-directory* kernel)
  (check-equal? (remove-kernel (data #"JUPYTER_DATA_DIR" (build-path folder "jupyter")))
                (list 0 (format "the kernel mechanics was taken out of ~a\n" kernel)))
  (check-false (directory-exists? kernel)))

(delete-directory/files folder)
