#lang racket/base
;; The tests to run after a change, in less than a minute: of the stale ones (record.rkt) first
;; those of the rooms where something changed, then the others, the shortest first, as many as
;; there is time for.  Tests that read the sources of the whole house are always among them.

(require racket/list
         "discover.rkt" "record.rkt")

(provide choose-quickly)        ; paths, record, digests, seconds -> chosen paths, paths left out

(define always '("tests/mechanics/architecture.rkt" "tests/mechanics/documentation.rkt"))

;; seconds : that the chosen files may take in sum
(define (choose-quickly files r digests seconds)
  (define rooms (remove-duplicates (map room-of (changed-sources r digests))))
  (define (entry-of file) (hash-ref (record-entries r) (string->symbol (short-name file)) #f))
  (define (in-changed-room? file) (member (room-of (string->symbol (short-name file))) rooms))
  (define (always? file) (member (short-name file) always))
  (define (rank file)
    (cond [(always? file) 0] [(in-changed-room? file) 1] [else 2]))
  (define (seconds-of file)
    (define e (entry-of file))
    (if e (entry-seconds e) 1))
  (define candidates
    (sort (filter (lambda (file) (or (always? file) (stale? (entry-of file) digests))) files)
          (lambda (a b)
            (or (< (rank a) (rank b))
                (and (= (rank a) (rank b)) (< (seconds-of a) (seconds-of b)))))))
  (define-values (chosen _)
    (for/fold ([chosen '()] [left seconds]) ([file (in-list candidates)])
      (define rest (- left (seconds-of file)))
      (if (>= rest 0) (values (cons file chosen) rest) (values chosen left))))
  (values (reverse chosen) (remove* chosen candidates)))

;; tests/mechanics/motion/energy.rkt, mechanics/motion/evolve.rkt -> motion/
(define (room-of name)
  (cadr (regexp-match #px"^(?:[^/]*/)?(?:mechanics/)?((?:.*/)?)[^/]*$" (symbol->string name))))
