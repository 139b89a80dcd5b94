#lang racket/base
;; Findings as text, each with the way to open it:
;;
;;     Rayleigh-dissipation  The dissipation function of forces that oppose velocities.
;;     Friction, in: From Newton to Lagrange
;;       manual: Newton-to-Lagrange.html
;;
;; and of a program the line that runs it.

(require (only-in racket/format ~a)
         racket/list
         racket/string
         "card.rkt" "cards.rkt" "finding.rkt")

(provide found-lines)

(define columns 80)
(define most-found 10)

;; findings -> lines
(define (found-lines found)
  (define shown (take found (min most-found (length found))))
  (define more (- (length found) (length shown)))
  (define room (apply max 0 (map name-length shown)))
  (append (append-map (lambda (f) (map shortened (finding-lines f (min 24 room)))) shown)
          (if (> more 0)
              (list (format "... and ~a more, less near; another word finds fewer." more))
              '())
          (if (ormap on-page? shown) (list "" where-pages-are) '())))

(define where-pages-are
  "Pages of the manual: make docs, build/doc/mechanics; or raco docs mechanics.")

(define (name-length f)
  (if (eq? (finding-kind f) 'name) (string-length (finding-title f)) 0))

(define (on-page? f) (memq (finding-kind f) '(page section)))

(define (finding-lines f room)
  (define title (finding-title f))
  (case (finding-kind f)
    [(name) (list (format "~a  ~a" (~a title #:min-width room) (name-sentence title)))]
    [(library) (list (format "~a  a library: (require ~a)" (~a title #:min-width room) title))]
    [(page) (list (string-append title (if (string=? (finding-sentence f) "") "" ": ")
                                 (finding-sentence f))
                  (page-line f))]
    [(section) (list (format "~a, in: ~a" title (finding-sentence f)) (page-line f))]
    [else (list (format "~a: ~a" (capitalized title) (finding-sentence f))
                (format "  make run FILE=examples/mechanics/~a" (finding-where f)))]))

(define (name-sentence name)
  (define c (card-of (string->symbol name)))
  (or (and c (card-sentence c)) ""))

(define (page-line f)
  (format "  manual: ~a.html" (car (string-split (finding-where f) "#"))))

(define (capitalized text)
  (string-append (string-upcase (substring text 0 1)) (substring text 1)))

;; The line of a program is never cut.
(define (shortened line)
  (if (and (> (string-length line) columns) (not (string-prefix? line "  ")))
      (string-append (string-trim (substring line 0 (- columns 2)) #:left? #f) " …")
      line))
