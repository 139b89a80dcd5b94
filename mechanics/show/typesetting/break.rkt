#lang racket/base
;; Formulas that are wider than the page, cut into lines: sums at their signs, products between
;; their factors, and within parentheses, above or below a fraction bar,
;; before anything is cut outside.
;;
;; Widths are in columns (width.rkt).

(require "width.rkt"
         "../../algebra/notation/tree.rkt"
         (only-in racket/list append* argmax split-at-right))

(provide fit)

;; Columns below which it is no use to cut: nesting is too deep.
(define least-room 12)

;; width : columns, or #f for a line of any length; typeset? : columns of type, not of text
(define (fit t width #:typeset? [typeset? #f])
  (if width (fitted t (max width least-room) (make-meter typeset?)) t))

(define (fitted t width wide)
  (define (inner x [less 0]) (fitted x (max least-room (- width less)) wide))
  (cond [(or (<= (wide t) width) (< width least-room)) t]
        [(sum? t) (fit-sum t width wide)]
        [(product? t) (fit-product t width wide)]
        [(or (parenthesized? t) (fraction? t) (radical? t) (bars? t))
         (with-parts t (for/list ([part (in-list (tree-parts t))]) (inner part 2)))]
        [(power? t) (power (inner (power-base t) (wide (power-exponent t))) (power-exponent t))]
        [(relation? t) (fit-relation t width wide)]
        [(application? t) (fit-application t width wide)]
        [else (fit-container t width wide inner)]))

(define (fit-container t width wide inner)
  (cond [(column? t) (column (for/list ([x (in-list (column-items t))]) (inner x 2)))]
        [(across? t) (across (list (in-lines (across-items t) (- width 2) wide)))]
        [(listing? t)
         (listing (if (of-reports? t)
                      (for/list ([x (in-list (listing-items t))]) (inner x))
                      (list (in-lines (listing-items t) width wide))))]
        [(grid? t)
         (define share (/ (- width 2) (max 1 (length (car (grid-rows t))))))
         (grid (for/list ([row (in-list (grid-rows t))])
                 (for/list ([x (in-list row)]) (fitted x (max least-room (- share 2)) wide))))]
        [(report? t) (report (for/list ([l (in-list (report-lines t))]) (fit-line l width wide)))]
        [else t]))

;; The same tree with other parts, where its fields are its parts.
(define (with-parts t parts) (apply make-prefab-struct (prefab-struct-key t) parts))

;; ---------------------------------------------------------------------------

;; Terms are put on a line as long as they fit.  A line after the first goes on with a sign.
(define (fit-sum t width wide)
  (define rows (packed (sum-terms t) (lambda (x) (+ 3 (wide (term-body x)))) (- width 2)))
  (define (fit-terms terms)
    (for/list ([x (in-list terms)])
      (term (term-negative? x) (fitted (term-body x) (max least-room (- width 5)) wide))))
  (define (first-line terms)
    (if (and (null? (cdr terms)) (not (term-negative? (car terms))))
        (term-body (car terms))
        (sum terms)))
  (define lines
    (cons (first-line (fit-terms (car rows)))
          (for/list ([terms (in-list (map fit-terms (cdr rows)))])
            (continuation (if (term-negative? (car terms)) "−" "+")
                          (first-line (cons (term #f (term-body (car terms))) (cdr terms)))))))
  (in-one lines broken))

;; A single part itself, or (whole parts) of several.
(define (in-one parts whole) (if (null? (cdr parts)) (car parts) (whole parts)))

;; One long factor is cut within, if the others leave it half a line.  Else factors are put on
;; lines as long as they fit; short ones stand beside one that is to be cut.
(define (fit-product t width wide)
  (define factors (product-factors t))
  (define longest (argmax wide factors))
  (define room (- width (- (wide t) (wide longest))))
  (if (and (cut-within? longest width wide) (>= room (floor (/ width 2))))
      (fit-factors factors width wide)
      (broken-product factors width wide)))

(define (broken-product factors width wide)
  (define most (* 3/4 width))
  (define (size f) (+ 1 (if (cut-within? f width wide) (min most (wide f)) (wide f))))
  (define rows (packed factors size (- width 2)))
  (define lines (for/list ([row (in-list rows)]) (fit-factors row (- width 4) wide)))
  (define (continued lines)
    (broken (cons (car lines) (for/list ([l (in-list (cdr lines))]) (continuation "·" l)))))
  (in-one lines continued))

;; A function whose value fits on a line is not cut between its parentheses.
(define (cut-within? factor width wide)
  (not (or (null? (tree-parts factor))
           (and (application? factor) (<= (wide factor) (- width 4))))))

;; Side by side; the longest is cut if they are too wide.
(define (fit-factors factors width wide)
  (define longest (argmax wide factors))
  (define others (- (wide (product factors)) (wide longest)))
  (in-one (for/list ([f (in-list factors)])
            (if (eq? f longest) (fitted f (max least-room (- width others)) wide) f))
          product))

(define (fit-relation t width wide)
  (define left (relation-left t))
  (define right (relation-right t))
  (define sign (relation-sign t))
  (define room (- width (wide left) 3))
  (if (>= room (floor (/ width 2)))
      (relation left sign (fitted right room wide))
      (broken (list (fitted left width wide)
                    (continuation sign (fitted right (- width 4) wide))))))

(define (fit-application t width wide)
  (define f (application-function t))
  (define room (max least-room (- width (wide f) 2)))
  (define arguments (application-arguments t))
  (application f
               (list (if (and (pair? arguments) (null? (cdr arguments)))
                         (fitted (car arguments) room wide)
                         (in-lines arguments room wide)))
               #f))

;; Items with commas, as many on a line as there is room for.  The comma of an item of several
;; lines is at the end of the last.
(define (in-lines items width wide)
  (define with-commas
    (for/list ([x (in-list items)] [left (in-range (length items) 0 -1)])
      (define y (fitted x width wide))
      (if (= left 1) y (with-comma y))))
  (broken (append* (for/list ([xs (in-list (packed with-commas wide width))])
                     (if (and (null? (cdr xs)) (broken? (car xs)))
                         (broken-lines (car xs))
                         (list (in-one xs row)))))))

(define (with-comma t)
  (cond [(broken? t)
         (define-values (before end) (split-at-right (broken-lines t) 1))
         (broken (append before (map with-comma end)))]
        [(continuation? t) (continuation (continuation-sign t) (with-comma (continuation-body t)))]
        [else (row (list t (word ", ")))]))

;; The items in rows as long as there is room.
(define (packed items size width)
  (define-values (rows last total)
    (for/fold ([rows '()] [current '()] [total 0]) ([x (in-list items)])
      (define w (size x))
      (if (or (null? current) (<= (+ total w) width))
          (values rows (cons x current) (+ total w))
          (values (cons (reverse current) rows) (list x) w))))
  (reverse (cons (reverse last) rows)))

;; The parts that do not fit beside the label have lines of their own.
(define (fit-line l width wide)
  (define used (+ (* 2 (report-line-depth l)) (string-length (report-line-label l)) 1))
  (report-line (report-line-depth l) (report-line-label l)
               (for/list ([p (in-list (report-line-parts l))])
                 (fitted p (max least-room (- width used)) wide))))
