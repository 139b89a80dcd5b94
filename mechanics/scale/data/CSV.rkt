#lang racket/base
;; Tables as text, by RFC 4180: a line for each row, commas between fields, quotation marks about
;; a field that has commas, quotation marks or line ends in it; the first line has the names.
;;
;; A number is written with the fewest digits that are read back as the same flonum.  A table to
;; be read may end its lines in any of the three ways, and have semicolons or tabs between fields,
;; as spreadsheets save a table where numbers have decimal commas.

(require racket/flonum
         (only-in racket/list argmax)
         racket/string
         "number-table.rkt"
         "../../error/complain.rkt" "../../error/message-words.rkt")

(provide write-CSV call-reading-CSV read-text-table)

;; ---------------------------------------------------------------------------
;; Writing

;; next : -> flvector or #f
(define (write-CSV names next port)
  (define (write-fields fields)
    (write-string (string-join fields ",") port)
    (write-string "\r\n" port))
  (write-fields (for/list ([name (in-list names)]) (quoted (symbol->string name))))
  (let loop ()
    (define row (next))
    (when row
      (write-fields (for/list ([x (in-flvector row)]) (number->field x)))
      (loop))))

(define (quoted text)
  (if (regexp-match? #rx"[\",\r\n]" text)
      (string-append "\"" (string-replace text "\"" "\"\"") "\"")
      text))

;; Infinities and NaN as NumPy and spreadsheets read them.
(define (number->field x)
  (cond [(fl< (flabs x) +inf.0) (number->string x)]
        [(fl= x +inf.0) "inf"]
        [(fl= x -inf.0) "-inf"]
        [else "nan"]))

;; ---------------------------------------------------------------------------
;; Reading

;; given-names : symbols, where the file has no line of names; wanted : names of columns, or #f
;; (use names next) gets the names that are wanted and a procedure that returns the next row, a
;; list of flonums, or #f -> its value
(define (call-reading-CSV who file given-names wanted use)
  (call-with-input-file* file
    (lambda (in)
      (define separator (call-with-input-file* file separator-of-numbers))
      (define next-record (record-reader who file in separator))
      (define names
        (or given-names
            (let-values ([(fields line) (next-record)])
              (unless fields (complain who "the file is empty\n  file: ~a" file))
              (names-of-fields who file fields separator))))
      (define places
        (if wanted
            (for/list ([name (in-list wanted)]) (place-of who names name))
            (for/list ([_ (in-list names)] [k (in-naturals)]) k)))
      (define (next)
        (define-values (fields line) (next-record))
        (and fields (record->row who file names places (pointed fields separator) line)))
      (use (for/list ([k (in-list places)]) (list-ref names k)) next))))

;; With commas between the fields a number has none; otherwise it may have a comma as its point.
(define (pointed fields separator)
  (if (equal? separator ",")
      fields
      (for/list ([f (in-list fields)]) (string-replace f "," "."))))

;; Separators between quotation marks do not count.
(define (separator-of-numbers in)
  (define line (read-line in 'any))
  (define plain (if (eof-object? line) "" (regexp-replace* #rx"\"[^\"]*\"" line "")))
  (for/first ([s (in-list '(";" "," "\t" ""))] #:when (string-contains? plain s))
    (if (equal? s "") "," s)))

(define (names-of-fields who file fields separator)
  (when (andmap field->number (pointed fields separator))
    (complain who
              (string-append "the first line has numbers and no names"
                             "\n  file: ~a\n  line 1: ~a\n  #:names tells the names of columns")
              file (string-join fields separator)))
  (check-names who (map string-trim fields)))

(define (record->row who file names places fields line)
  (unless (= (length fields) (length names))
    (complain who "line ~a has ~a, for ~a\n  file: ~a" line
              (counted (length fields) "field") (counted (length names) "column") file))
  (define all (list->vector fields))
  (for/list ([k (in-list places)])
    (define field (vector-ref all k))
    (or (field->number field)
        (complain who "expected a number\n  file: ~a\n  line: ~a\n  column: ~a, ~a\n  given: ~s"
                  file line (+ k 1) (list-ref names k) field))))

(define decimal #px"^[ \t]*([+-]?)(?:([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][+-]?[0-9]+)?)[ \t]*$")
(define no-finite-number #px"^(?i:[ \t]*([+-]?)(nan|inf|infinity)[ \t]*)$")

;; -> a flonum, or #f
(define (field->number text)
  (cond [(regexp-match? decimal text)
         (real->double-flonum (string->number (string-trim text) 10 'number-or-false
                                              'decimal-as-inexact))]
        [(regexp-match no-finite-number text)
         => (lambda (m)
              (cond [(regexp-match? #rx"^[nN]" (caddr m)) +nan.0]
                    [(equal? (cadr m) "-") -inf.0]
                    [else +inf.0]))]
        [else #f]))

;; -> a procedure that returns the fields of the next record, or #f, and the number of its first
;; line.  Empty lines are passed over.
(define (record-reader who file in separator)
  (define line 0)
  (define (next-line)
    (set! line (+ line 1))
    (read-line in 'any))
  (define split (field-splitter who file separator))
  (define (next)
    (define text (next-line))
    (define at line)
    (cond [(eof-object? text) (values #f at)]
          [(equal? text "") (next)]
          [else
           (define plain (if (= at 1) (regexp-replace #rx"^\uFEFF" text "") text))
           (values (record-fields who file plain next-line at split) at)]))
  next)

;; A field that is quoted may go on in the next line.
(define (record-fields who file text next-line at split)
  (cond [(even? (for/sum ([c (in-string text)]) (if (eqv? c #\") 1 0))) (split text at)]
        [else
         (define more (next-line))
         (when (eof-object? more)
           (complain who "a quotation mark is not closed\n  file: ~a\n  line: ~a" file at))
         (record-fields who file (string-append text "\n" more) next-line at split)]))

;; -> procedure: text, number of its line -> fields
(define (field-splitter who file separator)
  (define quoted-field (pregexp (format "^\"((?:[^\"]|\"\")*)\"(~a|$)" separator)))
  (define plain-field (pregexp (format "^([^\"~a]*)(~a|$)" separator separator)))
  (define (fields text at)
    (define m (or (regexp-match quoted-field text) (regexp-match plain-field text)))
    (unless m
      (complain who
                (string-append "a quotation mark stands within a field"
                               "\n  file: ~a\n  line: ~a\n  there: ~a")
                file at text))
    (define field (string-replace (cadr m) "\"\"" "\""))
    (if (equal? (caddr m) "")
        (list field)
        (cons field (fields (substring text (string-length (car m))) at))))
  (lambda (text at)
    (if (for/or ([c (in-string text)]) (eqv? c #\"))
        (fields text at)
        (string-split text separator #:trim? #f))))

;; ---------------------------------------------------------------------------
;; Tables of texts, as spreadsheets save them, with commas, semicolons or tabs between the fields

;; -> names of the columns, and rows: pairs of the number of a line and its fields, as many as
;; there are names
(define (read-text-table who file)
  (define separator (call-with-input-file* file separator-of))
  (call-with-input-file* file
    (lambda (in)
      (define next (record-reader who file in separator))
      (define-values (names _line) (next))
      (unless names (complain who "the file is empty\n  file: ~a" file))
      (check-encoding who file 1 names)
      (let loop ([rows '()])
        (define-values (fields line) (next))
        (cond [(not fields) (values (map string-trim names) (reverse rows))]
              [else
               (check-encoding who file line fields)
               (check-width who file line fields (length names))
               (loop (cons (cons line (filled fields (length names))) rows))])))))

(define (check-encoding who file line fields)
  (when (for/or ([field (in-list fields)]) (regexp-match? #rx"\uFFFD" field))
    (complain who "the file is no text in UTF-8; save it as CSV UTF-8\n  file: ~a\n  line: ~a"
              file line)))

;; Fields beyond the columns would be lost, and those before them are perhaps misplaced.
(define (check-width who file line fields n)
  (unless (for/and ([field (in-list fields)] [k (in-naturals)]) (or (< k n) (equal? field "")))
    (complain who
              (string-append "expected ~a, as in the first line; a field with a separator in it "
                             "stands in quotation marks\n  file: ~a\n  line: ~a\n  fields: ~a")
              (counted n "field") file line (length fields))))

;; The commonest of those in the first line
(define (separator-of in)
  (define line (read-line in 'any))
  (define (times separator)
    (if (eof-object? line) 0 (length (regexp-match* (regexp separator) line))))
  (argmax times '("," ";" "\t")))

;; Spreadsheets leave out empty fields at the end.
(define (filled fields n)
  (for/list ([k (in-range n)] [field (in-sequences fields (in-cycle '("")))]) field))
