#lang racket/base
;; The example that a card shows, with the definitions that it needs, of those that stand before
;; it on the manual's page.
;;
;; It is the first expression of the entry that mentions the name, or uses a definition that does;
;; failing that, an expression of another entry, of the same page if there is one; failing that an
;; error of the entry's, or a definition with the following expression; and in the end the entry's
;; first expression: names that are explained together are shown together.

(require racket/list
         "card.rkt" "page.rkt"
         "../redefinition/binding-forms.rkt" "../redefinition/names-used.rkt")

(provide choose-example)

;; p : the page of the entry e; context : syntax in whose context forms are read
;; -> example or #f
(define (choose-example name e p pages context)
  (or (first-example (entry-lines e) (lambda (l) (about? l name p context)) p context)
      (for/or ([other (in-list (cons p pages))])
        (first-example (page-lines other) (lambda (l) (mentions? l name)) other context))
      (let ([from (memf (lambda (l) (mentions? l name)) (entry-lines e))])
        (and from (make-example from p context)))
      (first-example (entry-lines e) void p context)))

(define (first-example lines fits? p context)
  (define from (memf (lambda (l) (and (shows? l context) (fits? l))) lines))
  (and from (make-example from p context)))

(define (shows? l context) (not (or (line-error? l) (pair? (defined l context)))))

(define (about? l name p context)
  (or (mentions? l name)
      (ormap (lambda (d) (mentions? d name)) (needed-by (list l) p context))))

(define (mentions? l name)
  (let look ([d (line-form l)])
    (cond [(pair? d) (and (not (eq? (car d) 'quote)) (or (look (car d)) (look (cdr d))))]
          [else (eq? d name)])))

;; Drawing shows nothing until the frame is shown: all lines up to that belong to the example.  A
;; line that declares or sets something is followed by an expression that shows it.
;; lines : of the page, from the chosen one on
(define (make-example lines p context)
  (define chosen (car lines))
  (define shown
    (cond [(calls? chosen #rx"[(](plot|graphics)-") (up-to-frame lines)]
          [(calls? chosen #rx"^[(](assume|define|set-[^ ]*!) ") (with-next lines context)]
          [else (list chosen)]))
  (example (page-requires p)
           (map line-text (append (declared-before chosen p) (needed-by shown p context)))
           (map line-text shown)
           (map (lambda (l) (if (equal? (line-run l) (line-form l))
                                (line-text l)
                                (format "~s" (line-run l))))
                shown)))

(define (calls? l pattern) (regexp-match? pattern (format "~s" (line-form l))))

(define (with-next lines context)
  (define next (findf (lambda (l) (shows? l context)) (cdr lines)))
  (cons (car lines) (if next (list next) '())))

(define (up-to-frame lines)
  (define fine (filter (lambda (l) (not (line-error? l))) lines))
  (define-values (drawn others) (splitf-at fine (lambda (l) (pair? (line-form l)))))
  (if (null? others) (list (car lines)) (append drawn (list (car others)))))

;; ---------------------------------------------------------------------------
;; Lines that an expression needs

;; The assumptions of the page before the line, if it asks about them or withdraws them.
(define (declared-before l p)
  (if (calls? l #rx"[(](forget-)?assumptions")
      (filter (lambda (other) (and (calls? other #rx"^[(]assume ") (not (line-error? other))))
              (lines-before l p))
      '()))

(define (lines-before l p) (takef (page-lines p) (lambda (other) (not (eq? other l)))))

;; The definitions of the page that the lines use, in the order of the page: of each name the last
;; one before its use.
(define (needed-by lines p context)
  (define needed
    (for/fold ([needed '()]) ([l (in-list lines)]) (add-needs l needed p context)))
  (filter (lambda (l) (memq l needed)) (remq* lines (page-lines p))))

(define (add-needs l needed p context)
  (define before (definitions-before l p context))
  (for/fold ([needed needed]) ([name (in-list (names-in (in-context l context) before))])
    (define d (hash-ref before name))
    (if (memq d needed) needed (add-needs d (cons d needed) p context))))

;; name -> line
(define (definitions-before l p context)
  (for*/hasheq ([other (in-list (lines-before l p))]
                [name (in-list (defined other context))])
    (values name other)))

;; The names that a line defines.
(define (defined l context)
  (define form (line-form l))
  (define id (defined-by-define (in-context l context)))
  (cond [id (list (syntax-e id))]
        [(and (pair? form) (eq? (car form) 'define-coordinates)) (coordinate-names (cadr form))]
        [else '()]))

;; x, d/dx and dx for each name of the pattern
(define (coordinate-names pattern)
  (for*/list ([name (in-list (remq* '(up down) (flatten pattern)))]
              [defined (in-list '("~a" "d/d~a" "d~a"))])
    (string->symbol (format defined name))))

(define (in-context l context) (datum->syntax context (line-form l)))
