#lang racket/base
;; Do the tests notice random mutants?
;;
;;     racket random-mutants.rkt [--room ROOM] [--count N] [--seed S] [--jobs J] [--again]
;;
;; Draws mutants from a room's files, or N from each room's, and runs on each the tests that loaded
;; its file in the last run of `make test`, those of its room first, until one fails.  What is known
;; of a mutant is kept in build/mutants.rktd and not asked again while its file is as it was, but
;; for what survived, with --again; a break loses nothing.  Mutants that no behaviour tells, or only a limit or a layout, are listed in
;; equivalent-mutants.rktd: (file "the line as it was" "as it is" "reason" [limit or layout]).

(require file/sha1
         racket/cmdline
         racket/file
         racket/format
         racket/list
         racket/match
         racket/port
         racket/runtime-path
         racket/string
         compiler/find-exe
         "mutations.rkt"
         "../../runner/discover.rkt" "../../runner/record.rkt"
         "../house/library.rkt" "../house/map.rkt")

(define-runtime-path trier "try-mutant.rkt")
(define-runtime-path equivalent-file "equivalent-mutants.rktd")
(define kept (from-top "build/mutants.rktd"))

;; ---------------------------------------------------------------------------
;; Drawing

;; -> list of (room file mutation), of each room `count` by chance
(define (drawn only count seed)
  (parameterize ([current-pseudo-random-generator (make-pseudo-random-generator)])
    (random-seed seed)
    (for*/list ([room (in-list (map car rooms))]
                #:when (member only (list #f room (string-trim room "/" #:left? #f)))
                [found (in-value (mutants-of room))]
                [m (in-list (take (shuffle found) (min count (length found))))])
      (cons room m))))

(define (room-name file)
  (define place (room-of file))
  (and place (car (list-ref rooms place))))

(define (mutants-of room)
  (for*/list ([file (in-list (library-files))]
              #:when (equal? (room-name file) room)
              [m (in-list (mutations-of (file->string (full-path file)) file))])
    (list file m)))

;; ---------------------------------------------------------------------------
;; Tests of a file: those that loaded it, its room's first, then those of the rooms beside, the
;; shortest first among each

(define most-seconds 15)

;; -> list of (test seconds)
(define (tests-of file room entries)
  (define source (string->symbol (string-append "mechanics/" file)))
  (define own (string-append "tests/mechanics/" (string-trim room "/" #:left? #f) "/"))
  (define beside (string-append "tests/mechanics/" (car (string-split room "/")) "/"))
  (define (distance name) (index-where (list own beside "") (lambda (f) (string-prefix? name f))))
  (define loading
    (for/list ([(name e) (in-hash entries)] #:when (memq source (entry-sources e)))
      (list (symbol->string name) (entry-seconds e))))
  (define in-order
    (sort (sort loading < #:key cadr) < #:key (lambda (t) (distance (car t)))))
  (define new (filter (lambda (t) (not (hash-has-key? entries (string->symbol (car t)))))
                      (tests-in own)))
  (append new (within-seconds in-order)))

;; The first tests that fit into the time
(define (within-seconds tests)
  (for/fold ([chosen '()] [left most-seconds] #:result (reverse chosen)) ([t (in-list tests)])
    (if (> (cadr t) left)
        (values chosen left)
        (values (cons t chosen) (- left (cadr t))))))

;; Tests of the room; new ones have no record.
(define (tests-in folder)
  (define path (from-top folder))
  (if (directory-exists? path)
      (for/list ([f (in-directory path)] #:when (regexp-match? #rx"[.]rkt$" f))
        (list (short-name f) 10))
      '()))

;; ---------------------------------------------------------------------------
;; Trying

;; -> (killed test), (survived), (refused) where it does not compile, or (untested)
(define (try file m tests)
  (define text (file->string (full-path file)))
  (define fit (filter (lambda (t) (hash-ref passing (car t) #t)) tests))
  (define verdict (if (null? fit) '(untested) (verdict-on file (mutated-text text m) fit)))
  (define test (and (eq? (car verdict) 'killed) (assoc (cadr verdict) fit)))
  (if (and test (not (passes? test file text)))
      (try file m tests)
      verdict))

;; Does a test that noticed a mutant pass without one?  Asked once of each.
(define passing (make-hash))
(define (passes? test file text)
  (hash-ref! passing (car test)
             (lambda () (equal? '(survived) (verdict-on file text (list test))))))

;; Seconds of the clock; try-mutant.rkt counts those of the processor.
(define patience 1200)

(define (verdict-on file text tests)
  (define-values (process out in err)
    (parameterize ([subprocess-group-enabled #t] [current-subprocess-custodian-mode 'kill]
                   [current-directory (from-top ".")])
      (apply subprocess #f #f 'stdout (find-exe) trier
             (path->string (full-path file)) (map ~a (append* tests)))))
  (write-string text in)
  (close-output-port in)
  (define said (make-channel))
  (thread (lambda () (channel-put said (port->lines out))))
  (define lines (sync/timeout patience said))
  (subprocess-kill process #t)
  (close-input-port out)
  (verdict-in (or lines '()) lines))

;; One that does not end, or of which the process dies, has been noticed.  Tests may print too.
(define (verdict-in lines ended?)
  (or (for/or ([line (in-list lines)])
        (match (with-handlers ([void void]) (read (open-input-string line)))
          [(and v (or '(survived) '(refused) (list 'killed _))) v]
          [_ #f]))
      (list 'killed (if ended? "the process died" "it did not end"))))

;; ---------------------------------------------------------------------------
;; What is known

(define (key file m) (sha1 (open-input-string (format "~s ~a" m (file->string (full-path file))))))

(define (known)
  (if (file-exists? kept)
      (for/hash ([entry (in-list (file->list kept))]) (values (car entry) (cdr entry)))
      (hash)))

(define (remember! k file m verdict)
  (make-parent-directory* kept)
  (with-output-to-file kept #:exists 'append
    (lambda () (writeln (list* k file (mutation-line m) verdict)))))

(define (without-survivors known)
  (for/hash ([(k found) (in-hash known)] #:unless (equal? (last found) 'survived))
    (values k found)))

(define equivalents (if (file-exists? equivalent-file) (file->list equivalent-file) '()))

(define (line-of text n) (string-trim (list-ref (string-split text "\n" #:trim? #f) (sub1 n))))

;; -> the line as it was, and as it is
(define (lines-of file m)
  (define text (file->string (full-path file)))
  (values (line-of text (mutation-line m)) (line-of (mutated-text text m) (mutation-line m))))

(define (marked? file m)
  (define-values (was is) (lines-of file m))
  (for/or ([e (in-list equivalents)])
    (match-define (list marked before after _ (or 'limit 'layout) ...) e)
    (equal? (list marked before after) (list file was is))))

;; ---------------------------------------------------------------------------

;; -> (room verdict) for each, several at once; what survived before is asked where `again?`
(define (judge all jobs again?)
  (define before (if again? (without-survivors (known)) (known)))
  (define entries (record-entries (read-record)))
  (define to-do (make-channel))
  (define done (make-channel))
  (for ([_ (in-range jobs)])
    (thread (lambda ()
              (let next ()
                (define one (channel-get to-do))
                (define verdict
                  (with-handlers ([exn:fail? (lambda (e) (list 'untested (exn-message e)))])
                    (judge-one one before entries)))
                (channel-put done (list one verdict))
                (next)))))
  (thread (lambda () (for ([one (in-list all)]) (channel-put to-do one))))
  (for/list ([_ (in-list all)])
    (define answer (channel-get done))
    (report-one (car answer) (cadr answer))
    (list (caar answer) (cadr answer))))

(define (judge-one one before entries)
  (match-define (list room file m) one)
  (define k (key file m))
  (define found (hash-ref before k #f))
  (cond [(marked? file m) '(marked)]
        [found (cddr found)]
        [else
         (define verdict (try file m (tests-of file room entries)))
         (remember! k file m verdict)
         verdict]))

(define (report-one one verdict)
  (match-define (list room file m) one)
  (case (car verdict)
    [(survived untested)
     (define-values (was is) (lines-of file m))
     (printf "~a  ~a:~a (~a)\n  - ~a\n  + ~a\n" (car verdict) file (mutation-line m)
             (mutation-kind m) was is)]
    [else (printf "~a  ~a:~a ~a\n" (car verdict) file (mutation-line m) (cdr verdict))])
  (flush-output))

(define (summary answers)
  (define (count-of kind of) (count (lambda (a) (eq? (caadr a) kind)) of))
  (for ([group (in-list (group-by car answers))])
    (define killed (count-of 'killed group))
    (define asked (- (length group) (count-of 'marked group) (count-of 'refused group)))
    (printf "~a ~a of ~a noticed\n" (caar group) killed asked))
  (printf "~a of ~a noticed\n" (count-of 'killed answers)
          (- (length answers) (count-of 'marked answers) (count-of 'refused answers))))

(provide drawn try tests-of mutants-of)

(module+ main
  (define-values (room count seed jobs again?) (values #f 10 1 2 #f))
  (command-line #:once-each
                [("--room") r "only this room" (set! room r)]
                [("--count") n "mutants of each room" (set! count (string->number n))]
                [("--seed") s "seed" (set! seed (string->number s))]
                [("--jobs") j "at once" (set! jobs (string->number j))]
                [("--again") "ask what survived before" (set! again? #t)])
  (summary (judge (drawn room count seed) jobs again?)))
