#lang racket/base
;; Random mutants: what is changed in a text, and that a test notices it.

(require racket/file
         racket/list
         rackunit
         "support/house/library.rkt"
         "support/mutation/mutations.rkt" "support/mutation/random-mutants.rkt")

(define text
  (string-append "#lang racket/base\n(require racket/list)\n"
                 "(define (f a b #:deep? [deep? #f])\n"
                 "  (cond [(< a b) (g b a #:deep? deep?)]\n"
                 "        [(not a) '(1 2)]\n"
                 "        [else (if b (+ a 1) (max a b))]))\n"))

(define (line-with k m) (list-ref (regexp-split #rx"\n" (mutated-text text m)) (sub1 k)))

(define (lines-made-of kind)
  (for/list ([m (in-list (mutations-of text "f.rkt"))] #:when (eq? kind (mutation-kind m)))
    (line-with (mutation-line m) m)))

(test-case "each kind of mutation changes one thing, and nothing that is quoted or required"
  (check-equal? (lines-made-of 'exchanged)
                '("  (cond [(<= a b) (g b a #:deep? deep?)]"
                  "        [else (if b (- a 1) (max a b))]))"
                  "        [else (if b (+ a 1) (min a b))]))"))
  (check-equal? (lines-made-of 'dropped) '("        [a '(1 2)]"))
  (check-equal? (lines-made-of 'keyword) '("  (cond [(< a b) (g b a )]"))
  (check-equal? (lines-made-of 'branches) '("        [else (if b (max a b) (+ a 1))]))"))
  (check-equal? (lines-made-of 'number) '("        [else (if b (+ a 2) (max a b))]))"))
  (check-equal? (lines-made-of 'boolean) '("(define (f a b #:deep? [deep? #t])"))
  (check-equal? (length (lines-made-of 'clause)) 2)
  (check-equal? (lines-made-of 'arguments) '("  (cond [(< b b) (g b a #:deep? deep?)]"
                                             "  (cond [(< a b) (g a a #:deep? deep?)]")))

(test-case "the same seed draws the same mutants, of the room that is asked for"
  (define some (drawn "pendulum" 5 1))
  (check-equal? some (drawn "pendulum" 5 1))
  (check-not-equal? some (drawn "pendulum" 5 2))
  (check-equal? (remove-duplicates (map mutant-room some)) '("pendulum/")))

(test-case "mutants of which a verdict is kept are drawn first"
  (define all (drawn "pendulum" 20 1))
  (define known (mutant-key (last all)))
  (check-equal? (drawn "pendulum" 5 1 (hash known '("pendulum/phase.rkt" 1 survived)))
                (cons (last all) (take all 4))))

;; The fixed sample of what `make mutants` does in the large
(test-case "a changed sign is noticed, no change is not, and a test that always fails counts not"
  (define file "pendulum/phase.rkt")
  (define tests
    (list (list (path->string (full-path "../tests/mechanics/pendulum/closed-forms.rkt")) 5)))
  (define source (file->string (full-path file)))
  (define (first-of kind)
    (findf (lambda (m) (eq? kind (mutation-kind m))) (mutations-of source file)))
  (check-equal? (car (try file (first-of 'exchanged) tests)) 'killed)
  (check-equal? (try file (mutation 'none 1 0 0 "") tests) '(survived))
  (define failing (make-temporary-file "failing-~a.rkt"))
  (display-to-file "#lang racket/base\n(error \"always\")\n" failing #:exists 'truncate)
  (check-equal? (try file (first-of 'exchanged) (list (list (path->string failing) 1)))
                '(untested))
  (delete-file failing))
