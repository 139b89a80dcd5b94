#lang racket/base
;; A student's program, run in a sandbox of Racket's.
;;
;; A program that cannot be run as a whole, because of a misspelt name for example, is run form by
;; form, as if it were typed at a prompt: so a mistake in one answer voids no other.  The cells of a
;; notebook are run one after the other, as the kernel of notebooks would.

(require racket/match
         racket/sandbox
         "../worksheet/defined-names.rkt"
         (only-in "../../error/refusal.rkt" raised?))

(provide open-program open-cells answer-in program-ended? (struct-out program) reason failure-words)

;; Exception -> words on it; the language knows better words, and the line.
(define failure-words (make-parameter exn-message))

;; evaluator : or #f, if no form could be run
;; problem   : why it does not run as a whole, or #f
;; failures  : hasheq, why a name has no value
(struct program (evaluator problem failures))

;; seconds : of each evaluation, or #f
(define (open-program text seconds megabytes)
  (define (limited make) (call-limited make seconds megabytes))
  (with-handlers ([void (lambda (x) (open-by-forms text x limited))])
    (program (limited (lambda () (make-module-evaluator text))) #f (hasheq))))

;; make : -> evaluator
(define (call-limited make seconds megabytes)
  (parameterize ([sandbox-namespace-specs
                  (append (sandbox-namespace-specs) '(mechanics mechanics/answers))]
                 [sandbox-eval-limits (list seconds megabytes)]
                 [sandbox-memory-limit megabytes]
                 [sandbox-input #f]
                 [sandbox-output #f]
                 [sandbox-error-output #f]
                 [sandbox-propagate-exceptions #t]
                 [sandbox-propagate-breaks #f]
                 [sandbox-gui-available #f])
    (make)))

;; x : the value raised when the program was run as a whole
(define (open-by-forms text x limited)
  (with-handlers ([void (lambda (_) (program #f (reason x) (hasheq)))])
    (define evaluator
      (and (exn:fail? x) (not (out-of-bounds? x)) (regexp-match? our-language text)
           (limited make-prompt)))
    (program evaluator (reason x)
             (if evaluator
                 (call-in-sandbox-context evaluator (lambda () (run-forms text)))
                 (hasheq)))))

(define (make-prompt) (make-evaluator 'mechanics #:requires '(mechanics/answers)))

(define our-language #px"^#lang mechanics[ \t]*\r?\n")

;; Runs the forms up to the first one that cannot be read.  Of a name's definitions the last
;; counts. -> failures
(define (run-forms text)
  (define in (open-input-string text))
  (port-count-lines! in)
  (void (read-line in))
  (let loop ([failures (hasheq)])
    (define form (with-handlers ([exn:fail? (lambda (x) eof)]) (read-syntax 'program in)))
    (cond [(eof-object? form) failures]
          [else
           (define x (with-handlers ([raised? values]) (eval form) #f))
           (define name (name-defined (syntax->datum form)))
           (loop (cond [(not name) failures]
                       [x (hash-set failures name (reason x))]
                       [else (hash-remove failures name)]))])))

;; ---------------------------------------------------------------------------
;; Cells

;; sources : texts of cells; run : cell -> why it failed, a text, or #f
(define (open-cells sources run seconds megabytes)
  (with-handlers ([void (lambda (x) (program #f (reason x) (hasheq)))])
    (define evaluator (call-limited make-prompt seconds megabytes))
    (with-handlers ([void (lambda (x) (program evaluator (reason x) (hasheq)))])
      (program evaluator #f
               (call-in-sandbox-context evaluator (lambda () (run-cells sources run)))))))

;; Names that a failing cell would have defined, and no cell has, have that failure. -> failures
(define (run-cells sources run)
  (for/fold ([failures (hasheq)]) ([source (in-list sources)])
    (define failure (run source))
    (for/fold ([failures failures]) ([name (in-list (defined-names source))])
      (if (and failure (not (defined? name)))
          (hash-set failures name failure)
          (hash-remove failures name)))))

;; ---------------------------------------------------------------------------

;; (define name ...), (define ((name a) b) ...) -> name, or #f
(define (name-defined form)
  (define (head x) (if (pair? x) (head (car x)) x))
  (define found
    (and (list? form) (pair? form) (eq? 'define (car form)) (pair? (cdr form)) (head (cadr form))))
  (and (symbol? found) found))

;; ---------------------------------------------------------------------------

;; answer-of : value of the name -> data.  For a name that is not defined, its failure or
;; `otherwise`.
(define (answer-in p name answer-of otherwise)
  (define failure (hash-ref (program-failures p) name #f))
  (with-handlers ([void (lambda (x) (list 'failed (reason x)))])
    (call-in-sandbox-context
     (program-evaluator p)
     (lambda ()
       (cond [failure (list 'failed failure)]
             [(defined? name)
              (match (answer-of (eval name))
                [(list 'failed text) (list 'failed (in-readers-words text))]
                [d d])]
             [else otherwise])))))

;; Has the program ended itself, by `exit` or by taking too much?
(define (program-ended? p) (not (evaluator-alive? (program-evaluator p))))

(define (defined? name)
  (identifier-binding (namespace-symbol->identifier name) 0 #t))

;; The value x is asked for its message only if it is an exception of Racket's, and it is not
;; printed.
(define (reason x)
  (cond [(out-of-bounds? x) "it took too long, or too much memory, or ended itself"]
        [(and (exn? x) (string? (exn-message x))) (in-readers-words ((failure-words) x))]
        [else "it raised what is no error"]))

(define (out-of-bounds? x) (or (exn:fail:resource? x) (exn:fail:sandbox-terminated? x)))

;; The student does not call the program `program`.
(define (in-readers-words text)
  (regexp-replaces
   text
   '([#px"^program:(\\d+):\\d+: " "line \\1: "]
     [#px"^(\\S+): undefined;\n cannot reference an identifier before its def.*$"
      "\\1 is not defined; as a symbol it is written '\\1"])))
