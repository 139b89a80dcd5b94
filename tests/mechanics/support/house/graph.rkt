#lang racket/base
;; Who requires whom, read off the compiled modules, and what is wrong with it.
;;
;; A graph is a hash from the name of a file to the names of the files it requires, at any
;; phase, from any submodule, lazily or not.  A rule gives sentences: what is wrong.

(require racket/list
         racket/path
         racket/set
         racket/string
         syntax/modcode
         syntax/modresolve
         "library.rkt"
         "map.rkt")

(provide require-graph imports compiler-complaint
         unplaced-files upward-requires circles)

;; What the compiler has to say against a file, or #f.
(define (compiler-complaint name)
  (with-handlers ([exn:fail? exn-message])
    (get-module-code (full-path name))
    #f))

(define (require-graph names)
  (for/hash ([name (in-list names)])
    (values name (remove* (list name)
                          (filter values (map library-name (imports (full-path name))))))))

;; Complete paths of the files a file requires.
(define (imports path)
  (define (paths code)
    (append
     (for*/list ([phase (in-list (module-compiled-imports code))]
                 [index (in-list (cdr phase))]
                 [path (in-value (file-of (resolve-module-path-index index path)))]
                 #:when path)
       path)
     (append-map paths (append (module-compiled-submodules code #t)
                               (module-compiled-submodules code #f)))))
  (remove-duplicates (append (paths (get-module-code path)) (lazy-imports path))))

(define on-demand-forms '(require-on-demand provide-on-demand))

;; These leave no trace in the compiled requires.
(define (lazy-imports path)
  (define (paths form)
    (cond [(not (pair? form)) '()]
          [(and (memq (car form) on-demand-forms) (list? form) (andmap clause? (cdr form)))
           (for/list ([clause (in-list (cdr form))])
             (file-of (resolve-module-path (car clause) path)))]
          [else (append (paths (car form)) (paths (cdr form)))]))
  (paths (syntax->datum (read-file path))))

;; Is it a clause of such a form, and not of the macro that makes one?
(define (clause? x)
  (and (pair? x)
       (or (string? (car x))
           (and (symbol? (car x)) (regexp-match? #rx"/" (symbol->string (car x)))))))

(define (file-of resolved)
  (cond [(path? resolved) resolved]
        [(and (pair? resolved) (path? (cadr resolved))) (cadr resolved)]
        [else #f]))

(define (library-name path)
  (define relative
    (path->string (find-relative-path library-root (simple-form-path path))))
  (and (not (string-prefix? relative ".."))
       (relative-path? relative)
       relative))

;; ---------------------------------------------------------------------------
;; Rules

(define (unplaced-files graph [rooms rooms])
  (for/list ([name (in-hash-keys graph)]
             #:unless (room-of name rooms))
    (format "~a is in no room of the map" name)))

;; strangers : ((room-prefix prefix ...) ...): rooms that know nothing of others, though
;; those are below them
(define (upward-requires graph strangers [rooms rooms])
  (for*/list ([(name required) (in-hash graph)]
              [other (in-list required)]
              #:unless (may-require? name other strangers rooms))
    (format "~a requires ~a" name other)))

(define (may-require? name other strangers rooms)
  (define above (room-of name rooms))
  (define below (room-of other rooms))
  (and above below
       (>= above below)
       (not (for/or ([s (in-list strangers)])
              (and (string-prefix? name (car s))
                   (ormap (lambda (prefix) (string-prefix? other prefix)) (cdr s)))))))

;; A file is in a circle if it can be reached from what it requires.
(define (circles graph)
  (define (reachable from)
    (let loop ([to-do from] [seen (set)])
      (cond [(null? to-do) seen]
            [(set-member? seen (car to-do)) (loop (cdr to-do) seen)]
            [else (loop (append (hash-ref graph (car to-do) '()) (cdr to-do))
                        (set-add seen (car to-do)))])))
  (for/list ([(name required) (in-hash graph)]
             #:when (set-member? (reachable required) name))
    (format "~a requires itself in the end" name)))
