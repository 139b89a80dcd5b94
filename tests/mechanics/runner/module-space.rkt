#lang racket/base
;; A namespace for each test file: every module has an instance of its own there, as in a
;; process of its own, but its code is read once for all files.
;;
;; `store` holds declarations alone.  Whoever asks for a module in a file's namespace has it
;; declared in the store first, with all that it requires, and gets the declarations from there.
;; rackunit is one instance for all files, for it counts.

(provide make-module-space          ; path of a test -> module-space
         module-space-namespace module-space-resolver
         files-loaded)              ; module-space, (path -> boolean) -> (listof path)

;; namespace, resolver : for the parameters current-namespace and current-module-name-resolver
;; modules : hash, its keys the paths of all modules that were asked for by name
(struct module-space (namespace resolver modules))

;; test : the file, which tells its namespace from others that it makes
(define (make-module-space test)
  (define namespace (new-namespace))
  (define modules (make-hash))
  ;; -> is the module there, so that nothing is left to load?
  (define (prepare module)
    (define here? (eq? (current-namespace) namespace))
    (and (or here? (module-declared? test #f))
         (begin (hash-set! modules module #t)
                (declare module namespace))
         here?))
  (module-space namespace (resolver-with prepare) modules))

(define shared '(racket/base rackunit rackunit/log))

(for ([module (in-list shared)]) (dynamic-require module #f))
(define runner (current-namespace))

(define (new-namespace)
  (define namespace (make-base-empty-namespace))
  (for ([module (in-list shared)]) (namespace-attach-module runner module namespace))
  namespace)

(define store (new-namespace))

;; In the namespace, by way of the store; what cannot be read is left to whoever asked for it.
;; -> is it there?
(define (declare module namespace)
  (or (parameterize ([current-namespace namespace]) (module-declared? module #f))
      (and (in-store? module)
           (begin (namespace-attach-module-declaration store module namespace) #t))))

(define (in-store? module)
  (parameterize ([current-namespace store])
    (with-handlers ([exn:fail? (lambda (_) #f)])
      (and (module-declared? module #t)
           (begin (dynamic-require module (void)) #t)))))

;; A module name resolver that calls `prepare` with the path of a module before it is loaded, if it
;; is to be loaded then.
(define (resolver-with prepare)
  (define standard (current-module-name-resolver))
  (case-lambda
    [(name from) (standard name from)]
    [(path relative-to syntax load?)
     (define name (standard path relative-to syntax #f))
     (define module (and load? (path-of name)))
     (define ready?
       (and module (parameterize ([current-module-name-resolver standard]) (prepare module))))
     (if (or ready? (not load?)) name (standard path relative-to syntax load?))]))

;; The module path of a name, #f for a module without a file.
(define (path-of name)
  (define path (resolved-module-path-name name))
  (cond [(path? path) path]
        [(and (pair? path) (path? (car path))) `(submod ,@path)]
        [else #f]))

;; ---------------------------------------------------------------------------

;; The files of the modules that were asked for, and of all that these require; only those that
;; are `wanted?`, and what those require.
(define (files-loaded space wanted?)
  (define seen (make-hash))
  (define (visit module)
    (unless (or (hash-ref seen module #f) (not (wanted? (file-of module))))
      (hash-set! seen module #t)
      (for-each visit (imports module))))
  (parameterize ([current-namespace store])
    (for-each visit (hash-keys (module-space-modules space))))
  (hash-keys (for/hash ([module (in-hash-keys seen)]) (values (file-of module) #t))))

(define (file-of module) (if (pair? module) (cadr module) module))

;; module -> paths of the modules that it requires for any phase
(define imports
  (let ([known (make-hash)])
    (lambda (module) (hash-ref! known module (lambda () (read-imports module))))))

(define (read-imports module)
  (define self (make-resolved-module-path (if (pair? module) (cdr module) module)))
  (for*/list ([phase (in-list (if (module-declared? module #f) (module->imports module) '()))]
              #:when (car phase)
              [index (in-list (cdr phase))]
              [path (in-value (path-of (resolve index self)))]
              #:when path)
    path))

(define (resolve index self)
  (define-values (path _) (module-path-index-split index))
  (module-path-index-resolve (module-path-index-join path self)))
