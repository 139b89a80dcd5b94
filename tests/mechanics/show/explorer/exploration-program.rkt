#lang racket/base
;; The program that draws an exploration again, as it is written.

(require mechanics
         mechanics/book
         mechanics/plot
         racket/flonum
         mechanics/show/explorer/exploration
         mechanics/show/explorer/exploration-program
         (only-in mechanics/show/plot/frame frame-view)
         (only-in mechanics/show/plot/view view-bounds)
         "../../support/checks.rkt")

(define-namespace-anchor here)
(define (missing source) (names-missing source (namespace-anchor->empty-namespace here)))

(test-case "names that a program would not know, in order; those it has or binds are known"
  (check-equal? (missing '(standard-map 0.6)) '())
  (check-equal? (missing '(twice (kicked 0.6) 2 twice)) '(kicked twice))
  (check-equal? (missing '(lambda (x) (stretched x))) '(stretched))
  (check-equal? (missing #f) '())
  (check-regexp-match #rx"^let: bad syntax" (missing '(let))))

;; An orbit of two points, and the program of it
(define v (frame-view (frame 0 4 0 2)))
(define (program source)
  (define e (make-exploration (standard-map 0.6) 10 (view-bounds v)))
  (add-points! e (add-orbit! e 1.0 0.5) (flvector 1.0 2.0) (flvector 0.5 1.5) 2)
  (define out (open-output-string))
  (write-exploration e v source "a.png" out #:missing (missing source))
  (get-output-string out))

(define (has? text part) (regexp-match? (regexp-quote part) text))

(test-case "it draws the map where all is known; else it tells what is missing, or that the map is"
  (define drawing "(module+ main\n  (graphics-save (redraw ~s) \"a.png\"))\n")
  (define (parts source)
    (define text (program source))
    (list (has? text (string-append "\n\n" (format drawing source)))
          (has? text "not known; with them this draws it: kicked twice\n#;\n(module+ main")
          (has? text "(graphics-save (redraw map) \"a.png\") draws it")))
  (check-equal? (parts '(standard-map 0.6)) '(#t #f #f))
  (check-equal? (parts '(twice (kicked 0.6))) '(#f #t #f))
  (check-equal? (parts #f) '(#f #f #t)))
