#lang racket/base
;; Modules that are loaded when something of theirs is first called.
;;
;;     (require-on-demand [file name ...] ...)
;;     (provide-on-demand [file name ...] ...)
;;
;; define the names, procedures all, and require a file when one of its is called; the
;; second provides them, too.  [name here] instead of a name calls it `here`.  A procedure
;; with keywords is to be made by `define-plain` (define-plain.rkt says why).
;;
;; Racket never takes up again modules that were left half made.  So a thread of its own
;; loads them: a break reaches the caller, who waits, at once, and the loading goes on,
;; even when the caller is killed.  A file whose body fails is not tried again: its
;; exception is raised at every call.  Another file that requires the one that failed finds it
;; half made, which Racket tells as a mismatch of compiled files: the first failure is raised.
;;
;;     (require-on-demand #:in-this-thread [file name ...] ...)
;;
;; is for libraries that take the thread they are loaded in for their own, as racket/gui
;; does with its events: the caller loads them, and breaks wait until that is done.

(require (for-syntax racket/base)
         racket/runtime-path)

(provide require-on-demand provide-on-demand)

(define-syntax-rule (provide-on-demand [file name ...] ...)
  (begin (require-on-demand [file name ...] ...)
         (provide name ... ...)))

;; A submodule that nobody loads requires the files, so that they are compiled with the
;; module that has the form; once in a module, therefore.
(define-syntax require-on-demand
  (syntax-rules ()
    [(_ #:in-this-thread clause ...) (require-clauses load-here clause ...)]
    [(_ clause ...) (require-clauses load-apart clause ...)]))

(define-syntax-rule (require-clauses load [file name ...] ...)
  (begin (module compiled-too racket/base
           (require (for-label (only-in file) ...)))
         (require-clause load [file name ...]) ...))

;; A runtime path, so that an executable has the file.
(define-syntax-rule (require-clause load [file name ...])
  (begin
    (define-runtime-module-path-index index 'file)
    (define wanted (source (#%variable-reference) index #f))
    (define (value-of exported) (load wanted exported))
    (define-on-demand value-of name) ...))

(define-syntax define-on-demand
  (syntax-rules ()
    [(_ value-of [name here]) (define here (called-later 'here (lambda () (value-of 'name))))]
    [(_ value-of name) (define-on-demand value-of [name name])]))

;; A procedure named `name`, which is the one that `load` gives.
(define (called-later name load)
  (define loaded #f)
  (define (it)
    (unless loaded (set! loaded (load)))
    loaded)
  (define call
    (case-lambda [(x) ((it) x)]
                 [(x y) ((it) x y)]
                 [arguments (apply (it) arguments)]))
  (define (call-with names values . arguments) (keyword-apply (it) names values arguments))
  (procedure-rename (make-keyword-procedure call-with call) name))

;; ---------------------------------------------------------------------------
;; Loading

;; place : variable reference of the module that asks; failure : the exception of loading, or #f
(struct source (place index [failure #:mutable]))

;; The value of a name, in the namespace of the module that asks: several may have the
;; library loaded.  The lock is that of everybody who loads into it at run time.
(define (load-here wanted name [begun void])
  (define space (variable-reference->namespace (source-place wanted)))
  (parameterize ([current-namespace space] [loading? #t])
    (namespace-call-with-registry-lock
     space
     (lambda ()
       (begun)
       (parameterize-break #f (load-once wanted name))))))

(define (load-once wanted name)
  (when (source-failure wanted) (raise (source-failure wanted)))
  (with-handlers ([(lambda (e) (not (exn:break? e)))
                   (lambda (e)
                     (define cause (first-cause e))
                     (set-source-failure! wanted cause)
                     (raise cause))])
    (dynamic-require (source-index wanted) name)))

;; The failure that left a module half made, or #f.
(define failed-first #f)

(define (first-cause e)
  (cond [(not (half-made? e)) (set! failed-first e) e]
        [else (or failed-first e)]))

(define (half-made? e)
  (and (exn:fail? e)
       (regexp-match? #rx"^instantiate-linklet: mismatch;\n reference to a variable that is unini"
                      (exn-message e))))

;; Does a file that is being loaded ask for another?  Its thread has the lock.
(define loading? (make-parameter #f))

;; As load-here, by a thread that nobody else knows.  If that does not get the lock soon,
;; the caller may be the one who holds it, and had better load by himself.
(define (load-apart wanted name)
  (define begun (make-semaphore))
  (define outcome #f)
  (define (load)
    (set! outcome
          (with-handlers ([void (lambda (e) (lambda () (raise e)))])
            (define value (load-here wanted name (lambda () (semaphore-post begun))))
            (lambda () value))))
  (unless (loading?)
    (define loader (start load))
    (when (sync/timeout patience begun) (sync loader)))
  (if outcome (outcome) (load-here wanted name)))

(define patience 0.1)            ; seconds

;; Modules live as long as their namespace: so the thread belongs to whoever had this one
;; loaded, and no limit that is set to a call ends it.
(define owner (current-custodian))

(define (start thunk)
  (define custodian (if (custodian-shut-down? owner) (current-custodian) owner))
  (parameterize ([current-custodian custodian])
    (parameterize-break #f (thread thunk))))
