#lang racket/base
;; Messages on tables that cannot be written or read.

(require file/zip
         mechanics
         racket/file
         "../../support/checks.rkt" "../../support/folder.rkt" "../../support/messages.rkt")

(define (reading name content . columns)
  (with-folder (folder)
    (define file (build-path folder name))
    (call-with-output-file file (lambda (out) (write-bytes content out)))
    (parameterize ([current-directory folder])
      (message-of (if (null? columns)
                      (read-table name)
                      (read-table name #:columns columns))))))

(test-case "text that is no table"
  (check-equal? (reading "a.csv" #"t,q\n1,2\n3,four\n")
                (string-append "read-table: expected a number\n  file: a.csv\n  line: 3\n"
                               "  column: 2, q\n  given: \"four\""))
  (check-equal? (reading "a.csv" #"t,q\n1,\n")
                (string-append "read-table: expected a number\n  file: a.csv\n  line: 2\n"
                               "  column: 2, q\n  given: \"\""))
  (check-equal? (reading "a.csv" #"t,q\n1,2\n3\n")
                "read-table: line 3 has 1 field, for 2 columns\n  file: a.csv")
  (check-equal? (reading "a.csv" #"") "read-table: the file is empty\n  file: a.csv")
  (check-equal? (reading "a.csv" #"1,2\n3,4\n")
                (string-append "read-table: the first line has numbers and no names\n"
                               "  file: a.csv\n  line 1: 1,2\n"
                               "  #:names tells the names of columns"))
  (check-equal? (reading "a.csv" #"t,t\n1,2\n")
                "read-table: two columns have one name\n  name: t")
  (check-equal? (reading "a.csv" #"t,q\n1,2\n" 't 't)
                "read-table: two columns have one name\n  name: t")
  (check-equal? (reading "a.csv" #"t,\"q\n1,2\n")
                "read-table: a quotation mark is not closed\n  file: a.csv\n  line: 1")
  (check-equal? (reading "a.csv" #"t,a\"b\"\n")
                (string-append "read-table: a quotation mark stands within a field\n"
                               "  file: a.csv\n  line: 1\n  there: a\"b\""))
  (check-equal? (reading "a.csv" #"time,q\n1,2\n" 'tme)
                (string-append "read-table: the table has no column tme; did you mean time?\n"
                               "  there are: time, q")))

(test-case "files that are no arrays"
  (check-equal? (reading "a.npy" #"t,q\n")
                "read-table: this is no file in NumPy's format\n  file: a.npy")
  (check-equal? (reading "a.npy" #"\223NUMPY\3\0\2\0\0\0{}")
                "read-table: the head of the file is damaged\n  file: a.npy")
  (check-equal? (reading "a.npz" #"PK")
                "read-table: this is no archive of NumPy's arrays\n  file: a.npz")
  (define (zipped name)
    (define out (open-output-bytes))
    (with-folder (folder)
      (display-to-file "1" (build-path folder name))
      (parameterize ([current-directory folder]) (zip->output (list name) out)))
    (get-output-bytes out))
  (check-equal? (reading "a.npz" (zipped "a.txt"))
                "read-table: this is no archive of NumPy's arrays\n  file: a.npz")
  (define (array type shape)
    (define head (string->bytes/utf-8
                  (format "{'descr': ~a, 'fortran_order': False, 'shape': ~a, }\n" type shape)))
    (bytes-append #"\223NUMPY\1\0" (integer->integer-bytes (bytes-length head) 2 #f #f) head))
  (check-equal? (reading "a.npy" (array "'<c16'" "(1,)"))
                "read-table: expected numbers that are real\n  file: a.npy\n  type: '<c16'")
  (check-equal? (reading "a.npy" (array "[('a', '<c16')]" "(1,)"))
                "read-table: expected numbers that are real\n  file: a.npy\n  type: '<c16'")
  (check-regexp-match #rx"^read-table: the table has no column q"
                      (reading "a.npy" (array "'<f8'" "(1,)") 'q))
  (check-equal? (reading "a.npy" (array "'<f8'" "(1, 2, 3)"))
                (string-append "read-table: expected an array of one or two dimensions\n"
                               "  file: a.npy\n  shape: (1 2 3)"))
  (check-equal? (reading "a.npy" (array "[('a', '<f8', (3,))]" "(1,)"))
                (string-append "read-table: expected records whose fields are numbers\n"
                               "  file: a.npy\n  type: [('a', '<f8', (3,))]"))
  (check-regexp-match #rx"^read-table: expected records whose fields are numbers\n"
                      (reading "a.npy" (array "[('a', '<f8'), ('b', '<f8', (3,))]" "(1,)")))
  (check-equal? (reading "a.npy" (array "'<f8'" "(3,)"))
                "read-table: the file ends before its last row\n  file: a.npy"))

(define t (with-folder (folder)
            (define file (build-path folder "a.csv"))
            (write-table '((1 2)) file #:names '(t q))
            (read-table file)))

(says
 [(write-table '((1 2) (3)) "a.csv")
  "write-table: row 1 has 1 number, for 2 columns\n  row: (3)\n  columns: (x0 x1)"]
 [(write-table '((1 2) (3 b)) "a.csv")
  "write-table: expected real numbers\n  row: 1\n  given: the symbol b"]
 [(write-table '((1 2)) "a.csv" #:names '(t))
  "write-table: row 0 has 2 numbers, for 1 column\n  row: (1 2)\n  columns: (t)"]
 [(write-table '() "a.csv") "write-table: there are no rows, and no #:names tell the columns"]
 [(write-table 3 "a.csv")
  "write-table: expected a trajectory, a table or a sequence of states\n  given: the number 3"]
 [(write-table '((1 2)) "a.txt")
  "write-table: the name of the file says no format; it ends in .csv, .npy or .npz\n"
  "  file: \"a.txt\""]
 [(write-table '((1 2)) "a.csv" #:times '(1))
  "write-table: #:times are those at which a trajectory is written\n  given: ((1 2)), a list"]
 [(write-table '((1)) "a.npz" #:names '("m/s"))
  "write-table: the name of a column is that of a file in an NPZ archive\n  name: m/s"]
 [(read-table "no-such-file.csv") "read-table: there is no such file\n  file: no-such-file.csv"]
 [(read-table "a.csv" #:names 't)
  "read-table: there is no such file\n  file: a.csv"]
 [(table-column t 'x)
  "table-column: the table has no column x; did you mean q or t?\n  there are: t, q"]
 [(table-column 3 'x)
  "table-column: expected a table, such as read-table gives\n  given: the number 3"]
 [(table-rows t (up 1 2 3))
  "table-rows: expected a structure of 2 numbers, one for each column\n  given: (up 1 2 3)"])

(test-case "folding takes a procedure and what it begins with"
  (with-folder (folder)
    (define file (build-path folder "a.csv"))
    (write-table t file)
    (check-message
     "read-table: #:fold and #:initial, what it is given with the first row, come together"
     (read-table file #:fold +))
    (check-message
     (string-append "read-table: #:fold is a procedure of a row and what was made of those before\n"
                    "  given: the number 3")
     (read-table file #:fold 3 #:initial 0))))

(test-case "a file that cannot be written whole stays as it was"
  (with-folder (folder)
    (define file (build-path folder "a.csv"))
    (write-table t file)
    (define before (file->string file))
    (check-exn #rx"^write-table: row 1 has 1 number, for 2 columns"
               (lambda () (write-table '((1 2) (3)) file)))
    (check-equal? (file->string file) before)))
