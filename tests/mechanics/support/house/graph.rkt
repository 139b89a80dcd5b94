#lang racket/base
;; Who requires whom, read off the compiled modules, and what is wrong with it.
;;
;; A graph is a hash from the name of a file to the names of the files it requires, at any
;; phase, from any submodule; what it loads on demand, a submodule of it requires
;; (generic/on-demand.rkt).  A rule gives sentences: what is wrong.

(require racket/list
         racket/path
         racket/set
         racket/string
         syntax/modcode
         syntax/modresolve
         "library.rkt"
         "map.rkt")

(provide require-graph imports on-demand-imports compiler-complaint
         unplaced-files upward-requires circles)

;; The compiler's complaint about a file, or #f.
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
  (remove-duplicates
   (for*/list ([code (in-list (with-submodules (get-module-code path)))]
               [import (in-list (module-imports code path))])
     import)))

;; Of those that it loads on demand.
(define (on-demand-imports path)
  (for*/list ([code (in-list (with-submodules (get-module-code path)))]
              #:when (equal? (last-name code) 'compiled-too)
              [import (in-list (module-imports code path #:phase #f))])
    import))

(define (with-submodules code)
  (cons code (append-map with-submodules (append (module-compiled-submodules code #t)
                                                 (module-compiled-submodules code #f)))))

(define (last-name code)
  (define name (module-compiled-name code))
  (if (pair? name) (last name) name))

(define (module-imports code path #:phase [wanted 'any])
  (for*/list ([phase (in-list (module-compiled-imports code))]
              #:when (memv wanted (list 'any (car phase)))
              [index (in-list (cdr phase))]
              [import (in-value (file-of (resolve-module-path-index index path)))]
              #:when import)
    import))

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
