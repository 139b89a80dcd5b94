#lang racket/base
;; `make certify`: certificates of the claims of claims.rktd and of all that the examples, the
;; README and the pages of the guide prove, given to Coq, and false neighbours of the claims, which
;; it has to reject.
;;
;;     racket certify-all.rkt --jobs 2 --neighbours 3
;;
;; The table is written to build/certificates.txt too. The exit code is 1 if Coq rejects a
;; certificate or accepts a false neighbour.

(require racket/cmdline racket/file racket/list racket/path racket/runtime-path
         mechanics/certificate/certificate mechanics/certificate/Coq-check
         mechanics/lang/command/program-verdicts mechanics/show/notebook/program-cells
         mechanics/verdict/verdict
         "../../../../scribblings/mechanics/guide-notebook.rkt"
         "false-neighbours.rkt" "proved-claims.rkt")

(define-runtime-path top "../../../..")

;; ---------------------------------------------------------------------------
;; Claims

;; name : string; content : certificate, or why there is none
(struct entry (name content) #:authentic)

(define (entries-of-claims)
  (for/list ([c (in-list (proved-claims))])
    (entry (symbol->string (asked-name c)) (certificate-or-reason (asked-verdict c)))))

(define folders
  '("chapter-1" "constraints" "exercises" "forces" "geometry" "geometry/exercises" "questions"
    "rigid" "variational"))

(define (entries-of-examples)
  (define examples (build-path top "examples" "mechanics"))
  (define files
    (append (list (build-path examples "demo.rkt"))
            (for*/list ([folder (in-list folders)]
                        [file (in-list (directory-list (build-path examples folder) #:build? #t))]
                        #:when (path-has-extension? file #".rkt"))
              file)))
  (append-map entries-of-program files))

(define (entries-of-program file)
  (define-values (all problem) (program-verdicts 'certify (simple-form-path file) file))
  (for/list ([s (in-list all)] [k (in-naturals 1)] #:when (proved? (shown-verdict-verdict s)))
    (entry (format "~a ~a" (file-name-from-path file) k)
           (certificate-or-reason (shown-verdict-verdict s)))))

;; The forms of the README and of each page of the guide, as programs
(define (entries-of-texts)
  (define folder (make-temporary-file "texts~a" 'directory))
  (define (entries name forms)
    (define file (build-path folder (string-append name ".rkt")))
    (display-lines-to-file (cons "#lang mechanics" forms) file)
    (entries-of-program file))
  (begin0
    (append (entries "README" (forms-of-README))
            (append* (for/list ([p (in-list (guide-pages (build-path guide "guide.scrbl")))])
                       (entries (guide-page-name p) (forms-of-page p)))))
    (delete-directory/files folder)))

(define guide (build-path top "scribblings" "mechanics"))

(define (forms-of-page p)
  (for/list ([c (in-list (guide-page-cells p))]
             #:when (eq? 'code (cell-kind c)) #:unless (memq c (guide-page-failing p)))
    (cell-source c)))

;; The forms after its prompts
(define (forms-of-README)
  (define text (file->string (build-path top "README.md")))
  (for/list ([place (in-list (regexp-match-positions* #rx"(?m:^    > )" text))])
    (format "~s" (read (open-input-string (substring text (cdr place)))))))

;; ---------------------------------------------------------------------------
;; Judging

(define longest 20)                     ; seconds in which a certificate is to be accepted

;; outcome : 'accepted, 'slow, 'rejected or 'none; line : of the table
;; level   : of its certificate; best : of those that there are for such a question, 1 or 2
(struct row (outcome level best line) #:authentic)

(define (judge e coqc)
  (define c (entry-content e))
  (cond [(string? c) (row 'none #f 1 (format "~a: no certificate yet: ~a" (entry-name e) c))]
        [else
         (define j (check-by-Coq coqc (certificate-text c)))
         (define outcome
           (cond [(not (judgement-accepted? j)) 'rejected]
                 [(> (judgement-seconds j) longest) 'slow]
                 [else 'accepted]))
         (row outcome (certificate-level c) (if (certificate-gap c) 2 (certificate-level c))
              (format "~a: level ~a~a ~a in ~a s~a" (entry-name e) (certificate-level c)
                      (if (certificate-gap c) (format " (not 2: ~a)" (certificate-gap c)) "")
                      outcome (/ (round (* 10 (judgement-seconds j))) 10.0)
                      (if (eq? outcome 'rejected)
                          (string-append "\n" (judgement-message j))
                          "")))]))

(define (judge-neighbour n coqc)
  (define j (check-by-Coq coqc (neighbour-text n)))
  (row (if (judgement-accepted? j) 'accepted 'rejected) #f #f
       (format "~a: ~a" (neighbour-name n) (if (judgement-accepted? j) "ACCEPTED" "rejected"))))

;; -> rows in order, by as many threads as jobs; each is printed when it is known
(define (judge-all judge xs coqc jobs)
  (define results (make-vector (length xs) #f))
  (define next (make-channel))
  (define workers
    (for/list ([_ (in-range jobs)])
      (thread (lambda ()
                (let loop ()
                  (define task (channel-get next))
                  (when task
                    (define r (judge (cdr task) coqc))
                    (vector-set! results (car task) r)
                    (printf "~a\n" (row-line r))
                    (flush-output)
                    (loop)))))))
  (for ([x (in-list xs)] [k (in-naturals)]) (channel-put next (cons k x)))
  (for ([_ (in-list workers)]) (channel-put next #f))
  (for-each thread-wait workers)
  (vector->list results))

(define (share rows outcomes)
  (define n (count (lambda (r) (memq (row-outcome r) outcomes)) rows))
  (format "~a of ~a (~a %)" n (length rows) (quotient (* 100 n) (max 1 (length rows)))))

(define (summary title rows)
  (define levels (filter (lambda (r) (eqv? 2 (row-best r))) rows))
  (define by-Coq
    (for/sum ([r (in-list levels)])
      (if (and (eqv? 2 (row-level r)) (memq (row-outcome r) '(accepted slow))) 1 0)))
  (format (string-append "~a: accepted ~a, rejected ~a, slower than ~a s ~a, "
                         "without certificate ~a; by Coq's derivatives ~a of ~a\n")
          title (share rows '(accepted slow)) (share rows '(rejected)) longest
          (share rows '(slow)) (share rows '(none)) by-Coq (length levels)))

(module+ main
  (define-values (jobs most examples?)
    (let ([jobs 1] [most 3] [examples? #t])
      (command-line
       #:once-each
       ["--jobs" n "how many of Coq at once" (set! jobs (string->number n))]
       ["--neighbours" n "how many false neighbours of each claim" (set! most (string->number n))]
       ["--claims-only" "without examples and texts" (set! examples? #f)])
      (values jobs most examples?)))
  (define coqc (find-Coq))
  (unless coqc
    (printf "skipped: Coq is not there; on Debian, apt-get install coq libcoq-coquelicot\n")
    (exit 0))
  (define needed '(square-root exponential-of-logarithm quotient geometric cube-root))
  (define claims (judge-all judge (entries-of-claims) coqc jobs))
  (define examples
    (if examples?
        (judge-all judge (append (entries-of-examples) (entries-of-texts)) coqc jobs)
        '()))
  (define neighbours
    (judge-all judge-neighbour
               (append (false-neighbours (proved-claims) most)
                       (neighbours-by-hypotheses (proved-claims needed))
                       (neighbours-by-definitions (proved-claims) most))
               coqc jobs))
  (define text
    (string-append (summary "claims" claims)
                   (if examples? (summary "examples and texts" examples) "")
                   (format "false neighbours: rejected ~a\n" (share neighbours '(rejected)))))
  (display text)
  (make-directory* (build-path top "build"))
  (display-lines-to-file
   (append (map row-line (append claims examples neighbours)) (list text))
   (build-path top "build" "certificates.txt") #:exists 'truncate)
  (exit (if (or (memq 'rejected (map row-outcome (append claims examples)))
                (memq 'accepted (map row-outcome neighbours)))
            1
            0)))
