#lang racket/base
;; Modules that `(require mechanics)` loads, at any phase, and effects of
;; loading.  Loading is most of what a user waits for at the start, and a library
;; that prints or sets parameters is a nuisance in a program.

;; for-label: compiled with this file.  Modules that an expansion loads would be counted.
(require (for-label mechanics mechanics/base mechanics/book)
         racket/list
         racket/path
         racket/runtime-path
         racket/string
         rackunit
         syntax/modresolve
         "support/house/graph.rkt"
         "support/house/library.rkt"
         "support/skip.rkt"
         (only-in "../../mechanics/show/plot/on-demand.rkt" can-draw?))

(define-runtime-path loud "runner/fixture/loud.rkt")

;; ---------------------------------------------------------------------------
;; Modules that must not be loaded

(define unwanted-modules
  '(racket/contract racket/generic racket/struct racket/set racket/hash racket/math
    racket/class racket/unit file/convertible syntax/parse))

(define unwanted-folders
  '("racket/contract" "racket/gui" "racket/draw" "math" "plot" "pict" "scribble"
    "typed-racket" "typed" "rackunit" "syntax/parse"))

;; Rooms of our own that are behind an on-demand.rkt.  Of others some files are needed at
;; once: of those, what is asked for on demand must not be.
(define rooms-on-demand
  '("algebra/polynomial" "algebra/kernel" "algebra/field" "algebra/simplify"
    "algebra/presentation" "algebra/rewriting" "algebra/solve" "algebra/zero"
    "constraint" "force" "dynamics" "rigid" "show/plot" "show/explorer" "numeric/optimization"
    "numeric/bigfloat" "algebra/ball" "teaching/worksheet" "teaching/class"))

(define files-on-demand (append-map on-demand-imports (map full-path (library-files))))

;; racket/match comes with parts of syntax/parse for-syntax.  It is wanted, once.
(define allowed 'racket/match)

;; ---------------------------------------------------------------------------
;; Tracing

;; The files loaded by requiring a module into a namespace where there is only racket/base, and by
;; what is done there afterwards.
(define (loaded module-path [do void])
  (define files '())
  (define load (current-load/use-compiled))
  (define (note path name)
    (set! files (cons path files))
    (load path name))
  (parameterize ([current-namespace (make-base-empty-namespace)]
                 [current-load/use-compiled note])
    (dynamic-require module-path #f)
    (do))
  (remove-duplicates files))

(define (unwanted files)
  (define modules
    (append files-on-demand
            (for/list ([m unwanted-modules]) (resolve-module-path m #f))))
  (define folders
    (append (filter values (map existing-collection unwanted-folders))
            (map full-path rooms-on-demand)))
  (for/list ([file (remove* (loaded allowed) files)]
             #:unless (equal? (path->string (file-name-from-path file)) "on-demand.rkt")
             #:when (or (member file modules)
                        (ormap (lambda (folder) (inside? file folder)) folders)))
    (path->string file)))

(define (existing-collection name)
  (define parts (string-split name "/"))
  (apply collection-path parts #:fail (lambda (message) #f)))

(define (inside? file folder)
  (string-prefix? (path->string file)
                  (path->string (path->directory-path folder))))

;; ---------------------------------------------------------------------------
;; Effects of loading

(define (settings)
  (list (current-print) (current-read-interaction) (current-prompt-read)
        (error-display-handler) (error-value->string-handler)
        (error-print-width) (uncaught-exception-handler) (exit-handler)
        (global-port-print-handler)
        (port-print-handler (current-output-port))
        (port-write-handler (current-output-port))
        (port-display-handler (current-output-port))
        (current-load) (current-eval) (current-compile)
        (print-as-expression) (print-graph) (print-struct)
        (current-command-line-arguments)
        (pseudo-random-generator->vector (current-pseudo-random-generator))))

;; The output of loading, and whether all settings are as before.
(define (effects module-path)
  (define out (open-output-string))
  (parameterize ([current-output-port out]
                 [current-error-port out]
                 [current-print (current-print)]
                 [current-namespace (make-base-empty-namespace)])
    (define before (settings))
    (dynamic-require module-path #f)
    (values (get-output-string out) (equal? before (settings)))))

;; ---------------------------------------------------------------------------

(test-case "unwanted modules are found, in a folder or by themselves"
  (check-equal? (unwanted (loaded 'racket/list)) '())
  (check-equal? (unwanted (loaded 'racket/match)) '())
  (check-not-equal? (unwanted (loaded 'racket/set)) '())
  (check-not-equal? (unwanted (loaded 'racket/hash)) '())
  (check-not-equal? (unwanted (loaded 'racket/math)) '())
  (check-not-equal? (unwanted (loaded 'file/convertible)) '())
  (check-not-equal? (unwanted (loaded 'syntax/parse)) '()))

(test-case "a room of our own that is loaded on demand is found, and a file of one that is not"
  (define (found name) (filter (lambda (file) (string-suffix? file name))
                               (unwanted (loaded (full-path name)))))
  (for ([name '("algebra/polynomial/ring.rkt" "show/plot/view.rkt" "motion/find-path.rkt")])
    (check-equal? (length (found name)) 1 name))
  (check-equal? (found "motion/method-names.rkt") '())
  (for ([room rooms-on-demand])
    (check-true (directory-exists? (full-path room)) room)))

(test-case "printing and setting a parameter are noticed"
  (define-values (printed same?) (effects loud))
  (check-equal? printed "hello\n")
  (check-false same?))

(for ([module-path '(mechanics mechanics/base mechanics/book)])
  (test-case (format "requiring ~a loads nothing heavy" module-path)
    (check-equal? (unwanted (loaded module-path)) '()))
  (test-case (format "requiring ~a prints nothing and sets nothing" module-path)
    (define-values (printed same?) (effects module-path))
    (check-equal? printed "")
    (check-true same?)))

;; pict alone takes as much memory as all the rest of a first picture.
(skip-unless (can-draw?) "the shared libraries of racket/draw are not installed: no pictures"
  (test-case "a first picture loads neither Typed Racket nor pict"
    (define (draw)
      (define f ((dynamic-require 'mechanics/plot 'frame) 0 1 0 1))
      ((dynamic-require 'mechanics/plot 'plot-function) f sin 0 1)
      (for ([format '(png-bytes svg-bytes pdf-bytes)])
        (check-pred bytes? ((dynamic-require 'file/convertible 'convert) f format))))
    (define files (loaded 'mechanics/plot draw))
    (define (from folder)
      (define path (existing-collection folder))
      (if path (filter (lambda (file) (inside? file path)) files) '()))
    (check-not-equal? (from "racket/draw") '())
    (for ([folder '("typed-racket" "typed" "plot" "math" "pict")])
      (check-equal? (from folder) '() folder))))
