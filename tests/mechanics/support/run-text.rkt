#lang racket/base
;; Running modules that are given as text, and prompts.

(require racket/port
         racket/string
         "messages.rkt")

(provide lines run-module run-submodule declare instantiate namespace syntax-message
         language prints refusal failure
         session answers open-prompt open-fresh-prompt)

(define-namespace-anchor here)

(define (lines . ls) (string-append* (map (lambda (l) (string-append l "\n")) ls)))

;; The output of a module given as text.
(define (run-module . text)
  (with-output-to-string (lambda () (instantiate (declare (apply lines text))))))

;; The name under which the module is declared.
(define (declare text)
  (define port (open-input-string text))
  (port-count-lines! port)
  (define name (string->uninterned-symbol "example"))
  (parameterize ([read-accept-reader #t]
                 [read-accept-lang #t]
                 [current-namespace (namespace)]
                 [current-module-declare-name (make-resolved-module-path name)])
    (eval (read-syntax 'example port)))
  name)

(define namespace
  (let ([n #f])
    (lambda ()
      (unless n
        (set! n (namespace-anchor->empty-namespace here))
        (parameterize ([current-namespace n]) (namespace-require 'racket/base)))
      n)))

(define (instantiate name)
  (parameterize ([current-namespace (namespace)])
    (dynamic-require (make-resolved-module-path name) #f)))

;; The output of the submodule `name` of a module given as text, the
;; module run before it.
(define (run-submodule name . text)
  (with-output-to-string
    (lambda ()
      (define enclosing (declare (apply lines text)))
      (parameterize ([current-namespace (namespace)])
        (dynamic-require `(submod ',enclosing ,name) #f)))))

(define (syntax-message . text)
  (message-of (declare (apply lines text)) exn:fail:syntax?))

;; ---------------------------------------------------------------------------
;; Modules in our language, given without their first line

(define language "#lang mechanics")

(define (prints . text) (apply run-module language text))
(define (refusal . text) (apply syntax-message language text))

;; The message of the exception that ends a module's run, and what it printed.
(define (failure . text)
  (define port (open-output-string))
  (define message
    (with-handlers ([exn:fail? exn-message])
      (parameterize ([current-output-port port])
        (instantiate (declare (apply lines language text))))
      "no error"))
  (list (get-output-string port) message))

;; ---------------------------------------------------------------------------
;; Prompts

(define racket (find-system-path 'exec-file))

(define racket-program
  (if (absolute-path? racket) racket (or (find-executable-path racket) racket)))

;; The output of `racket argument ...`, given these lines as input: the text
;; without prompts, and the errors.
(define (session arguments . input)
  (define-values (process out in err)
    (apply subprocess #f #f #f racket-program (append arguments '("-q"))))
  (write-string (apply lines input) in)
  (close-output-port in)
  (define errors (port->string err))
  (define output (port->string out))
  (close-input-port out)
  (close-input-port err)
  (subprocess-wait process)
  (values (without-prompts output) errors))

(define (without-prompts text)
  (for/list ([line (string-split text "\n")]
             #:unless (regexp-match? #rx"^Welcome" line)
             [answer (in-value (regexp-replace #rx"^(> )*" line ""))]
             #:unless (equal? answer ""))
    answer))

(define (answers . input)
  (define-values (output errors) (apply session '("-I" "mechanics") input))
  output)

;; -> procedure that takes lines of input at one and the same prompt of `racket argument ...`, and
;; answers as `session` does; the prompt ends with this process
(define (open-prompt . arguments)
  (define-values (process out in err)
    (apply subprocess #f #f #f racket-program (append arguments '("-q"))))
  (define mark "the end of the input")
  (define end (format "(begin (displayln ~s) (eprintf \"~~a\\n\" ~s))" mark mark))
  (lambda input
    (write-string (apply lines (append input (list end))) in)
    (flush-output in)
    (define errors (text-before mark err))
    (values (without-prompts (text-before mark out)) errors)))

;; -> the same of `racket -I mechanics`, where each call finds a prompt at which nothing was defined
(define (open-fresh-prompt)
  (define ask (open-prompt "-I" "mechanics"))
  (lambda input (apply ask (append input (list begin-afresh)))))

(define begin-afresh
  (format "~s"
          '(let ([fresh (make-base-empty-namespace)])
             (namespace-attach-module (current-namespace) 'mechanics fresh)
             (current-namespace fresh)
             (namespace-require 'mechanics))))

;; The lines up to one that ends with the mark, behind prompts, or to the end.
(define (text-before mark in)
  (apply lines
         (for/list ([line (in-lines in)] #:break (string-suffix? line mark)) line)))
