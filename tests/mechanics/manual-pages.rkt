#lang racket/base
;; The manual as a way in: where to begin, and what to read next.

(require mechanics/lang/help/page
         racket/list
         racket/runtime-path
         racket/string
         "support/checks.rkt")

(define-runtime-path manual "../../scribblings/mechanics/mechanics.scrbl")

(define pages (manual-pages (simplify-path manual)))

(define (in-guide? p) (regexp-match? #rx"/guide/" (path->string (page-file p))))

(define guide (filter in-guide? pages))

;; Tags of pages and of sections that have one.
(define tags
  (for*/list ([p (in-list pages)] [s (in-list (page-sections p))] #:when (section-tag s))
    (section-tag s)))

;; The last form of a page that is no end of a session.
(define (end-of p)
  (findf (lambda (part)
           (if (string? part)
               (non-empty-string? (string-trim part))
               (not (memq (car part) '(close-session)))))
         (reverse (page-parts p))))

(test-case "every page of the guide ends with what to read next"
  (check-true (> (length guide) 35))
  (for ([p (in-list guide)])
    (define end (end-of p))
    (check-true (and (pair? end) (eq? (car end) 'next-pages)) (page-title p))))

(test-case "pages to read next are there, two at least, and no page names itself"
  (for ([p (in-list guide)])
    (define next
      (for/list ([x (in-list (cdr (end-of p)))] [k (in-naturals)] #:when (even? k)) x))
    (check-true (<= 2 (length next) 4) (page-title p))
    (check-equal? (remove* tags next) '() (page-title p))
    (check-false (member (section-tag (first (page-sections p))) next) (page-title p))))

(test-case "the first page says where to begin; each chapter has its page; no title is there twice"
  (check-not-false (member "where-to-begin" tags))
  (for ([chapter '(1 2 3 4 5 6 7)])
    (check-not-false (member (format "chapter-~a" chapter) tags)))
  (for ([part (list guide (remove* guide pages))])
    (check-false (check-duplicates (map page-title part))))
  (check-equal? (filter (lambda (p) (string=? (page-title p) "Pictures")) pages) '()))

(test-case "no two sections have one tag, so that each can be found"
  (define made
    (for*/list ([p (in-list pages)] [s (in-list (page-sections p))])
      (or (section-tag s) (section-heading s))))
  (check-false (check-duplicates made)))
