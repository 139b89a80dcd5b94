#lang racket/base
;; The formats of tables, by the names of their files.

(require "../../generic/output-file.rkt")

(provide table-format)

;; -> 'CSV, 'NPY or 'NPZ
(define (table-format who file)
  (format-of-file who file '((#".csv" . CSV) (#".npy" . NPY) (#".npz" . NPZ))
                  ".csv, .npy or .npz"))
