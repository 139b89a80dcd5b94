#lang racket/base
;; A result in a document: a formula, a table, a picture, or the text that a prompt prints.  It is
;; made when the result comes, for later a frame may be drawn in, and assumptions may change.

(require file/convertible
         "shown-interaction.rkt"
         (only-in "../../algebra/expression/expression.rkt" node? symbolic?)
         "../../algebra/notation/name.rkt" "../../algebra/notation/tree.rkt"
         "../display/result-note.rkt" "../display/result.rkt"
         "../../generic/kind.rkt" "../../generic/notation.rkt" "../../generic/on-demand.rkt"
         "../../generic/up-down.rkt" "../../generic/value-tree.rkt"
         (only-in "../interact/interaction.rkt" interaction?)
         (only-in "../../motion/on-demand.rkt" occurrence? occurrence-event occurrence-time
                  occurrence-state)
         "../../verdict/verdict.rkt")

(require-on-demand ["../../motion/event/event.rkt" event-name])

(provide value->shown
         (struct-out shown-formula) (struct-out shown-table) (struct-out shown-text)
         shown-picture? shown-picture-text shown-picture-svg shown-picture-png shown-picture-pdf)

;; tree : of its notation; notes : trees of the assumptions of its simplification
(struct shown-formula (tree notes) #:transparent)
;; header : strings, or #f; rows : lists of trees
(struct shown-table (header rows) #:transparent)
;; drawn : as file/convertible names a format -> bytes, or #f where the picture cannot be had in it;
;; text : in place of the picture
(struct shown-picture (drawn text))
(struct shown-text (text) #:transparent)

(define text-width 79)

;; see : as in simplified-result (display/result.rkt)
(define (value->shown x [see (seen-once)])
  (cond [(cyclic? x) (shown-text (printed x))]
        [(interaction? x) (interaction->shown x value->shown)]
        [(table-of x) => values]
        [(typeset? x) (formula x see)]
        [(convertible? x) (picture x)]
        [else (shown-text (printed (simplified-result x text-width 'expression see)))]))

(define (printed x)
  (parameterize ([print-as-expression #t]) (format "~v" x)))

;; ---------------------------------------------------------------------------
;; Formulas

(define (typeset? x)
  (cond [(pair? x) (and (list? x) (ormap ours? x) (andmap typeset-element? x))]
        [(vector? x) (for/and ([e (in-vector x)]) (typeset? e))]
        [(symbol? x) (letter? x)]
        [else (or (number? x) (ours? x))]))

;; Among formulas words count as formulas, as in (list (acos 5/8) 'stable), and so do quoted data.
(define (typeset-element? x)
  (or (symbol? x) (typeset? x)
      (and (list? x) (andmap typeset-element? x))))

;; Is it a value of this library?  Quoted data are not, nor are pictures.
(define (ours? x)
  (or (node? x) (has-kind? x) (verdict? x)
      (and (has-notation? x) (not (convertible? x)))
      (and (list? x) (ormap ours? x))))

;; A variable, and not a word such as 'proved.
(define (letter? s) (not (eq? 'word (parts-sort (name-parts s)))))

(define (formula x see)
  (define-values (value grounds) (as-result x see))
  (define tree (value->tree value #t))
  (if (plain? tree)
      (shown-text (plain-text tree))
      (shown-formula tree (map labelled-note grounds))))

;; Simplified as at a prompt, or as it is, if that fails -> value, and assumptions
(define (as-result x [see (seen-once)])
  (with-handlers ([exn:fail? (lambda (e) (values x '()))]) (shown-throughout x see)))

(define (labelled-note n) (row (list (word (string-append (note-label n) " ")) (note->tree n))))

;; ---------------------------------------------------------------------------
;; Tables: of events, and of rows of scalars of one length

(define least-rows 2)

(define (table-of x)
  (and (list? x) (>= (length x) least-rows)
       (cond [(andmap plain-row x) => (lambda (_) (row-table (map plain-row x)))]
             [(andmap opaque? x) (event-table x)]
             [else #f])))

(define (row-table rows)
  (and (apply = (map length rows))
       (shown-table #f (for/list ([r (in-list rows)]) (map scalar->tree r)))))

(define (plain-row x)
  (define items (cond [(vector? x) (vector->list x)]
                      [(structure? x) (vector->list (structure-elements x))]
                      [else x]))
  (and (list? items) (>= (length items) 2) (andmap number? items) items))

(define (scalar->tree x)
  (define-values (value grounds) (as-result x))
  (value->tree value #t))

;; May it be an event?  Only then motion is loaded, to ask.
(define (opaque? x) (not (or (pair? x) (number? x) (string? x) (boolean? x) (symbolic? x))))

(define (event-table xs)
  (and (andmap occurrence? xs)
       (shown-table '("event" "time" "state")
                    (for/list ([o (in-list xs)])
                      (list (word (format "~a" (event-name (occurrence-event o))))
                            (scalar->tree (occurrence-time o))
                            (scalar->tree (occurrence-state o)))))))

;; ---------------------------------------------------------------------------
;; Pictures

(define (shown-picture-svg p) ((shown-picture-drawn p) 'svg-bytes))
(define (shown-picture-png p) ((shown-picture-drawn p) 'png-bytes))
(define (shown-picture-pdf p) ((shown-picture-drawn p) 'pdf-bytes))

;; A value that can draw itself later, as it is now, answers the request 'picture-for-later with a
;; procedure that takes a format; others are tried at once.
(define (picture x)
  (define later (convert x 'picture-for-later #f))
  (define drawn (once-each (or later (lambda (format) (convert x format #f)))))
  (if (or later (drawn 'svg-bytes) (drawn 'png-bytes))
      (shown-picture drawn (printed x))
      (shown-text (printed x))))

;; Calls the procedure once with each argument.
(define (once-each f)
  (define known (make-hasheq))
  (lambda (x) (hash-ref! known x (lambda () (f x)))))
