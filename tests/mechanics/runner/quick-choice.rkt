#lang racket/base
;; The tests to run after a change, in less than a minute: of the rooms where something changed,
;; then others that are stale (record.rkt), the shortest first, as many as there is time for.
;; Tests that read the sources of the whole house are always among them.

(require racket/list
         "discover.rkt" "record.rkt")

(provide choose-quickly         ; paths, record, digests, seconds -> chosen paths, paths left out
         sources-without-test)  ; record, digests -> changed sources that no test is known to load

(define always '("tests/mechanics/architecture.rkt" "tests/mechanics/documentation.rkt"))

;; seconds : that the chosen files may take in sum
(define (choose-quickly files r digests seconds)
  (define rooms (remove-duplicates (map room-of (changed-sources r digests))))
  (define (entry-of file) (hash-ref (record-entries r) (test-name file) #f))
  (define (seconds-of file)
    (define e (entry-of file))
    (if e (entry-seconds e) 1))
  ;; What decides whether a file is run, and how early; #f if nothing asks for it
  (define (rank file)
    (cond [(member (short-name file) always) 0]
          [(member (room-of (test-name file)) rooms) 1]
          [(test-stale? (entry-of file) digests) 2]
          [else #f]))
  (define candidates
    (sort (sort (filter rank files) < #:key seconds-of) < #:key rank))
  (define chosen (within-time candidates seconds-of seconds))
  (values chosen (remove* chosen candidates)))

;; Those that there is time for; one that is too long does not keep shorter ones out.
(define (within-time files seconds-of seconds)
  (for/fold ([chosen '()] [left seconds] #:result (reverse chosen)) ([file (in-list files)])
    (define remaining (- left (seconds-of file)))
    (if (>= remaining 0) (values (cons file chosen) remaining) (values chosen left))))

(define (sources-without-test r digests)
  (define loaded
    (for*/hasheq ([e (in-hash-values (record-entries r))] [source (in-list (entry-sources e))])
      (values source #t)))
  (filter (lambda (source) (not (hash-ref loaded source #f))) (changed-sources r digests)))

;; tests/mechanics/motion/energy.rkt, mechanics/motion/evolve.rkt -> motion/
(define (room-of name)
  (cadr (regexp-match #px"^(?:[^/]*/)?(?:mechanics/)?((?:.*/)?)[^/]*$" (symbol->string name))))
