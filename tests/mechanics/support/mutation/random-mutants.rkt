#lang racket/base
;; Do the tests notice random mutants?
;;
;;     racket random-mutants.rkt [--room ROOM] [--count N] [--seed S] [--jobs J] [--again]
;;
;; Draws mutants from a room's files, or N from each room's, and runs on each the tests that loaded
;; its file in the last run of `make test`, those of its room first, until one fails.  What is known
;; of a mutant is kept in build/mutants.rktd and not asked again while its program, comments aside,
;; is as it was, but for what survived, with --again; a break loses nothing.  Mutants that no
;; behaviour tells, or only a limit or a layout, are listed in equivalent-mutants.rktd:
;; (file "the line as it was" "as it is" "reason" [limit or layout]).

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

;; key : that of a verdict kept
(struct mutant (room file change key) #:prefab)

;; -> list of mutants, of each room `count`: those of which a verdict is kept, then others by
;; chance.  A change of one file leaves the draw of others as it is.
(define (drawn only count seed [before (hash)])
  (define (place m) (list (if (hash-has-key? before (mutant-key m)) "" "new") (chance m seed)))
  (for*/list ([room (in-list (map car rooms))]
              #:when (member only (list #f room (string-trim room "/" #:left? #f)))
              [found (in-value (sort (mutants-of room) places<? #:key place #:cache-keys? #t))]
              [m (in-list (take found (min count (length found))))])
    m))

(define (places<? a b)
  (or (string<? (car a) (car b)) (and (string=? (car a) (car b)) (string<? (cadr a) (cadr b)))))

(define (mutants-of room)
  (for*/list ([file (in-list (library-files))]
              #:when (equal? (room-name file) room)
              [text (in-value (file->string (full-path file)))]
              [program (in-value (hash-of file (syntax->datum (program-of text file))))]
              [(m n) (in-indexed (mutations-of text file))])
    (mutant room file m (hash-of program n (mutation-kind m)))))

(define (hash-of . parts) (sha1 (open-input-string (format "~s" parts))))

;; A place in an order that depends on the seed, the line and the change in it alone
(define (chance m seed)
  (define-values (was is) (lines-of m))
  (hash-of seed (mutant-file m) was is))

(define (room-name file)
  (define place (room-of file))
  (and place (car (list-ref rooms place))))

;; ---------------------------------------------------------------------------
;; Tests of a file: the one of its name, and those that noticed another mutant of it; then those
;; that loaded it, its room's first, then those of the rooms beside, the shortest first among each

(define most-seconds 15)

;; A file that is loaded only by programs that tests start, as those of windows are, is tried with
;; the tests of its room. -> list of (test seconds)
(define (tests-of file room entries noticing)
  (define source (string->symbol (string-append "mechanics/" file)))
  (define own (string-append "tests/mechanics/" (string-trim room "/" #:left? #f) "/"))
  (define beside (string-append "tests/mechanics/" (car (string-split room "/")) "/"))
  (define (distance name) (index-where (list own beside "") (lambda (f) (string-prefix? name f))))
  (define (those good?)
    (for/list ([(name e) (in-hash entries)] #:when (good? (symbol->string name) e))
      (list (symbol->string name) (entry-seconds e))))
  (define loading (those (lambda (name e) (memq source (entry-sources e)))))
  (define in-order
    (sort (sort (if (null? loading) (those (lambda (name e) (string-prefix? name own))) loading)
                < #:key cadr)
          < #:key (lambda (t) (distance (car t)))))
  (define new (filter (lambda (t) (not (hash-has-key? entries (string->symbol (car t)))))
                      (tests-in own)))
  (define-values (_folder name _directory?) (split-path file))
  (define (likely? test)
    (or (member (car test) noticing)
        (string-suffix? (car test) (string-append "/" (path->string name)))))
  (define-values (first-tried others) (partition likely? in-order))
  (append new (within-seconds (append (sort first-tried < #:key cadr) others))))

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
;; Verdicts kept

(define (known)
  (if (file-exists? kept)
      (for/hash ([entry (in-list (file->list kept))]) (values (car entry) (cdr entry)))
      (hash)))

(define (remember! m verdict)
  (make-parent-directory* kept)
  (with-output-to-file kept #:exists 'append
    (lambda ()
      (writeln (list* (mutant-key m) (mutant-file m) (mutation-line (mutant-change m)) verdict)))))

(define (without-survivors known)
  (for/hash ([(k found) (in-hash known)] #:unless (equal? (last found) 'survived))
    (values k found)))

(define equivalents (if (file-exists? equivalent-file) (file->list equivalent-file) '()))

(define (line-of text n) (string-trim (list-ref (string-split text "\n" #:trim? #f) (sub1 n))))

;; -> the line as it was, and as it is
(define (lines-of m)
  (define-values (text change) (values (text-of m) (mutant-change m)))
  (values (line-of text (mutation-line change))
          (line-of (mutated-text text change) (mutation-line change))))

(define (text-of m) (file->string (full-path (mutant-file m))))

(define (marked? m)
  (define-values (was is) (lines-of m))
  (for/or ([e (in-list equivalents)])
    (match-define (list marked before after _ (or 'limit 'layout) ...) e)
    (equal? (list marked before after) (list (mutant-file m) was is))))

;; ---------------------------------------------------------------------------

;; -> (room verdict) for each, several at once
(define (judge all jobs before)
  (define entries (record-entries (read-record)))
  (for ([found (in-hash-values before)]) (note-noticing! (car found) (cddr found)))
  (define to-do (make-channel))
  (define done (make-channel))
  (for ([_ (in-range jobs)])
    (thread (lambda ()
              (let next ()
                (define m (channel-get to-do))
                (define verdict
                  (with-handlers ([exn:fail? (lambda (e) (list 'untested (exn-message e)))])
                    (judge-one m before entries)))
                (channel-put done (list m verdict))
                (next)))))
  (thread (lambda () (for ([m (in-list all)]) (channel-put to-do m))))
  (for/list ([_ (in-list all)])
    (match-define (list m verdict) (channel-get done))
    (report-one m verdict)
    (list (mutant-room m) verdict)))

(define (judge-one m before entries)
  (cond [(marked? m) '(marked)]
        [(hash-ref before (mutant-key m) #f) => cddr]
        [else
         (define file (mutant-file m))
         (define tests (tests-of file (mutant-room m) entries (hash-ref noticing file '())))
         (define verdict (try file (mutant-change m) tests))
         (remember! m verdict)
         (note-noticing! file verdict)
         verdict]))

;; file -> tests that noticed a mutant of it
(define noticing (make-hash))
(define (note-noticing! file verdict)
  (when (eq? (car verdict) 'killed)
    (hash-update! noticing file (lambda (tests) (cons (cadr verdict) tests)) '())))

(define (report-one m verdict)
  (define-values (file change) (values (mutant-file m) (mutant-change m)))
  (case (car verdict)
    [(survived untested)
     (define-values (was is) (lines-of m))
     (printf "~a  ~a:~a (~a)\n  - ~a\n  + ~a\n" (car verdict) file (mutation-line change)
             (mutation-kind change) was is)]
    [else (printf "~a  ~a:~a ~a\n" (car verdict) file (mutation-line change) (cdr verdict))])
  (flush-output))

(define (summary answers)
  (define (count-of kind of) (count (lambda (a) (eq? (caadr a) kind)) of))
  (for ([group (in-list (group-by car answers))])
    (define killed (count-of 'killed group))
    (define asked (- (length group) (count-of 'marked group) (count-of 'refused group)))
    (printf "~a ~a of ~a noticed\n" (caar group) killed asked))
  (printf "~a of ~a noticed\n" (count-of 'killed answers)
          (- (length answers) (count-of 'marked answers) (count-of 'refused answers))))

(provide drawn try (struct-out mutant))

(module+ main
  (define-values (room count seed jobs again?) (values #f 10 1 2 #f))
  (command-line #:once-each
                [("--room") r "only this room" (set! room r)]
                [("--count") n "mutants of each room" (set! count (string->number n))]
                [("--seed") s "seed" (set! seed (string->number s))]
                [("--jobs") j "at once" (set! jobs (string->number j))]
                [("--again") "ask what survived before" (set! again? #t)])
  (define before (known))
  (summary (judge (drawn room count seed before) jobs
                  (if again? (without-survivors before) before))))
