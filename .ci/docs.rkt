#lang racket/base
;; Builds the manual in a folder, and says how far it is:
;;
;;     racket docs.rkt [--jobs N] folder
;;
;; Compiling is the most of the work; then the examples of each page are evaluated, and at last
;; pages are written.  Links to Racket's manuals lead to its site.

(require racket/cmdline
         racket/file
         racket/path
         racket/runtime-path
         scribble/html-render
         scribble/render
         setup/xref
         "compile.rkt")

(define-runtime-path manual "../scribblings/mechanics")
(define-runtime-path examples "../examples/mechanics")
(define main-page (build-path manual "mechanics.scrbl"))
(define site "https://docs.racket-lang.org/")

(define (pages)
  (find-files (lambda (p) (path-has-extension? p #".scrbl")) (simplify-path manual)))

(define (build folder jobs)
  (define files (map simplify-path (append (files-under examples) (pages))))
  (compile-files files jobs "the manual")
  (define page-files (append (remove (simplify-path main-page) (pages)) (list main-page)))
  (define n (length page-files))
  (printf "Evaluating the examples of ~a pages ...\n" n)
  (define done 0)
  (with-progress
   (lambda (seconds) (format "  ~a of ~a pages, ~a s" done n seconds))
   (lambda ()
     (for ([page (in-list page-files)])
       (dynamic-require page #f)
       (set! done (+ done 1)))))
  (printf "Writing the pages ...\n")
  (with-progress
   (lambda (seconds) (format "  ~a s" seconds))
   (lambda () (write-pages (dynamic-require main-page 'doc) folder))))

;; Of undefined tags those are told that some page points to: not the places where a name is
;; looked for first, which begin with dep.
(define (write-pages doc folder)
  (define said (open-output-string))
  (parameterize ([current-error-port said]) (render-pages doc folder))
  (define lines (regexp-split #rx"\n" (get-output-string said)))
  (define (of-weight? line) (not (regexp-match? #rx"^ [(]dep |^$|^Warning: some cross ref" line)))
  (for ([line (in-list lines)] #:when (of-weight? line)) (eprintf "~a\n" line)))

(define (render-pages doc folder)
  (render (list doc) (list "mechanics")
          #:dest-dir folder
          #:render-mixin (lambda (%) (render-multi-mixin (render-mixin %)))
          #:xrefs (list (load-collections-xref))
          #:redirect-main site
          #:quiet? #t
          #:warn-undefined? #t))

(define (with-progress text thunk)
  (define start (current-seconds))
  (define reporter
    (thread (lambda ()
              (let loop ()
                (sleep (if (terminal-port? (current-output-port)) 1/2 5))
                (show-progress (text (- (current-seconds) start)))
                (loop)))))
  (dynamic-wind void thunk (lambda () (kill-thread reporter) (end-progress))))

(module+ main
  (define jobs 2)
  (define folder
    (command-line
     #:once-each [("-j" "--jobs") n "compile <n> files at a time" (set! jobs (string->number n))]
     #:args (folder) folder))
  (build folder jobs))
