#lang racket/base
;; The companion to the book in a browser: every example, every worksheet and every page of the
;; guide as a notebook with its results, and a notebook that lists them:
;;
;;     racket notebooks.rkt [--jobs N] [--only text] folder
;;
;; Each is made in a process of its own (notebook-work.rkt), which compares what the notebook shows
;; with what it is made of.  A notebook that is newer than its source stays as it is, with what a
;; reader changed in it.

(require compiler/find-exe
         racket/cmdline
         racket/file
         racket/list
         racket/path
         racket/port
         racket/runtime-path
         racket/string
         "compile.rkt"
         mechanics/lang/help/program-heading
         mechanics/show/notebook/notebook-file mechanics/show/notebook/program-cells)

(define-runtime-path examples "../examples/mechanics")
(define-runtime-path guide "../scribblings/mechanics/guide.scrbl")
(define-runtime-path guide-notebook "../scribblings/mechanics/guide-notebook.rkt")
(define-runtime-path work "notebook-work.rkt")

;; kind : program, worksheet or page; name : of the notebook, with its folder; title : text
;; source : path; more : further arguments for its process
(struct task (kind name title source more))

;; ---------------------------------------------------------------------------
;; The tasks

;; The tour of `make demo` reads its own file; scripts write files.
(define (a-notebook? file)
  (and (not (equal? "demo.rkt" (path->string (file-name-from-path file))))
       (call-with-input-file file
         (lambda (in) (regexp-match? #px"(?m:^#lang mechanics(?:/worksheet)?$)" in)))))

(define (example-tasks)
  (for/list ([file (in-list (sort (files-under (simplify-path examples)) path<?))]
             #:when (a-notebook? file))
    (define name (path-replace-extension (find-relative-path (simplify-path examples) file) #""))
    (task (if (regexp-match? #rx"^worksheets" (path->string name)) 'worksheet 'program)
          (path->string name) (program-heading file) file '())))

;; folder : where the pages are written, without results
(define (page-tasks folder)
  (define-values (pages page-name page-title page-cells page-failing)
    (apply values
           (for/list ([name '(guide-pages guide-page-name guide-page-title guide-page-cells
                                          guide-page-failing)])
             (dynamic-require guide-notebook name))))
  (for/list ([p (in-list (pages guide))])
    (define cells (page-cells p))
    (define file (build-path folder (string-append (page-name p) ".ipynb")))
    (write-bytes-to (notebook->bytes usual-header cells) file)
    (define failing
      (for/list ([c (in-list cells)] [k (in-naturals)] #:when (memq c (page-failing p)))
        (number->string k)))
    (task 'page (format "guide/~a" (page-name p)) (page-title p) file failing)))

(define (write-bytes-to bytes file)
  (make-parent-directory* file)
  (call-with-output-file file #:exists 'truncate (lambda (out) (write-bytes bytes out)))
  (void))

;; ---------------------------------------------------------------------------
;; Work

(define (notebook-of folder t) (build-path folder (string-append (task-name t) ".ipynb")))

(define (made? folder t)
  (define file (notebook-of folder t))
  (and (file-exists? file)
       (> (file-or-directory-modify-seconds file)
          (apply max (map file-or-directory-modify-seconds (sources t))))))

(define (sources t)
  (if (eq? (task-kind t) 'page)
      (find-files (lambda (p) (path-has-extension? p #".scrbl")) (path-only guide))
      (list (task-source t))))

;; -> #f, or what is wrong with it
(define (make-one folder t)
  (make-parent-directory* (notebook-of folder t))
  (define-values (process out in err)
    (apply subprocess #f #f #f (find-exe) work
           (symbol->string (task-kind t)) (path->string (task-source t))
           (path->string (notebook-of folder t)) (task-more t)))
  (close-output-port in)
  (define said (port->string out))
  (define complaint (port->string err))
  (subprocess-wait process)
  (and (not (eqv? 0 (subprocess-status process))) (string-trim (string-append said complaint))))

;; -> hash from those tasks that went wrong to why
(define (make-all folder tasks jobs)
  (define seats (make-semaphore jobs))
  (define done (make-channel))
  (for ([t (in-list tasks)])
    (thread (lambda ()
              (define why (call-with-semaphore seats (lambda () (make-one folder t))))
              (channel-put done (cons t why)))))
  (define start (current-seconds))
  (begin0
    (for/fold ([wrong (hasheq)]) ([k (in-range 1 (+ 1 (length tasks)))])
      (define result (channel-get done))
      (when (or (terminal-port? (current-output-port)) (= 0 (remainder k 25)))
        (show-progress (format "  ~a of ~a, ~a s" k (length tasks) (- (current-seconds) start))))
      (if (cdr result) (hash-set wrong (car result) (cdr result)) wrong))
    (end-progress)))

;; ---------------------------------------------------------------------------
;; The list of all

(define (index-cells tasks)
  (define (line t) (format "- [~a](~a.ipynb)" (Markdown-escaped (task-title t)) (task-name t)))
  (define (chapter title tasks)
    (cell 'markdown (string-join (list* (format "## ~a" title) "" (map line tasks)) "\n") #f #f))
  (define (of kind) (filter (lambda (t) (eq? (task-kind t) kind)) tasks))
  (define (folder-of t) (car (regexp-match #rx"^[^/]*" (task-name t))))
  (append
   (list (cell 'markdown "# Classical mechanics in notebooks" #f #f)
         (chapter "The guide" (of 'page))
         (chapter "Worksheets, to be answered" (of 'worksheet)))
   (for/list ([group (in-list (group-by folder-of (of 'program)))])
     (chapter (format "Programs: ~a" (folder-of (car group))) group))))

;; ---------------------------------------------------------------------------

;; -> is all well?
(define (make-notebooks folder jobs only)
  (define start (current-seconds))
  (printf "Reading the guide ...\n")
  (define all (append (page-tasks (build-path folder ".pages")) (example-tasks)))
  (define chosen
    (filter (lambda (t) (and (string-contains? (task-name t) only) (not (made? folder t)))) all))
  (printf "Running ~a notebooks, each in a process of its own ...\n" (length chosen))
  (define wrong (make-all folder chosen jobs))
  (define index (build-path folder "index.ipynb"))
  (write-bytes-to (notebook->bytes usual-header (index-cells all)) index)
  (for ([(t why) (in-hash wrong)]) (eprintf "~a: ~a\n" (task-name t) why))
  (define (count-of kind) (count (lambda (t) (eq? (task-kind t) kind)) chosen))
  (printf (string-append "~a programs, ~a worksheets, ~a pages of the guide in ~a s; "
                         "~a as they should be, ~a not\nThe list of them is ~a\n")
          (count-of 'program) (count-of 'worksheet) (count-of 'page) (- (current-seconds) start)
          (- (length chosen) (hash-count wrong)) (hash-count wrong) index)
  (hash-empty? wrong))

(module+ main
  (define jobs 2)
  (define only "")
  (define folder
    (command-line
     #:once-each [("-j" "--jobs") n "make <n> at a time" (set! jobs (string->number n))]
     [("--only") text "those with <text> in their names" (set! only text)]
     #:args (folder) (path->complete-path folder)))
  (exit (if (make-notebooks folder jobs only) 0 1)))
