#lang racket/base
;; How `make` compiles, and what it says meanwhile.

(require compiler/cm
         racket/file
         racket/port
         "support/checks.rkt" "support/folder.rkt"
         (file "../../.ci/DrRacket-files.rkt")
         (file "../../.ci/compile.rkt"))

(define (call-with-modules n f)
  (with-folder (folder)
    (f (for/list ([i n])
         (define file (build-path folder (format "m~a.rkt" i)))
         (display-to-file (format "(module m~a '#%kernel ~a)" i i) file)
         file))))

(define (compiled? file)
  (define-values (folder name directory?) (split-path file))
  (file-exists? (build-path folder "compiled" (path-add-extension name #".zo" #"_"))))

(define (said files what)
  (with-output-to-string (lambda () (compile-files files 2 what))))

(for ([n '(3 20)])
  (test-case (format "~a files are compiled, and it is said at once that they are" n)
    (call-with-modules
     n
     (lambda (files)
       (check-regexp-match (format "^Compiling ~a files of the tests ...\n" n)
                           (said files "the tests"))
       (for ([file (in-list files)]) (check-true (compiled? file) (path->string file)))))))

(test-case "where nothing is wanted nothing is said"
  (call-with-modules 3 (lambda (files) (check-equal? (said files #f) ""))))

(for ([n '(3 20)])
  (test-case (format "one of ~a files that does not compile leaves the others to be compiled" n)
    (call-with-modules
     n
     (lambda (files)
       (display-to-file "(module m1 '#%kernel (" (cadr files) #:exists 'truncate)
       (check-regexp-match (format "^Compiling ~a files" n) (said files "the tests"))
       (for ([file (in-list files)])
         (check-equal? (compiled? file) (not (equal? file (cadr files))) (path->string file)))))))

(test-case "the mistake of a file that was changed is raised, when all is asked for"
  (call-with-modules
   3
   (lambda (files)
     (define-values (folder name _) (split-path (car files)))
     (display-to-file "(module m1 '#%kernel (" (cadr files) #:exists 'truncate)
     (check-exn #rx"m1.rkt.*expected a `[)]`" (lambda () (compile-changed folder 2 #f)))
     (check-equal? (map compiled? files) '(#t #f #t))
     (display-to-file "(module m1 '#%kernel 1)" (cadr files) #:exists 'truncate)
     (compile-changed folder 2 #f)
     (check-equal? (map compiled? files) '(#t #t #t)))))

(test-case "a file that has changed is compiled again, one that has not is left alone"
  (call-with-modules
   2
   (lambda (files)
     (said files #f)
     (file-or-directory-modify-seconds (car files) (+ 10 (current-seconds)))
     (display-to-file "(module m0 '#%kernel 5)" (car files) #:exists 'truncate)
     (file-or-directory-modify-seconds (car files) (+ 10 (current-seconds)))
     (check-regexp-match #rx"^Compiling 1 file of" (said files "the tests")))))

(test-case "DrRacket finds what Racket compiled, and compiles what has changed since"
  (call-with-modules
   2
   (lambda (files)
     (define-values (folder name _) (split-path (car files)))
     (define debugging (build-path "compiled" "drracket" "errortrace"))
     (define (compiled-by-DrRacket)     ; names of the files
       (define found '())
       (parameterize ([use-compiled-file-paths (list debugging (string->path "compiled"))]
                      [current-namespace (make-base-empty-namespace)]
                      [manager-compile-notify-handler (lambda (f) (set! found (cons f found)))])
         (for ([file (in-list files)]) ((make-caching-managed-compile-zo) file)))
       found)
     (said files #f)
     (check-false (linked-for-DrRacket? folder))
     (link-for-DrRacket folder)
     (link-for-DrRacket folder)
     (check-true (linked-for-DrRacket? folder))
     (check-equal? (compiled-by-DrRacket) '())
     (display-to-file "(module m0 '#%kernel 10)" (car files) #:exists 'truncate)
     (file-or-directory-modify-seconds (build-path folder "compiled" "m0_rkt.zo")
                                       (- (current-seconds) 10))
     (check-equal? (compiled-by-DrRacket) (list (car files)))
     (check-false (link-exists? (build-path folder debugging "m0_rkt.zo"))))))
