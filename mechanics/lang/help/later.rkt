#lang racket/base
;; Names of the book, and of the programs that go with it, that this library does not have
;; yet: in which section each is met, and on which page where it is printed.
;;
;; Names that are letters of physics before they are procedures (omega, W, H0) are left out.
;; A chapter that is added takes its names out of here; a test watches that.

(provide later-names later-sentence)

;; (section subject name-or-(name page) ...) ...
(define chapters
  '(("3.6" "surfaces of section" pointer-coordinates)
    ("9" "our notation" (helix 521) (derivative-of-sine 511))))

;; section, subject : texts; page : number or #f
(struct place (section subject page))

(define places
  (for*/hasheq ([chapter (in-list chapters)] [entry (in-list (cddr chapter))])
    (define named (if (pair? entry) entry (list entry #f)))
    (values (car named) (place (car chapter) (cadr chapter) (cadr named)))))

(define later-names (sort (hash-keys places) symbol<?))

;; "it belongs to section 3.2 of the book (Poisson brackets, p. 218), which is not here yet",
;; or #f
(define (later-sentence name)
  (define p (hash-ref places name #f))
  (and p (format "it belongs to section ~a of the book (~a~a), which is not here yet"
                 (place-section p) (place-subject p)
                 (if (place-page p) (format ", p. ~a" (place-page p)) ""))))
