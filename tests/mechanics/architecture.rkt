#lang racket/base
;; The floors of the house: who may require whom, read off the compiled modules,
;; and habits of the source that can be checked by reading it.
;;
;; Each rule is also run on a made-up violation, so that it is known to find one.

(require racket/file
         racket/list
         racket/path
         racket/runtime-path
         racket/set
         racket/string
         rackunit
         syntax/modcode
         syntax/modresolve)

;; ---------------------------------------------------------------------------
;; The plan

;; Lowest floor first.  A folder may require from the folders before it, on
;; floors below and on its own; `facade` stands for the files directly in
;; mechanics/.
(define floors
  '((error)
    (numeric algebra)
    (generic)
    (value)
    (verdict)
    (calculus)
    (search compile)
    (lagrangian motion force constraint map)
    (question)
    (display plot teach)
    (lang facade)
    (book)))

;; The book's objects are written in the language of its readers, above all else;
;; their facade is above the others with them.
(define high-facades '(("book.rkt" . book)))

;; Folders that know nothing of others, though those are below them.
(define mechanics-proper '(lagrangian motion force constraint map question))
(define strangers `((display . ,mechanics-proper)))

(define-runtime-path library "../../mechanics")
(define-runtime-path fixture "runner/fixture/requiring.rkt")

(define longest-file 500)

;; ---------------------------------------------------------------------------
;; The graph of requires: file name -> names of the files it requires, at any
;; phase, from any submodule, lazily or not.

(define (library-files)
  (define root (simple-form-path library))
  (for/list ([p (in-list (find-files (lambda (p) (path-has-extension? p #".rkt")) root))]
             #:unless (equal? (path->string (file-name-from-path p)) "info.rkt"))
    (path->string (find-relative-path root p))))

(define (full-path name) (build-path (simple-form-path library) name))

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

;; These leave no trace in the compiled requires.
(define (lazy-imports path)
  (define (requirable? clause) (and (pair? clause) (not (eq? (car clause) 'file))))
  (define (paths form)
    (cond [(not (pair? form)) '()]
          [(and (memq (car form) '(lazy-require provide-on-demand)) (list? form)
                (andmap requirable? (cdr form)))
           (for/list ([clause (in-list (cdr form))])
             (file-of (resolve-module-path (car clause) path)))]
          [else (append (paths (car form)) (paths (cdr form)))]))
  (paths (syntax->datum (read-file path))))

(define (file-of resolved)
  (cond [(path? resolved) resolved]
        [(and (pair? resolved) (path? (cadr resolved))) (cadr resolved)]
        [else #f]))

(define (library-name path)
  (define relative
    (path->string (find-relative-path (simple-form-path library) (simple-form-path path))))
  (and (not (string-prefix? relative ".."))
       (relative-path? relative)
       relative))

;; ---------------------------------------------------------------------------
;; Rules on the graph, each a list of sentences: what is wrong

(define (folder name)
  (cond [(assoc name high-facades) => cdr]
        [(facade? name) 'facade]
        [else (string->symbol (path->string (car (explode-path name))))]))

(define (facade? name) (null? (cdr (explode-path name))))

(define folder-order (append* floors))

(define (unknown-folders graph)
  (for/list ([name (in-hash-keys graph)]
             #:unless (memq (folder name) folder-order))
    (format "~a is on no floor" name)))

(define (upward-requires graph)
  (for*/list ([(name required) (in-hash graph)]
              [other (in-list required)]
              #:unless (may-require? (folder name) (folder other)))
    (format "~a requires ~a" name other)))

(define (may-require? folder other)
  (and (memq folder (or (memq other folder-order) '()))
       (not (memq other (cond [(assq folder strangers) => cdr] [else '()])))))

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

;; ---------------------------------------------------------------------------
;; Rules on the source, each (name module-form) -> sentences

(define (read-module port name)
  (parameterize ([read-accept-reader #t]
                 [read-accept-lang #t])
    (port-count-lines! port)
    (read-syntax name port)))

(define (read-file path)
  (call-with-input-file path (lambda (port) (read-module port path))))

;; All parts of a form for which (find part) is not #f, with line numbers.
(define (findings name form find)
  (let walk ([s form])
    (define here (and (syntax? s) (find s)))
    (define parts (if (syntax? s) (syntax-e s) s))
    (append (if here (list (format "~a:~a: ~a" name (syntax-line s) here)) '())
            (if (pair? parts)
                (append (walk (car parts)) (walk (cdr parts)))
                '()))))

(define (head? s name)
  (define parts (syntax-e s))
  (and (pair? parts) (syntax? (car parts)) (eq? (syntax-e (car parts)) name)))

;; The datum of the part with this index.
(define (part s index)
  (define parts (syntax->datum s))
  (and (list? parts) (> (length parts) index) (list-ref parts index)))

(define (wholesale-provides name form)
  (findings name form
            (lambda (s) (and (eq? (syntax-e s) 'all-defined-out)
                             "all-defined-out hides what the module is for"))))

(define (bare-errors name form)
  (findings name form
            (lambda (s) (and (head? s 'error) (string? (part s 1))
                             "(error \"...\") does not say who complains"))))

(define (dynamic-requires name form)
  (if (eq? (folder name) 'lang)
      '()
      (findings name form
                (lambda (s) (and (head? s 'dynamic-require)
                                 "dynamic-require hides a dependency; use lazy-require")))))

;; Racket itself refuses set! on what is imported.
(define (assigned-exports name form)
  (define exported (exported-names (syntax->datum form)))
  (findings name form
            (lambda (s) (and (head? s 'set!) (memq (part s 1) exported)
                             (format "set! on ~a, which is exported" (part s 1))))))

(define (exported-names form)
  (define (names spec)
    (cond [(symbol? spec) (list spec)]
          [(and (pair? spec) (eq? (car spec) 'rename-out)) (map car (cdr spec))]
          [else '()]))
  (cond [(not (pair? form)) '()]
        [(and (eq? (car form) 'provide) (list? form)) (append-map names (cdr form))]
        [else (append (exported-names (car form)) (exported-names (cdr form)))]))

(define facade-forms '(require provide module module* module+))

;; A facade only requires and provides; submodules serve the reader and the
;; printer.
(define (facade-code name form)
  (if (facade? name)
      (for/list ([s (in-list (module-body form))]
                 #:unless (and (pair? (syntax-e s))
                               (memq (syntax-e (car (syntax-e s))) facade-forms)))
        (format "~a:~a: a facade holds only require and provide" name (syntax-line s)))
      '()))

;; (module name language form ...), where the forms may be in a #%module-begin.
(define (module-body form)
  (define forms (cdddr (syntax->list form)))
  (if (and (= (length forms) 1)
           (regexp-match? #rx"module-begin"
                          (format "~a" (part (car forms) 0))))
      (cdr (syntax->list (car forms)))
      forms))

(define source-rules
  (list wholesale-provides bare-errors dynamic-requires assigned-exports facade-code))

;; ---------------------------------------------------------------------------
;; The rules find made-up violations

(define (check-sentences rule argument expected)
  (check-equal? (sort (rule argument) string<?) expected))

(test-case "a require from a higher floor is found"
  (define graph
    (hash "numeric/a.rkt" '("value/b.rkt")      ; two floors up
          "value/b.rkt" '("numeric/c.rkt")
          "numeric/c.rkt" '("algebra/d.rkt")    ; to the other half of the floor
          "algebra/d.rkt" '("main.rkt")         ; to a facade
          "display/e.rkt" '("value/b.rkt" "lagrangian/f.rkt")
          "lagrangian/f.rkt" '("calculus/g.rkt")
          "main.rkt" '("display/e.rkt" "book.rkt")
          "book.rkt" '("book/h.rkt")
          "book/h.rkt" '("main.rkt")))
  (check-sentences upward-requires graph
                   '("algebra/d.rkt requires main.rkt"
                     "display/e.rkt requires lagrangian/f.rkt"
                     "main.rkt requires book.rkt"
                     "numeric/a.rkt requires value/b.rkt"
                     "numeric/c.rkt requires algebra/d.rkt")))

(test-case "a circle is found, and what only leads to it is not blamed"
  (check-sentences circles
                   (hash "value/a.rkt" '("value/b.rkt") "value/b.rkt" '("value/c.rkt")
                         "value/c.rkt" '("value/a.rkt") "value/d.rkt" '("value/a.rkt"))
                   '("value/a.rkt requires itself in the end"
                     "value/b.rkt requires itself in the end"
                     "value/c.rkt requires itself in the end")))

(test-case "a folder without a floor is found"
  (check-sentences unknown-folders (hash "value/a.rkt" '() "attic/b.rkt" '() "main.rkt" '())
                   '("attic/b.rkt is on no floor")))

(test-case "habits to avoid are found where they stand"
  (define (of rule name text)
    (rule name (read-module (open-input-string (string-append "#lang racket/base\n" text)) name)))
  (check-equal? (of wholesale-provides "value/a.rkt" "(provide (all-defined-out))")
                '("value/a.rkt:2: all-defined-out hides what the module is for"))
  (check-equal? (of bare-errors "value/a.rkt" "(define (f)\n (error \"no\"))\n(error 'f \"yes\")")
                '("value/a.rkt:3: (error \"...\") does not say who complains"))
  (check-equal? (of dynamic-requires "value/a.rkt" "(dynamic-require 'x 'y)")
                '("value/a.rkt:2: dynamic-require hides a dependency; use lazy-require"))
  (check-equal? (of assigned-exports "value/a.rkt"
                    "(provide a (rename-out [b c]))\n(set! a 1)\n(set! b 1)\n(set! d 1)")
                '("value/a.rkt:3: set! on a, which is exported"
                  "value/a.rkt:4: set! on b, which is exported"))
  (define facade "(require \"x.rkt\")\n(provide a)\n(module reader racket/base 1)\n(define a 1)")
  (check-equal? (of facade-code "main.rkt" facade)
                '("main.rkt:5: a facade holds only require and provide"))
  (check-equal? (of facade-code "book.rkt" facade)
                '("book.rkt:5: a facade holds only require and provide"))
  (check-equal? (of facade-code "value/main.rkt" facade) '()))

(test-case "requires are read at every phase, from submodules, and when lazy"
  (define names
    (map (lambda (p) (path->string (file-name-from-path p)))
         (imports (simple-form-path fixture))))
  (for ([name '("class.rkt" "list.rkt" "string.rkt" "lazy-require.rkt" "date.rkt")])
    (check-not-false (member name names) name)))

;; ---------------------------------------------------------------------------
;; The library

(define names (library-files))

(define complaints
  (for*/hash ([name (in-list names)]
              [complaint (in-value (compiler-complaint name))]
              #:when complaint)
    (values name complaint)))

(define graph (require-graph (remove* (hash-keys complaints) names)))

(test-case "every file compiles"
  (check-equal? complaints (hash)))

(test-case "the library is there and its requires are seen"
  (check-not-false (member "algebra/expression/expression.rkt" names))
  (check-not-false (member "algebra/expression/operation.rkt"
                           (hash-ref graph "algebra/expression/expression.rkt"))))

(test-case "every folder is on a floor"
  (check-equal? (unknown-folders graph) '()))

(test-case "no file requires from a floor above"
  (check-equal? (upward-requires graph) '()))

(test-case "there is no circle"
  (check-equal? (circles graph) '()))

(test-case "the source keeps to the habits"
  (for ([name (in-list names)])
    (define form (read-file (full-path name)))
    (for ([rule (in-list source-rules)])
      (check-equal? (rule name form) '()))))

(test-case "no file is longer than 500 lines"
  (for ([name (in-list names)])
    (check-true (<= (length (file->lines (full-path name))) longest-file) name)))
