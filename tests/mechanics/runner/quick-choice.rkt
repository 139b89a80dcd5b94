#lang racket/base
;; The tests to run after a change, in less than a minute: those of the rooms where something
;; changed, then those that read the sources of the whole house, then others that are stale
;; (record.rkt), the shortest first, as many as there is time for.  After a change deep down most of
;; the house is to be compiled again, and the tests that need the least of it come to their turn.

(require racket/list
         "discover.rkt" "record.rkt")

(provide choose-quickly         ; paths, record, digests, seconds, [source -> seconds to compile it]
                                ; -> chosen paths, paths left out
         sources-without-test)  ; record, digests -> changed sources that no test is known to load

(define always '("tests/mechanics/architecture.rkt" "tests/mechanics/documentation.rkt"))

;; seconds : that the chosen files may take in sum, with the compilation of what they load
(define (choose-quickly files r digests seconds [seconds-to-compile (lambda (source) 0)])
  (define rooms (remove-duplicates (map room-of (changed-sources r digests))))
  (define (entry-of file) (hash-ref (record-entries r) (test-name file) #f))
  (define (seconds-of file)
    (define e (entry-of file))
    (if e (entry-seconds e) 1))
  (define (sources-of file)
    (define e (entry-of file))
    (if e (entry-sources e) (list (test-name file))))
  ;; The reason to run a file, and how early; #f if nothing asks for it
  (define (rank file)
    (cond [(member (room-of (test-name file)) rooms) 0]
          [(member (short-name file) always) 1]
          [(test-stale? (entry-of file) digests) 2]
          [else #f]))
  (define candidates
    (sort (sort (filter rank files) < #:key seconds-of) < #:key rank #:cache-keys? #t))
  (define chosen (within-time candidates seconds-of sources-of seconds-to-compile seconds))
  (values chosen (remove* chosen candidates)))

;; Returns the files that there is time for.  A source is compiled once, for the first file that
;; loads it; a file that takes too long does not keep shorter ones out.
(define (within-time files seconds-of sources-of seconds-to-compile seconds)
  (define compiled (make-hasheq))
  (for/fold ([chosen '()] [left seconds] #:result (reverse chosen)) ([file (in-list files)])
    (define new (filter (lambda (s) (not (hash-ref compiled s #f))) (sources-of file)))
    (define remaining
      (- left (seconds-of file) (for/sum ([source (in-list new)]) (seconds-to-compile source))))
    (cond [(>= remaining 0)
           (for ([source (in-list new)]) (hash-set! compiled source #t))
           (values (cons file chosen) remaining)]
          [else (values chosen left)])))

(define (sources-without-test r digests)
  (define loaded
    (for*/hasheq ([e (in-hash-values (record-entries r))] [source (in-list (entry-sources e))])
      (values source #t)))
  (filter (lambda (source) (not (hash-ref loaded source #f))) (changed-sources r digests)))

;; tests/mechanics/motion/energy.rkt, mechanics/motion/evolve.rkt -> motion/
(define (room-of name)
  (cadr (regexp-match #px"^(?:[^/]*/)?(?:mechanics/)?((?:.*/)?)[^/]*$" (symbol->string name))))
