#lang racket/base
;; Long work is announced, and short work is not.

(require mechanics/show/display/waiting-remark "../../support/checks.rkt")

;; The text written while `f` gets the port, and its value
(define (announced seconds f)
  (define port (open-output-string))
  (define value
    (parameterize ([current-error-port port] [announcement-delay seconds])
      (call-announced "waiting ..." (lambda () (f port)))))
  (list value (get-output-string port)))

(define (wait-for-text port)
  (when (string=? (get-output-string port) "")
    (sleep 0.01)
    (wait-for-text port)))

(test-case "a remark is made once while the work goes on"
  (check-equal? (announced 0 (lambda (port) (wait-for-text port) 'value))
                '(value "; waiting ...\n")))

(test-case "none is made of what is done before"
  (check-equal? (announced 3600 (lambda (port) 'value)) '(value "")))

(test-case "nor of what fails or is left"
  (check-equal? (announced 3600 (lambda (port) (with-handlers ([exn:fail? exn-message])
                                                 (raise-user-error "no"))))
                '("no" ""))
  (check-exn #rx"^no$" (lambda () (announced 3600 (lambda (port) (raise-user-error "no"))))))

(test-case "an editor shows it beside its results, not as an error"
  (define-values (in written) (make-pipe))
  (define editor
    (make-output-port 'editor always-evt
                      (lambda (bytes from to . more) (write-bytes bytes written from to))
                      void
                      (lambda (value . more) #t)))
  (parameterize ([current-output-port editor] [announcement-delay 0])
    (check-equal? (announced 0 (lambda (port) (read-line in))) '("; waiting ..." ""))))
