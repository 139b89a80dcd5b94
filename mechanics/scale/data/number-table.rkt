#lang racket/base
;; Tables of numbers: columns of the same length, each with a name.

(require racket/flonum
         racket/list
         "../../error/complain.rkt" "../../error/spelling.rkt"
         "../../generic/up-down.rkt" "../../generic/value-struct.rkt"
         "../../generic/wrong-argument.rkt"
         "../../numeric/flvector.rkt"
         "../../value/shape.rkt")

(provide number-table? table-column table-rows
         ;; for files of them
         number-table number-table-columns check-names place-of)

;; names : symbols, all different; columns : as many flvectors of one length
(value-struct number-table (names columns)
  #:text table->text
  #:equal-by (lambda (t) (cons (number-table-names t) (number-table-columns t))))

(define a-table "a table, such as read-table gives")
(define (table-names t) (number-table-names t))
(define (table-length t) (flvector-length (car (number-table-columns t))))

(provide-parts number-table? a-table table-names table-length)

(define (table->text t)
  (define n (table-length t))
  (format "table of ~a row~a: ~a" n (if (= n 1) "" "s")
          (apply string-append (add-between (map symbol->string (number-table-names t)) ", "))))

;; The numbers of a column, a list.
(define (table-column t name)
  (check-argument 'table-column number-table? t a-table)
  (define k (place-of 'table-column (number-table-names t) name))
  (flvector->list (list-ref (number-table-columns t) k)))

;; Each row as an up tuple, or as a structure of the shape of `like`.
(define (table-rows t [like #f])
  (check-argument 'table-rows number-table? t a-table)
  (define columns (number-table-columns t))
  (define shape (or like (list->up columns)))
  (unless (= (shape-length shape) (length columns))
    (complain 'table-rows "expected a structure of ~a numbers, one for each column\n  given: ~a"
              (length columns) shape))
  (for/list ([k (in-range (table-length t))])
    (list->structure shape (for/list ([c (in-list columns)]) (flvector-ref c k)))))

(define (list->up xs) (apply up xs))

;; ---------------------------------------------------------------------------
;; Names

;; name : a symbol or a string -> its place among the names
(define (place-of who names name)
  (define wanted (as-symbol who name))
  (or (index-of names wanted)
      (complain who "the table has no column ~a~a" wanted (among wanted names))))

(define (as-symbol who name)
  (cond [(symbol? name) name]
        [(string? name) (string->symbol name)]
        [else (complain-of-argument who "the name of a column, a symbol or a string" name)]))

;; -> the names as symbols
(define (check-names who given)
  (unless (and (pair? given) (list? given))
    (complain-of-argument who "the names of the columns, a list of symbols" given))
  (define names (for/list ([name (in-list given)]) (as-symbol who name)))
  (define twice (check-duplicates names))
  (when twice (complain who "two columns have one name\n  name: ~a" twice))
  names)
